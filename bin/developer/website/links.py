"""Links between the pages of a website that lead nowhere."""

import html.parser
import re
import urllib.parse


class Page(html.parser.HTMLParser):
    """Targets of the links and pictures of a page, and the names that a link can have there."""

    def __init__(self, path):
        super().__init__()
        self.targets = []
        self.names = set()
        self.feed(path.read_text())

    def handle_starttag(self, tag, attributes):
        for key, value in attributes:
            if key in ("href", "src") and value:
                self.targets.append(value)
            elif key in ("id", "name"):
                self.names.add(value)


def brokenLinks(folder):
    """A line for each link or picture whose file or heading does not exist."""
    pages = {path.resolve(): Page(path) for path in sorted(folder.rglob("*.html"))}
    found = []
    for path, page in pages.items():
        for target in page.targets:
            if re.match(r"[a-z]+:|//", target):
                continue
            name, heading = urllib.parse.urldefrag(target)
            name = urllib.parse.unquote(name.split("?")[0])
            file = (path.parent/name).resolve() if name else path
            lacking = not file.is_file() or (
                heading and file in pages
                and urllib.parse.unquote(heading) not in pages[file].names)
            if lacking:
                found.append("%s: broken link to %s" % (path.relative_to(folder.resolve()), target))
    return found
