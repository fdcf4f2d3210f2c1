"""Reads what the code does with entries: their types, defaults and the lists of valid entries."""
import re


def literal(text):
    """A default in the code, as a user would write it"""
    text = text.strip()
    known = {
        "GREAT": "no limit", "VGREAT": "no limit", "true": "yes", "false": "no",
        "Zero": "0", "point::zero": "(0 0 0)", "vector(1, 0, 0)": "(1 0 0)",
        "vector(0, 1, 0)": "(0 1 0)",
    }
    if text in known:
        return known[text]
    if re.fullmatch(r'"\w*"', text):
        return text[1:-1]
    if re.fullmatch(r"[-+*/.()0-9e ]+", text):
        try:
            return "%.4g" % eval(text)
        except (SyntaxError, ZeroDivisionError, TypeError):
            return ""
    return ""


GETTER = re.compile(
    r"\b(\w*[gG]et\w*|readEntry|lookup\w*|direction)(?:<([\w:<>]+)>)?"
    r"\(\s*(?:\w+\s*,\s*)?\"(\w+)\"\s*(?:,\s*([^;]*?))?\)", re.S)
TYPES = {
    "getNumber": "label", "getPositive": "scalar", "getNonNegative": "scalar",
    "getBetween": "scalar", "direction": "vector", "getDict": "dictionary",
    "getPositiveOrDefault": "scalar", "getNonNegativeOrDefault": "scalar",
    "getNumberOrDefault": "label",
    "bool": "switch", "Switch": "switch", "point": "vector", "labelVector": "vector",
    "labelList": "labels", "scalarField": "scalars", "vectorField": "vectors",
}


class Code:
    """What the sources of a folder read"""

    def __init__(self, folder):
        text = ""
        for path in sorted(folder.iterdir()):
            if path.suffix in (".C", ".H"):
                part = path.read_text()
                text += re.sub(r"//[^\n]*", "", re.sub(r"/\*.*?\*/", "", part, flags=re.S))
        self.text = text
        self.types, self.defaults = {}, {}
        for function, template, name, rest in GETTER.findall(text):
            kind = TYPES.get(template) or template or TYPES.get(function, "")
            if "List" in function and kind:
                kind += "s"
            if kind:
                self.types.setdefault(name, kind)
            if function.endswith("OrDefault") and rest:
                value = literal(rest.split(",")[0] if "(" not in rest else rest)
                if value:
                    self.defaults[name] = value

    def read(self):
        """The words in lists of valid entries: checkEntries(dict, {"a", "b"}), base(dict, {"a"})"""
        result = []
        for words in re.findall(r"(?<!withoutRemoved)\(\s*\w+\s*,\s*\{([^{}]*)\}", self.text):
            names = [w.strip() for w in words.split(",")]
            if names and all(re.fullmatch(r'"\w+"', w) for w in names):
                result += [w[1:-1] for w in names]
        return result


def kindOf(entry, code):
    if entry.isDict:
        return "list of dictionaries" if entry.isList else "dictionary"
    kind = next((c.types[entry.name] for c in code if entry.name in c.types), "")
    if kind not in ("", "dictionary"):
        return kind
    value = entry.value
    if re.fullmatch(r"[-+]?[0-9]+", value):
        return "number"
    if re.fullmatch(r"[-+.0-9e]+", value):
        return "scalar"
    if value in ("yes", "no", "on", "off", "true", "false"):
        return "switch"
    if value.startswith("( (") or value.startswith("(("):
        return "vectors" if re.search(r"[0-9]", value) else "list"
    if value.startswith("("):
        return "vector" if len(value.strip("() ").split()) == 3 else "list"
    if value.startswith('"'):
        return "string"
    return "word"
