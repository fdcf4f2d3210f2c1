"""Tables of entries, from usage blocks and code."""
import re

from .code import Code, kindOf, literal
from .usage import TOP, groups

# Entries that OpenFOAM itself reads and documents
OPENFOAM = set("""type libs writeControl writeInterval selectionMode fields active log
    consistent momentumPredictor nOuterCorrectors nCorrectors nNonOrthogonalCorrectors pRefCell
    pRefPoint pRefValue solveFlow SIMPLErho transonic frozenFlow ddtCorr turbOnFinalIterOnly
    finalOnLastPimpleIterOnly residualControl outerCorrectorResidualControl correctPhi
    checkMeshCourantNo moveMeshOuterCorrectors PISO PIMPLE SIMPLE solvers relaxationFactors
    functions startFrom startTime stopAt endTime purgeWrite writeFormat writePrecision
    writeCompression timeFormat timePrecision runTimeModifiable""".split())

# What -check and -lacking report
problems, lacking = [], []


def equal(a, b):
    try:
        return abs(float(a) - float(b)) <= 1e-3*abs(float(b))
    except ValueError:
        return a.split()[0] == b.split()[0]


def row(first, path, entry, code, where):
    unit, default, meaning = entry.meaning
    inCode = next((c.defaults[entry.name] for c in code if entry.name in c.defaults), "")
    if default in ("", "optional") and inCode:
        default = inCode
    elif inCode and default and re.fullmatch(r"[-+.0-9e/]+|yes|no", default):
        if not equal(literal(default) or default, inCode):
            problems.append(
                "%s: entry '%s' has the default %s in the code, its comment says %s"
                % (where, entry.name, inCode, default))
    kind = kindOf(entry, code)
    if not entry.isDict:
        missing = []
        if not default or default == "optional":
            missing.append("default")
        if not unit and kind in ("scalar", "vector", "scalars", "vectors"):
            missing.append("unit")
        if not meaning:
            missing.append("meaning")
        if missing:
            lacking.append("%s: %s lacks %s" % (where, ".".join(path), ", ".join(missing)))
    cells = ["`%s`" % first if first else "", "`%s`" % ".".join(path), kind, unit, default, meaning]
    return "| " + " | ".join(c.replace("|", "\\|") for c in cells) + " |"


def codeFor(header):
    """Sources that read a model's entries: its own folder, its siblings' bases"""
    folder = header.path.parent
    result = [Code(folder)]
    if folder.parent.name.endswith("s") and folder.parent.name != "src":
        result += [
            Code(f) for f in sorted(folder.parent.iterdir()) if f.is_dir()
            and f not in (folder, folder.parent/"lnInclude")
            and any("declareRunTimeSelectionTable" in p.read_text() for p in f.glob("*.H"))
        ]
    return result


def link(header):
    return "../../" + header.place


def library(header):
    """Where a model is not in the library of the solver"""
    name = header.path.relative_to(TOP).parts[1]
    return " (`libpaperModels.so`)" if name == "paperModels" else ""


def familyTable(members):
    lines = ["| `type` (mandatory) | what it is |", "|---|---|"]
    table = []
    base = [h for h in members if "declareRunTimeSelectionTable" in h.path.read_text()]
    shared = {}
    for header in base:
        for type_, root, entries in header.models():
            for entry in entries:
                shared.setdefault(tuple(entry.path[len(root):]), entry)
    models = [h for h in members if h not in base and h.blocks]
    words = set().union(*[codeWords(h) for h in base]) if base else set()
    for header in models:
        for _, root, entries in header.models():
            for entry in entries:
                p = tuple(entry.path[len(root):])
                known = getattr(shared.get(p), "comment", "")
                if p[0] in words and len(entry.comment) > len(known):
                    shared[p] = entry
                elif p[0] in words:
                    shared.setdefault(p, entry)

    used = {}                # entries of the base that models show
    for header in models:
        for _, root, entries in header.models():
            for entry in entries:
                used.setdefault(tuple(entry.path[len(root):]), set()).add(header.type)

    common = [
        p for p in shared
        if p[-1] not in OPENFOAM
        and (len(used.get(p, ())) != 1 or p[-1] in words)
    ]
    for p in common:
        code = [c for h in base for c in codeFor(h)]
        table.append(row("", p, shared[p], code, base[0].place))

    for header in models:
        lines.append(
            "| [`%s`](%s)%s | %s |"
            % (
                header.type, link(header), library(header),
                header.summary().replace("|", "\\|")))
        seen = set()
        code = codeFor(header)
        for type_, root, entries in header.models():
            lists = {tuple(e.path) for e in entries if e.isList}
            for entry in entries:
                p = tuple(entry.path[len(root):])
                ofModel = p[-1] in OPENFOAM and tuple(entry.path[:-1]) not in lists
                if p in seen or p in common or ofModel:
                    continue
                seen.add(p)
                table.append(row(header.type, p, entry, code, header.place))
        # blocks that go on with the model's entries, without its type
        for block in header.blocks:
            if not any(e.name == "type" for e in block):
                for entry in block:
                    p = tuple(entry.path)
                    if p not in seen and p not in common and p[-1] not in OPENFOAM:
                        seen.add(p)
                        table.append(
                            row(header.type, p, entry, code, header.place))
    if table:
        lines += [
            "", "| model | entry | kind | unit | default | meaning |", "|---|---|---|---|---|---|"
        ] + table
        if common:
            lines += ["", "A row without a model holds for all of them."]
    return lines


def codeWords(header):
    return set(Code(header.path.parent).read())


def classRows(header):
    """(type of the dictionary, name of the entry below it, entry) of every entry shown"""
    result = []
    outer = None
    for block in header.blocks:
        parts = groups(block)
        flat = len({g[0].name for g in parts}) > 1
        for group in parts:
            if flat or not group[0].isDict:
                result.append(("", (group[0].name,), group[0]))
                continue
            if outer not in (None, group[0].name):
                result.append(("", (group[0].name,), group[0]))
                continue
            outer = group[0].name

            # dictionaries that hold a single one, as types { healthy { ... } }
            cut = 1
            below = [e for e in group if len(e.path) == cut + 1]
            while len(below) == 1 and below[0].isDict and not below[0].isList:
                cut += 1
                below = [e for e in group if len(e.path) == cut + 1]
            type_ = next((e.value for e in below if e.name == "type"), "")
            lists = {tuple(e.path) for e in group if e.isList}
            for entry in group:
                p = tuple(entry.path[cut:])
                inModel = p and p[-1] == "type" and tuple(entry.path[:-1]) not in lists
                if p and not inModel:
                    result.append((type_, p, entry))
    return result


def classTable(header):
    rows = classRows(header)
    typed = any(type_ for type_, _, _ in rows)
    lines = ["Read by [`%s`](%s)." % (header.name, link(header)), ""]
    lines += ["| type " * typed + "| entry | kind | unit | default | meaning |"]
    lines += ["|---" * typed + "|---|---|---|---|---|"]
    code = codeFor(header)
    seen = set()
    for type_, p, entry in rows:
        if (type_, p) not in seen:
            seen.add((type_, p))
            line = row(type_, p, entry, code, header.place)
            lines.append(line if typed else "|" + line.split("|", 2)[2])
    return lines
