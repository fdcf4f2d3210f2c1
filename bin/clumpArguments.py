"""Arguments of the scripts beside this file: argparse, with -help as OpenFOAM programs have it."""

import argparse


def parser(description):
    """An argparse.ArgumentParser that prints the description, which has the usage in it."""
    result = argparse.ArgumentParser(
        description=description, usage=argparse.SUPPRESS, add_help=False, allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("-help", "-h", "--help", action="help", help=argparse.SUPPRESS)
    return result
