"""The pages of the website: the Markdown files of the repository, with links to files of the site,
and the pages and parts that are generated."""

import csv
import os
import pathlib
import re
import shutil
import sys

from .formulas import NotAFormula, block, isEquation, sentence

# The contents of the site. NOTE: a new page outside the folders of a README.md needs a place here.
# Pages below a page README.md follow the order of its links.
CONTENTS = {
    "Guide": "doc/install doc/userGuide doc/addCells doc/models/README doc/calibrateClump "
             "doc/mechanicalTests doc/cytometry "
             "doc/python doc/sorting doc/movingMeshes doc/solutes doc/accuracy doc/caseSize "
             "doc/restart doc/limits doc/releases",
    "Tutorials": "tutorials/gallery tutorials/README doc/courses/README",
    "Validation": "validation/README",
    "Theory": "doc/theory doc/howAStepWorks",
    "Development": "CONTRIBUTING doc/layout doc/changeIt doc/extending doc/claims CHANGELOG",
}
THEORY = "doc/theory.md"        # the page whose indented blocks are all formulas
COPIED = ".png", ".gif", ".svg", ".csv"
FOLDED = 60                     # rows of a table of results; a longer one is folded
# Indented blocks, with the blank lines inside, and fenced ones
BLOCK = re.compile(r"((?:^(?: {4}.*|```(?:.*\n)*?```)\n(?:\n(?= {4}))*)+)", re.M)
LINK = re.compile(r"(\]\()([^)\s]+)(\))")
WHOLE_LINK = re.compile(r"\[([^][]*)\]\(([^)\s]+)\)")
FILES = "files"                 # folder of the site with the source files that pages link to


def title(text):
    return re.search(r"^# (.*)", text, re.M).group(1)


def toctree(pages, *options):
    return "\n".join(["", "```{toctree}", *options, ":hidden:", "", *pages, "```", ""])


def cell(text):
    return text.replace("|", "\\|")


