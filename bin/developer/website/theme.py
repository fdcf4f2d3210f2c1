"""Repairs of the theme furo as Debian 12 packages it; another package is left as it is."""

import pathlib
import re

NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.css")


def mendTheme(static):
    """In the folder of static files: the script imports another one, which browsers refuse for a
    page that is opened as a file; the styles import a file from a folder of a server, and the dark
    colours are not bound to the setting of the system."""
    script = static/"scripts"/"furo.js"
    imported = (static/"scripts"/"gumshoe-patched.js")
    text = script.read_text()
    if text.startswith("import Gumshoe") and imported.exists():
        script.write_text(imported.read_text() + text.partition("\n")[2])

    styles = static/"styles"/"furo.css"
    text = styles.read_text()
    if NORMALIZE.exists():
        text = re.sub(r"@import url\(/javascript/normalize\.css[^)]*\);",
                      lambda _: NORMALIZE.read_text(), text)
    dark = re.search(r'body\[data-theme="dark"\] \{([^}]*)\}', text)
    if dark and "prefers-color-scheme" not in text:
        text += ('@media not print { @media (prefers-color-scheme: dark) {\n'
                 'body:not([data-theme="light"]) {%s}\n}}\n' % dark[1])
    styles.write_text(text)
