"""Arguments of the scripts beside this file: argparse, with -help as OpenFOAM programs have it."""

import argparse
import sys


def reported(kind, error, trace):
    """Of what a case does not have (CaseError of clumps.py) a command prints the text alone."""
    if kind.__name__ == "CaseError":
        print(error, file=sys.stderr)
    else:
        sys.__excepthook__(kind, error, trace)


def parser(description):
    """An argparse.ArgumentParser that prints the description, which has the usage in it."""
    sys.excepthook = reported
    result = argparse.ArgumentParser(
        description=description, usage=argparse.SUPPRESS, add_help=False, allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    result.add_argument("-help", "-h", "--help", action="help", help=argparse.SUPPRESS)
    return result
