"""Formulas of the pages, which are written as plain text, in MathML.

    d_ij = x_j - x_i,   a_ij = (|d_ij|^2 + r_i^2 - r_j^2)/2

The notation: factors stand beside each other, a function has its parenthesis without a blank, ^ and
_ have one token or a group, a dot between two factors is their product, and so is " x " where it is
that of vectors. A fraction a b/c d is (a b/c) d. Three blanks separate two formulas in a line.
"""

import html
import re

GREEK = dict(zip(
    "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi chi "
    "psi omega Phi Omega".split(),
    "αβγδεζηθκλμνξπρστφχψωΦΩ"))
LARGE = {"sum": "∑", "prod": "∏", "int": "∫", "integral": "∫"}
NAMED = {name: name for name in "min max exp cos sin ln div tr var mean".split()}
NAMED.update({"grad": "∇", "inf": "∞"})
SIGNS = {"-": "−", ">=": "≥", "<=": "≤", ">>": "≫", "<<": "≪", "->": "→", "<-": "←", "><": "⟩⟨",
         ".": "⋅", "x": "×"}
CLOSING = {"(": ")", "[": "]", "{": "}", "|": "|", "<": ">"}

TOKEN = re.compile(r"""
      (?P<blank>\ +)
    | (?P<number>\d+(?:\.\d+)?(?:e-?\d+)?)
    | (?P<name>[A-Za-z]+)
    | (?P<low>_(?:(?=[({])|[A-Za-z0-9]+(?:,[a-z]\b|[-+]\d)?'?))
    | (?P<high>\^(?:(?=[({])|-?(?:\d+(?:\.\d+)?|inf|[A-Za-z]\d?)))
    | (?P<post>['"*])
    | (?P<sign>><|<=|>=|>>|<<|->|<-|[-+=:,./<>|(){}\[\]~])
""", re.X)


class NotAFormula(Exception):
    """The text is not in the notation."""


def isDifferential(name):
    return len(name) > 1 and name[0] == "d" and (len(name) == 2 or name[1:] in GREEK)


def isWord(name):
    return len(name) > 1 and name.islower() and not isDifferential(name) and not any(
        name in names for names in (GREEK, LARGE, NAMED, ("laplacian", "sqrt")))


def tag(name, content, attributes=""):
    return "<%s%s>%s</%s>" % (name, attributes, content, name)


def upright(text):
    return tag("mi", text, ' mathvariant="normal"')


def identifier(name):
    if name in GREEK:
        return tag("mi", GREEK[name])
    if name == "laplacian":
        return tag("msup", identifier("grad") + tag("mn", "2"))
    if name in NAMED:
        return upright(NAMED[name])
    if isDifferential(name):
        return tag("mrow", tag("mi", "d") + identifier(name[1:]))
    return tag("mi", name) if len(name) == 1 else upright(name)


def number(text):
    mantissa, _, exponent = text.partition("e")
    if not exponent:
        return tag("mn", text)
    power = tag("msup", tag("mn", "10") + tag("mn", exponent.replace("-", "−")))
    return power if mantissa == "1" else tag(
        "mrow", tag("mn", mantissa) + tag("mo", "⋅") + power)


def operator(sign):
    return tag("mo", html.escape(SIGNS.get(sign, sign)))


def fence(sign):
    return tag("mo", html.escape({"<": "⟨", ">": "⟩"}.get(sign, sign)), ' stretchy="true"')


class Atom:
    """What a fraction takes as a whole; bare is its content without parentheses."""

    def __init__(self, markup, kind="factor", bare=None):
        self.markup = markup
        self.kind = kind
        self.bare = bare or markup


def isKind(item, *kinds):
    return isinstance(item, Atom) and item.kind in kinds