class Pages:
    """Writes the pages of the repository top for Sphinx into a folder."""

    def __init__(self, top, folder):
        self.top = top
        self.folder = folder
        self.texts = {path: path.read_text() for path in self.markdown()}
        self.folders = set()    # without a page, that a page links to
        self.number = 0
        sys.path.insert(0, str(top/"validation"/"shared"))
        from results import counted, status
        self.counted, self.status = counted, status

    def markdown(self):
        """The pages, without copies of cases that a run has made."""
        yield from (self.top/name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md"))
        yield from sorted((self.top/"doc").rglob("*.md"))
        for root in (self.top/"tutorials", self.top/"validation"):
            for path in sorted(root.rglob("README.md")):
                above = [p for p in path.parent.parents if root in p.parents]
                if not any((p/"Allrun").exists() for p in above):
                    yield path

    def write(self):
        for path, text in self.texts.items():
            name = path.relative_to(self.top)
            if name.parts[0] == "validation":
                text += self.keptResults(path)
            text = self.formatted(path, text)
            if str(name) == "README.md":
                text += "".join(toctree(pages.split(), ":caption: " + caption)
                                for caption, pages in CONTENTS.items())
            elif name.name == "README.md" and self.below(path):
                text += toctree(self.below(path))
            self.save(name, text)
        gallery = self.top/"tutorials"/"gallery.md"
        self.save(gallery.relative_to(self.top), self.formatted(gallery, self.gallery()))
        for page in sorted(self.folders):
            self.save(page.relative_to(self.top), self.formatted(page, self.listing(page)))

    def save(self, name, text):
        self.number += 1
        file = self.folder/("index.md" if str(name) == "README.md" else name)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def formatted(self, page, text):
        """Links to pages of the site, and formulas as such."""
        result = []
        isTheory = page == self.top/THEORY
        for part in BLOCK.split(text):
            lines = [line for line in part.split("\n") if line]
            if part.startswith("    ") and (isTheory or isEquation(lines)):
                try:
                    result.append(block(lines) + "\n")
                except NotAFormula as error:
                    sys.exit("%s: not a formula: %s (%s)" % (
                        page.relative_to(self.top), lines[0].strip(), error))
            elif part.startswith("```") or part.startswith("    "):
                result.append(part)
            else:
                part = WHOLE_LINK.sub(lambda m: self.toSource(page, m), part)
                part = LINK.sub(lambda m: m[1] + self.target(page, m[2]) + m[3], part)
                result.append(re.sub(r"(?m)^(?!#).+(?:\n(?!#).+)*",
                                     lambda m: sentence(m[0], isTheory), part))
        return "".join(result)

    def toSource(self, page, link):
        """A link to a source file, as HTML that leads to a copy of the file as text."""
        path = pathlib.Path(os.path.normpath(page.parent/link[2]))
        if path in self.texts or not path.is_file() or path.suffix in COPIED:
            return link[0]
        copy = pathlib.Path(FILES, str(path.relative_to(self.top)) + ".txt")
        file = self.folder.parent/"static"/copy
        file.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, file)
        return '<a href="%s">%s</a>' % (os.path.relpath(self.top/copy, page.parent), link[1])

    def target(self, page, link):
        """The link of a page as the site has it."""
        if re.match(r"[a-z]+:|#", link):
            return link
        name, sign, heading = link.partition("#")
        path = pathlib.Path(os.path.normpath(page.parent/name))
        if path.is_dir() and path/"README.md" in self.texts:
            path = path/"README.md"
        elif path.suffix in COPIED:
            copy = self.folder/path.relative_to(self.top)
            if path.is_file() and not copy.exists():
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, copy)
        elif path not in self.texts and path.is_dir():
            path = path/"index.md"
            self.folders.add(path)
        if path == self.top/"README.md":
            path = self.top/"index.md"
        return os.path.relpath(path, page.parent) + sign + heading

    def below(self, index):
        """The pages below the page README.md of a folder, in the order of its links."""
        inside = [p for p in self.texts if index.parent in p.parents and p != index]
        inside = [p for p in inside if not any(
            q.name == "README.md" and q != p and q.parent in p.parents for q in inside)]
        links = [pathlib.Path(os.path.normpath(index.parent/m[1].partition("#")[0]))
                 for m in LINK.findall(self.texts[index])]

        def place(page):
            for number, link in enumerate(links):
                if link == page or page.name == "README.md" and page.parent in (
                        link, *link.parents):
                    return number
            return len(links)
        return [str(p.relative_to(index.parent).with_suffix(""))
                for p in sorted(inside, key=place)]

    def listing(self, page):
        """A page with the list of the files of a folder."""
        files = sorted(p for p in page.parent.iterdir() if p.is_file())
        return "---\norphan: true\n---\n# %s\n\n%s" % (
            page.parent.relative_to(self.top),
            "".join("- [%s](%s)\n" % (p.name, p.name) for p in files))

    def keptResults(self, page):
        """The results that a validation keeps, from its results.csv, and its figures."""
        folder = page.parent
        tables = sorted(folder.glob("*.csv"))
        pictures = [p.name for p in sorted(folder.glob("*.png")) if p.name not in self.texts[page]]
        if not tables and not pictures:
            return ""
        parts = ["", "## Kept results", ""]
        parts += ["![%s](%s)\n" % (name, name) for name in pictures]
        if folder/"results.csv" in tables:
            lines = (folder/"results.csv").read_text().split("\n")
            run = ", ".join(line.lstrip("# ") for line in lines if line.startswith("#"))
            rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
            parts += ["Run of %s: %s." % (run, self.counted(rows)), ""]
            rows = ["| %s | %s | %s | %s | %s | %s |" % (
                cell(row["quantity"]),
                row["value"] + (" " + row["unit"] if row["unit"] not in ("", "-", "1") else ""),
                row["reference"], row["tolerance"], self.status(row), cell(row["source"]))
                for row in rows]
            table = ["| quantity | value | reference | tolerance | status | source |",
                     "|---|---|---|---|---|---|", *rows, ""]
            if len(rows) > FOLDED:
                table = ["<details><summary>%d results</summary>" % len(rows), "", *table,
                         "</details>", ""]
            parts += table
        if tables:
            parts += ["Tables: %s. The columns are explained in [Read](%s)." % (
                ", ".join("[`%s`](%s)" % (t.name, t.name) for t in tables),
                os.path.relpath(self.top/"validation"/"README.md", folder) + "#read"), ""]
        return "\n".join(parts)

    def gallery(self):
        """A page with the picture, the first sentence and the command of each tutorial."""
        index = self.top/"tutorials"/"README.md"
        cards = []
        for name in self.nested(index):
            page = index.parent/(name + ".md")
            if not (page.parent/"Allrun").exists():
                continue
            text = self.texts[page]
            picture = re.search(r"!\[[^]]*\]\(([^)]*)\)", text)
            picture = page.parent/picture[1] if picture else page.parent/"result.png"
            link = "%s.md" % name
            paragraphs = [" ".join(p.split()) for p in text.split("\n\n")[1:]]
            time = next((p[6:] for p in paragraphs if p.startswith("Time: ")), "")
            first = next(p for p in paragraphs if not p.startswith("Time: "))
            first = LINK.sub("]", first.replace("**What it teaches.** ", ""))
            first = re.match(r".*?[a-z0-9)`]\.(?= |$)|.*", first)[0]
            cards.append((not picture.is_file(), "\n\n".join([
                '<div class="card">',
                *(["[![%s](%s)](%s)" % (title(text), os.path.relpath(picture, index.parent), link)]
                  if picture.is_file() else []),
                "**[%s](%s)**" % (title(text), link),
                first + (" *%s*" % (time[0].upper() + time[1:]) if time else ""),
                "    cd tutorials/%s && ./Allrun" % os.path.dirname(name),
                "</div>"])))
        cards.sort(key=lambda card: card[0])
        return "\n\n".join([
            "# Gallery",
            "The tutorials with their pictures and commands; the [course](README.md) has them in "
            "order.", '<div class="gallery">', *(card for _, card in cards), "</div>\n"])

    def nested(self, index):
        for name in self.below(index):
            yield name
            page = index.parent/(name + ".md")
            if page.name == "README.md":
                for inner in self.nested(page):
                    yield os.path.join(os.path.dirname(name), inner)
