"""Reads the usage blocks in the class descriptions of headers."""
import pathlib
import re

TOP = pathlib.Path(__file__).resolve().parents[3]


class Entry:
    """One entry of a usage block: its path below the block's dictionary, value and comment."""

    def __init__(self, path, value=""):
        self.path, self.value, self.comment = path, value, ""
        self.isDict = self.isList = False

    @property
    def name(self):
        return self.path[-1]

    @property
    def meaning(self):
        return parseComment(self.comment)


def parseComment(comment):
    """unit, default and meaning of an entry's comment"""
    text = re.sub(r"\s+", " ", comment).strip()
    unit = default = ""

    found = re.search(r"\[[^\[\]]*\]", text)
    if found:
        unit = found.group(0)[1:-1]
        rest = text[found.end():].strip()
        text = text[:found.start()].rstrip() + (" " if rest[:1].isalnum() else "") + rest
        text = text.strip().lstrip(":,; ")

    found = re.match(r"(?:(mandatory[^:]*)|default:?\s+([^:]+?))\s*(?::\s*(.*)|$)", text)
    if found:
        default = (found.group(1) or found.group(2)).strip()
        text = found.group(3) or ""
    elif re.search(r"(^|[;,] *)optional\b", text):
        default = "optional"
        text = re.sub(r"[;,]? *optional\b[,;:]? *", " ", text).strip()
        found = re.fullmatch(r"default:? ([^:]*)(?:: *(.*))?", text)
        if found:
            default, text = found.group(1), found.group(2) or ""
    else:
        found = re.fullmatch(r"(.*), default:? ([^,:]+)", text)
        if found:
            text, default = found.groups()
    return unit, default, re.sub(r"\s+", " ", text).strip().strip(";,").strip()


TOKEN = re.compile(r'//[^\n]*|\n|"(?:[^"\\]|\\.)*"|[{}();]|[^\s{}();"]+')


def parseBlock(text):
    """The entries of a usage block, in order; dictionaries come before what is in them."""
    tokens = TOKEN.findall(text)
    entries, path, value = [], [], []
    depth = 0               # of parentheses
    lists = []              # depth at which the entries of a list of dictionaries begin
    latest = None           # the entry that a comment belongs to
    lineEmpty = True
    opened = []             # dictionaries that begin on this line
    early = ""              # a comment between the name of a dictionary and its brace

    for token in tokens:
        if token == "\n":
            if lineEmpty:
                latest = None
            lineEmpty = True
            opened = []
            continue
        if token.startswith("//"):
            if value and depth == 0:
                early += " " + token[2:].strip()
            elif latest:
                latest.comment += " " + token[2:].strip()
            lineEmpty = False
            continue
        lineEmpty = False

        if token == "(" :
            depth += 1
            value.append(token)
        elif token == ")":
            depth -= 1
            if lists and lists[-1] > depth:
                lists.pop()
                path.pop()
                value = []
            else:
                value.append(token)
        elif token == "{":
            if value and value[-1] == "(":
                # a list of dictionaries: name ( { ...
                if not lists or lists[-1] != depth:
                    latest = Entry(path + [value[0]])
                    latest.isDict = latest.isList = True
                    latest.comment, early = early, ""
                    entries.append(latest)
                    path.append(value[0])
                    lists.append(depth)
            elif value:
                latest = Entry(path + [value[0]])
                latest.isDict = True
                latest.comment, early = early, ""
                opened.append(latest)
                entries.append(latest)
                path.append(value[0])
            elif not lists or lists[-1] != depth:
                path.append("")
            value = []
        elif token == "}":
            if not (lists and lists[-1] == depth and path and listed(path, entries)):
                closed = [e for e in entries if e.path == path and e.isDict]
                # a dictionary on one line owns the comment behind it
                if closed and closed[-1] in opened:
                    latest = closed[-1]
                path.pop()
            value = []
        elif token == ";" and depth == (lists[-1] if lists else 0):
            if value:
                latest = Entry(path + [value[0]], " ".join(value[1:]))
                entries.append(latest)
            value = []
        elif token != "...":
            value.append(token)
    return withAlternatives(entries)


def listed(path, entries):
    """Whether the innermost dictionary is an element of a list"""
    return next(e for e in reversed(entries) if e.path == path).isList


def withAlternatives(entries):
    """An entry whose comment says "or: name value; comment" stands for two."""
    result = []
    for entry in entries:
        result.append(entry)
        found = re.search(r"[,;]?\s*\bor:\s+(\w+)\s+([^;]*);(.*)", entry.comment)
        if found:
            entry.comment = entry.comment[:found.start()]
            other = Entry(entry.path[:-1] + [found.group(1)], found.group(2))
            other.comment = found.group(3) or "instead of " + entry.name
            result.append(other)
    return result


def groups(block):
    """A block's entries, one list per dictionary or entry on its top level"""
    result = []
    for entry in block:
        if len(entry.path) == 1 or not result:
            result.append([])
        result[-1].append(entry)
    return result


class Header:
    def __init__(self, path):
        self.path = path
        self.place = str(path.relative_to(TOP))
        text = path.read_text()
        comment = text[:text.find("\\*---", 10)] if "\\*---" in text[10:] else text
        self.name = path.stem
        found = re.search(r'TypeName\("(\w*)"\)', text)
        self.type = found.group(1) if found else path.stem

        found = re.search(r"^Description\n(.*?)(?=^\S|\Z)", comment, re.M | re.S)
        self.description = found.group(1) if found else ""
        found = re.search(r"^ {0,4}Usage\b(.*?)(?=^\S|\Z)", comment, re.M | re.S)
        usage = found.group(1) if found else ""
        self.blocks = [
            parseBlock(block)
            for block in re.findall(r"\\verbatim\n(.*?)\\endverbatim", usage, re.S)
        ]

    def summary(self):
        """The first paragraph before any equation, as one line; its first sentence."""
        text = self.description.split("\\verbatim")[0].split("Usage")[0]
        text = re.sub(r"\s+", " ", text.strip().split("\n\n")[0]).strip()
        text = re.split(r"(?<=[a-z0-9)\]])[.;] (?=[A-Z])", text)[0]
        if len(text) > 110 and ", in postProcessing" in text:
            text = text.split(", in postProcessing")[0]
        if len(text) > 110 and ": " in text[20:]:
            text = text[:20] + text[20:].split(": ")[0]
        text = text.replace("<", "&lt;").replace("\\#", "#").rstrip(".,:;")
        return text if text.endswith(".") else text + "."

    def models(self):
        """(type, entries below the dictionary that has it) for every dictionary of a model"""
        for block in self.blocks:
            roots = [e.path[:-1] for e in block if e.name == "type" and not e.isDict]
            outer = [r for r in roots if not any(r[:n] in roots for n in range(len(r)))]
            for root in outer:
                inside = [
                    e for e in block
                    if e.path[:len(root)] == root and len(e.path) > len(root)
                ]
                type_ = next(e.value for e in inside if e.path == root + ["type"])
                yield type_, root, inside

    def referred(self):
        """Classes that the comments refer to: see name"""
        comments = " ".join(e.comment for block in self.blocks for e in block)
        return set(re.findall(r"\bsee (\w+)", comments))

    def names(self):
        return {name for block in self.blocks for entry in block for name in entry.path}