class Reader:
    """Reads a formula from left to right."""

    def __init__(self, text):
        self.tokens = []
        place = 0
        while place < len(text):
            match = TOKEN.match(text, place)
            if not match:
                raise NotAFormula(text[place:])
            self.tokens.append((match.lastgroup, match.group()))
            place = match.end()
        self.place = 0
        self.isSmall = False        # in a subscript or superscript: fractions with a slash

    def peek(self, ahead=0):
        place = self.place + ahead
        return self.tokens[place] if 0 <= place < len(self.tokens) else (None, "")

    def take(self):
        token = self.peek()
        self.place += 1
        return token

    def opens(self):
        """An opening parenthesis, bar or angle bracket is next."""
        kind, text = self.peek()
        before = self.peek(-1)
        if kind != "sign" or text not in CLOSING:
            return False
        if text in "|<":
            after = self.peek(1)[0]
            isEnd = (before[0] in ("name", "number", "low", "high", "post")
                     or before[1] in (")", "]", "|"))
            return not isEnd and after not in (None, "blank")
        return True

    def group(self):
        """Markup between parentheses, and its opening sign."""
        opening = self.take()[1]
        content = self.row(CLOSING[opening])
        if self.take()[1] != CLOSING[opening]:
            raise NotAFormula(opening)
        return content, opening

    def fenced(self):
        content, opening = self.group()
        whole = tag("mrow", fence(opening) + content + fence(CLOSING[opening]))
        return Atom(whole, "group", tag("mrow", content) if opening in "([" else whole)

    def index(self, prefix):
        """Markup of a subscript or superscript, whose sign has been read."""
        if prefix:
            parts = re.findall(r"-|\+|,|'|\d+(?:\.\d+)?|[A-Za-z]+", prefix)
            return tag("mrow", "".join(
                operator(p) if p in "-+,'" else tag("mn", p) if p[0].isdigit()
                else upright(p) if isWord(p) and len(p) > 3 or p in ("max", "true", "old", "mean")
                else identifier(p) if p in GREEK or p in NAMED
                else "".join(tag("mi", c) for c in p)
                for p in parts))
        wasSmall, self.isSmall = self.isSmall, True
        content = self.group()[0]
        self.isSmall = wasSmall
        return tag("mrow", content)

    def scripts(self, base, isLarge=False):
        """Subscripts, superscripts, primes and stars behind a base."""
        low = high = ""
        while True:
            kind, text = self.peek()
            if kind == "number" and text.isdigit() and self.peek(-1)[0] == "name" and not low:
                low = tag("mn", self.take()[1])             # V0, H1
            elif kind == "low":
                low += self.index(self.take()[1][1:])
            elif kind == "high":
                high += self.index(self.take()[1][1:])
            elif kind == "post":
                self.take()
                high += tag("mo", {"'": "′", '"': "″", "*": "∗"}[text])
            else:
                break
        low, high = (tag("mrow", part) if part else "" for part in (low, high))
        isOver = isLarge and "∫" not in base
        if low and high:
            return tag("munderover" if isOver else "msubsup", base + low + high)
        if low:
            return tag("munder" if isOver else "msub", base + low)
        return tag("msup", base + high) if high else base

    def primary(self, isDenominator=False):
        """A number, a symbol, a function with its argument, or a group; each with its scripts."""
        if self.opens():
            atom = self.fenced()
            scripted = self.scripts(atom.markup)
            return atom if scripted == atom.markup else Atom(scripted, "group")
        kind, text = self.take()
        if kind == "number":
            return Atom(self.scripts(number(text)), "number")
        if kind != "name":
            raise NotAFormula(text)
        if text == "sqrt" and self.peek()[1] == "(":
            return Atom(tag("msqrt", self.group()[0]))
        if text in LARGE:
            return Atom(self.scripts(tag("mo", LARGE[text]), True), "large")
        if isWord(text) and (
                self.peek()[0] in (None, "blank") or self.peek()[1] not in ("(", "[")
                and self.peek()[0] == "sign"):
            return Atom(tag("mtext", text), "word")
        kind = ("operator" if text in ("grad", "div", "laplacian") else
                "differential" if isDifferential(text) else "factor")
        limits = text in ("min", "max")
        base = tag("mo", text) if limits else identifier(text)
        markup = self.scripts(base, limits)
        if self.peek()[1] in ("(", "[") and not (isDenominator and kind == "differential"):
            argument = self.fenced()
            markup = tag("mrow", markup + self.scripts(argument.markup))
            kind = "function" if kind == "factor" else kind
        return Atom(markup, kind)

    def factor(self, isDenominator=False):
        """Primaries that are joined by a dot or by nothing."""
        atom = self.primary(isDenominator)
        while True:
            kind, text = self.peek()
            after = self.peek(1)[0]
            if (kind, text) == ("sign", ".") and after not in (None, "blank"):
                self.take()
                nextOne = self.primary(isDenominator)
                atom = Atom(tag("mrow", atom.markup + operator(".") + nextOne.markup),
                            nextOne.kind if nextOne.kind == "operator" else "dot")
            elif kind == "name" and atom.kind != "number":          # d'U
                nextOne = self.primary(isDenominator)
                atom = Atom(tag("mrow", atom.markup + nextOne.markup), "differential")
            else:
                return atom

    def numerator(self, items, withSum):
        """Takes from the end of the items what stands above a line."""
        if not items or not isinstance(items[-1], Atom):
            raise NotAFormula("/")
        parts = [items.pop()]
        kinds = ("factor", "number") + (("large", "group", "function") if withSum else ())
        if withSum or parts[0].kind == "factor":
            while items and isKind(items[-1], *kinds) and parts[0].kind != "number":
                parts.insert(0, items.pop())
        return tag("mrow", parts[0].bare if len(parts) == 1 else
                   "".join(part.markup for part in parts))

    def fraction(self, items):
        """The fraction whose slash has been read: before a sum all its factors stand below."""
        isSum = self.peek()[1] == "sum"
        above = self.numerator(items, isSum)
        if not isSum:
            return Atom(tag("mfrac", above + tag("mrow", self.factor(True).bare)), "fraction")
        below = ""
        while self.peek()[0] in ("name", "number") or self.peek()[1] == " " or self.opens():
            if self.peek()[0] == "blank":
                self.take()
            else:
                below += self.factor().markup
        return Atom(tag("mfrac", above + tag("mrow", below)), "fraction")

    def isCross(self, items):
        """A letter x between vectors is next: before a parenthesis, or between plain symbols."""
        around = [self.peek(ahead) for ahead in (-1, 0, 1, 2)]
        return (around[1] == ("name", "x") and around[0][0] == around[2][0] == "blank"
                and items and isinstance(items[-1], Atom)
                and (around[3][1] == "("
                     or around[3][0] == "name" and "<msub>" not in items[-1].markup))

    def row(self, closing=None):
        """Markup up to the closing sign or the end."""
        items = []          # Atoms, and strings: operators
        while True:
            kind, text = self.peek()
            isClosed = kind == "sign" and text == closing and not (text in "|>" and self.opens())
            if kind is None or isClosed:
                break
            if kind == "blank":
                self.take()
                if len(text) > 1:
                    items.append(tag("mspace", "", ' width="1.5em"'))
            elif self.isCross(items):
                self.take()
                items.append(operator("x"))
            elif kind == "sign" and text == "/" and not self.isSmall:
                self.take()
                items.append(self.fraction(items))
            elif kind in ("name", "number") or self.opens():
                atom = self.factor()
                if atom.kind == "word" and items and isKind(items[-1], "word"):
                    items[-1].markup = items[-1].markup.replace("</mtext>", " ", 1) \
                        + atom.markup.replace("<mtext>", "", 1)
                else:
                    items.append(atom)
            elif kind == "sign" and text not in ")]}":
                self.take()
                items.append(operator(text))
            else:
                raise NotAFormula(text)

        return "".join(self.spaced(items, k) for k in range(len(items)))

    @staticmethod
    def spaced(items, k):
        """Markup of an item, with the space before it and around words."""
        item = items[k]
        if isinstance(item, str):
            return item
        if item.kind == "word":
            before = "\u2002" if k > 0 else ""
            after = "\u2002" if items[k + 1:] and items[k + 1] != operator(",") else ""
            return item.markup.replace("<mtext>", "<mtext>" + before).replace(
                "</mtext>", after + "</mtext>")
        # a thin space between factors
        if k > 0 and isinstance(items[k - 1], Atom) and (
                items[k - 1].kind not in ("word", "operator", "large")
                or items[k - 1].markup.endswith("div</mi>")):
            return tag("mspace", "", ' width="0.17em"') + item.markup
        return item.markup


def letters(text):
    """Letters and digits of a formula as it is written."""
    text = re.sub(r"(\d)e(?=-?\d)", r"\g<1>10", re.sub(r"\b1e(?=-?\d)", "10", text))
    text = text.replace("integral", "int").replace("sqrt", "")
    return re.sub(r"[^A-Za-z0-9]", "", text)


def lettersShown(markup):
    """The same of its markup."""
    names = {v: k for k, v in (*GREEK.items(), *NAMED.items(), *LARGE.items())}
    names.update({"∫": "int", "×": "x"})
    text = re.sub(r"<[^>]*>", "", markup).replace("∇2", "laplacian")
    text = "".join(names.get(c, c) for c in html.unescape(text))
    return re.sub(r"[^A-Za-z0-9]", "", text)


def formula(text):
    """Markup of one formula without parts lost."""
    markup = Reader(text).row()
    if letters(text) != lettersShown(markup):
        raise NotAFormula("%s became %s" % (letters(text), lettersShown(markup)))
    return markup


def block(lines):
    """Markup of the formulas in the lines of an indented block; parts wrap on a narrow screen."""
    rows = []
    for line in "\n".join(lines).replace("\n    /", "/").split("\n"):
        line = re.sub(r" {2,}(?=[-+=] )", " ", line.strip())
        rows.append(tag("div", " ".join(
            tag("math", formula(part), ' displaystyle="true"')
            for part in re.split(r" {3,}|(?<=,) {2,}", line))))
    return '<div class="formulas">\n%s\n</div>' % "\n".join(rows)


def isEquation(lines):
    """An indented block of any page is an equation, and no code: it has an equals sign, a symbol
    of one letter, and nothing that is not in the notation."""
    text = "\n".join(lines)
    if " = " not in text or not re.search(r"\b[A-Za-z](?![A-Za-z0-9])", text):
        return False
    try:
        return bool(block(lines))
    except NotAFormula:
        return False


GROUP = r"\((?:[^()]|\([^()]*\))*\)"
POWER = r"\^(?:-\d/\d|-?(?:\d+(?:\.\d+)?|[A-Za-z]\b)|%s)" % GROUP
SCRIPTS = r"(?:(?:_(?:[A-Za-z0-9]+(?:,[a-z]\b)?'?)|%s)+)" % POWER
LETTERS = "|".join(sorted(GREEK, key=len, reverse=True))

# What a sentence of any page has of formulas
SYMBOL = re.compile(r"""
    (?<!\w)(?P<base>%s|[A-Za-z]{1,2})(?P<scripts>%s)
  | (?<![\w-])(?P<greek>%s)(?![\w-])
  | (?<=[\w)\]|>])(?P<power>%s)
""" % (LETTERS, SCRIPTS, LETTERS, POWER), re.X)

# The same in the theory, where a letter that stands alone is a symbol if it is no unit
THEORY = re.compile(r"""
    (?P<unit>\b(?:(?:N|Pa|mPa)\ s(?:/m)?|N\ m2?|N/m|1/s)\b)
  | (?<!\w)(?P<base>%s|[A-Za-z]{1,2}|sum|int|min|max|div|rAU)(?P<scripts>%s)
  | (?<![\w`])(?P<greek>%s)(?![\w-])
  | (?<=[\w)\]|>])(?P<power>%s|(?<=[)|])_[a-z\d]\b)
  | (?P<sign>[<>]=|\bgrad\b(?=\ \w{1,3}\b|[()])|\bsum\b(?=\ (?:\d|\(?[A-Za-z]+_))|\bsqrt(?=\()
        |\bint\b|(?<=\w\ )x(?=\ \()|(?<=_\w\ )x(?=\ \w_))
  | (?<![\w'])(?<!\d\ (?=[smNVKJWCgx]\b))
        (?P<letter>[b-zB-HJ-Z]|d[a-np-zA-Z]|[aAI](?=\ ?[=<>^)/]))(?!\w|['-]\w)
""" % (LETTERS, SCRIPTS, LETTERS, POWER), re.X)


def scriptsOf(text):
    markup = ""
    for sign, body in re.findall(r"([_^])(%s|-\d/\d|-?[A-Za-z0-9.,]+'?)" % GROUP, text):
        body = body[1:-1] if body.startswith("(") else body
        name = "sub" if sign == "_" else "sup"
        markup += tag(name, GREEK.get(body, body.replace("-", "−")))
    return markup


def sentence(text, isTheory):
    """Text of a page with indices, powers and Greek letters as such, outside code and links."""
    def symbol(match):
        found = match.groupdict()
        if found["base"]:
            base = found["base"]
            shown = NAMED.get(base) or LARGE.get(base) or tag("i", GREEK.get(base, base))
            return shown + scriptsOf(found["scripts"])
        if found["power"]:
            return scriptsOf(found["power"])
        if found.get("unit"):
            return found["unit"]
        if found.get("sign"):
            return {"sqrt": "√", **LARGE, **NAMED, **SIGNS}[found["sign"]]
        return tag("i", GREEK.get(found["greek"]) or found["letter"])

    parts = re.split(r"(`[^`]*`|\]\([^)]*\)|</?a\b[^>]*>|<!--.*?-->)", text, flags=re.S)
    pattern = THEORY if isTheory else SYMBOL
    return "".join(part if k % 2 else pattern.sub(symbol, part) for k, part in enumerate(parts))
