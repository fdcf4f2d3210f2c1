"""The page: the answer, the results, how it was computed."""
import difflib
import html
import os
import re

import matplotlib
from clumpDomain import typeColour

from clumpReport import answer, plots, space
from clumpReport.figures import Figure, Series, asJson, element
from clumpReport.runLog import NUMBER

HERE = os.path.dirname(os.path.abspath(__file__))
# Folder below share/javascript, and files of the libraries that draw in the browser
LIBRARIES = {"three": ("three.min.js", "examples/js/controls/OrbitControls.js"),
             "dygraphs": ("dygraph.min.js", "dygraph.min.css")}
# Nothing is loaded from elsewhere
POLICY = "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'; " \
         "script-src 'unsafe-inline'"
STABILITY = (
    ("largest Courant number", rf"^Courant Number mean: \S+ max: {NUMBER}", False),
    ("continuity error of a step", rf"sum local = {NUMBER}", True),
    ("deepest overlap of clumps [% of the radius]", rf"^Overlap.* clumps {NUMBER}", False),
    ("deepest overlap with walls [% of the radius]", rf"^Overlap.* walls {NUMBER}", False),
)


def escaped(value):
    return html.escape(str(value))


def readText(path):
    with open(path, errors="replace") as file:
        return file.read()


def libraries():
    """{file: text} of the libraries, with their licences; empty where one of them is absent."""
    result = {}
    for folder in os.environ.get("XDG_DATA_DIRS", "/usr/local/share:/usr/share").split(":"):
        paths = [(name, os.path.join(folder, "javascript", name, file))
                 for name, files in LIBRARIES.items() for file in files]
        if all(os.path.isfile(path) for _, path in paths):
            for name, path in paths:
                licence = os.path.join(folder, "doc", "libjs-" + name, "copyright")
                remark = readText(licence) if os.path.isfile(licence) else ""
                result[path] = remark, readText(path)
            break
    return result


def scripts(found):
    """The libraries and the scripts of the page as elements."""
    parts = []
    for path, (licence, text) in found.items():
        kind = "style" if path.endswith(".css") else "script"
        remark = licence.replace("*/", "* /")
        parts.append(f"<{kind}>/* {os.path.basename(path)}\n{remark}*/\n"
                     + text.replace("</script", "<\\/script") + f"</{kind}>")
    parts += [f"<script>{readText(os.path.join(HERE, name))}</script>"
              for name in ("colours.js", "space.js", "plots.js")]
    return "\n".join(parts)


def grid(rows, head=()):
    """A table of texts."""
    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{escaped(c)}</{tag}>" for c in cells) + "</tr>"

    return '<div class="table"><table>' + (line(head, "th") if head else "") \
        + "".join(line(row, "td") for row in rows) + "</table></div>"


def folded(title, body):
    return f"<details><summary>{escaped(title)}</summary>{body}</details>"


class Page:
    """The page of one run, or of several that are compared."""

    def __init__(self, runs, found):
        self.runs, self.libraries = runs, found
        self.names = [run.name for run in runs]
        if len(set(self.names)) < len(runs):
            self.names = [os.path.relpath(run.case) for run in runs]
        self.types = list(dict.fromkeys(name for run in runs for name in run.allTypes()))
        self.colours = [matplotlib.colors.to_hex(typeColour(k)[1])
                        for k in range(len(self.types))]

    def each(self, function):
        """What a function says of each run, below its name where there are several."""
        parts = [(name, function(run)) for name, run in zip(self.names, self.runs)]
        if len(parts) == 1:
            return parts[0][1]
        return '<div class="views">' + "".join(
            f"<div><h3>{escaped(name)}</h3>{text}</div>" for name, text in parts) + "</div>"

    # The answer

    def state(self, run):
        log = run.log
        kind = "" if log.ended and not log.error else ' class="alert"'
        text = f"<p{kind}>{escaped(log.end())}</p>"
        if run.later():
            text += f'<p class="alert">{escaped(run.later())}</p>'
        if log.error:
            text += f"<pre>{escaped(log.error)}</pre>"
        return text + "".join(f'<p><b>Warning:</b> {escaped(w)}</p>'
                              for w in log.warnings())

    def view(self, run):
        """The view that turns, or the picture; both of the last time."""
        picture = space.picture(run, self.types, self.colours)
        if not picture:
            return "<p>There is no clump in VTK/clumps, which the function object vtkClumps " \
                "writes.</p>"
        if not self.libraries:
            return picture
        scene = space.scene(run, self.types)
        most = len(scene["times"]) - 1
        boxes = "".join(f'<label><input type="checkbox" name="{name}"{on}> {name}</label>'
                        for name, there, on in (("walls", scene["walls"], " checked"),
                                                ("flow", scene["flow"], "")) if there)
        legend = scene["flow"].get("range", "")
        return f'<div class="space">{picture}<div class="controls"><button>play</button>' \
            f'<input type="range" min="0" max="{most}" value="{most}" aria-label="time">' \
            f"<output>{scene['times'][-1]}</output>{boxes}</div>" \
            f'<p class="soft">Drag to turn, wheel to zoom, right button to shift. {legend}</p>' \
            f'<script type="application/json">{asJson(scene)}</script></div>'

    def legend(self):
        """The colours of the types, which the reader can choose."""
        return '<p class="types">Colours: ' + "".join(
            f'<label><input type="color" data-kind="{k}" name="{escaped(name)}" '
            f'value="{self.colours[k]}"> {escaped(name)}</label>'
            for k, name in enumerate(self.types)) + "</p>" if self.types and self.libraries else ""

    def balance(self, run):
        sized = space.size(run)
        head, *rows = answer.balance(run)
        return (f"<p>Domain: {escaped(sized)}.</p>" if sized else "") \
            + (grid(rows, head) if rows else "".join(f"<p>{escaped(text)}.</p>"
                                                     for text in run.log.clumps()))

    def numbers(self):
        """The key numbers, of several runs beside each other."""
        each = [answer.numbers(run, self.types) for run in self.runs]
        words = list(dict.fromkeys(name for found in each for name in found))
        if not words:
            return ""
        several = len(each) > 1
        rows = []
        for name in words:
            values = [found.get(name, (None, ""))[0] for found in each]
            column = next(found[name][1] for found in each if name in found)
            last = answer.difference(*values) if several else values[0].changeText()
            rows.append([name if name == column else f"{name} ({column})",
                         *("" if v is None else v.text() for v in values), last])
        head = ("", *(self.names if several else ("mean ± standard error",)),
                "difference" if several else "change")
        return "<h3>Means over the second half of the run</h3>" + grid(rows, head) \
            + f'<p class="soft">Standard errors from {plots.BLOCKS} blocks of time, or from half ' \
            "as many where that is more; without one there are too few times. " \
            + ("" if several else "Change: of the mean from the third to the last quarter of the "
               "run; where it is several errors, the value is not steady yet.") + "</p>"

    def branches(self, run):
        found = answer.branches(run)
        return grid([[patch, *(v.text() for v in values.values())]
                     for patch, values in found.items()], ("patch", *answer.BRANCH.values())) \
            if found else ""

    def answer(self):
        one = " one" if len(self.runs) == 1 else ""
        branches = self.each(self.branches) if any(map(answer.branches, self.runs)) else ""
        return self.each(self.state) + f'<div class="answer{one}"><div>' \
            f"{self.each(self.view)}{self.legend()}</div><div>" \
            f"<h3>What entered and what came out</h3>{self.each(self.balance)}" \
            + (f"<h3>Branches</h3>{branches}" if branches else "") \
            + self.numbers() + "</div></div>"

    # The results

    def results(self):
        names = list(dict.fromkeys(name for run in self.runs for name in run.tables))
        # Profiles first
        names.sort(key=lambda name: not any(run.tables[name].has("bin", "s") for run in self.runs
                                            if name in run.tables))
        return "".join(self.table(name) for name in names)

    def table(self, name):
        """The plots of a table; those of other than the key columns are folded."""
        runs = [k for k, run in enumerate(self.runs) if name in run.tables]
        tables = [self.runs[k].tables[name] for k in runs]
        first, names = tables[0], [self.names[k] for k in runs]
        title = first.title if first.title == name else f"{first.title} ({name})"
        meanings = "".join(f"<dt>{escaped(columns)}</dt><dd>{escaped(text)}</dd>"
                           for columns, text in first.meanings)
        text = f"<h3>{escaped(title)}</h3>"
        if first.has("event", "patch", "type"):
            return text + self.drawn([plots.passages(tables, self.types, names)])
        none = plots.rounded(first, self.runs[runs[0]].largestRadius)
        arounds = [plots.ranges(self.runs[k].domain.limits) for k in runs]
        columns = [c for c in first.columns if c not in none and c != plots.over(first)
                   and c != "bin"]
        columns = plots.bases(columns, self.types)
        figures = {base: plots.figure(tables, base, of, self.types, arounds, names)
                   for base, of in columns.items()}
        for base, figure in figures.items():
            words = {**answer.WORDS, **answer.PROFILE}.get(base, base)
            figure.title = f"{base}: {words}" if words != base else base
        most = [c for c in columns if c in answer.WORDS or first.has("bin", "s")]
        most = (most + [c for c in columns if c not in most])[:max(len(most), 3)]
        text += f'<p class="soft">{escaped(plots.note(first))}</p>'
        text += self.drawn([figures[c] for c in most])
        rest = [c for c in columns if c not in most]
        if rest:
            text += folded("Further columns: " + ", ".join(rest),
                           self.drawn([figures[c] for c in rest]))
        if none:
            text += '<p class="soft">Not shown, because they are rounding or the error of the ' \
                f'solvers: {", ".join(none)}.</p>'
        return text + (folded("What the columns mean", f"<dl>{meanings}</dl>") if meanings else "")

    def drawn(self, figures):
        live = bool(self.libraries)
        return '<div class="plots">' + "".join(
            element(figure, self.colours, live) for figure in figures) + "</div>"

    # How it was computed

    def computed(self, run):
        effects = [re.match(r" *([^:]+): ([^,]*),? ?(.*)", line)
                   for line in run.log.lines_after("Effects")]
        changes = run.log.changes()
        facts = run.log.programs() + run.log.clumps()
        return "".join(f"<p>{escaped(text)}</p>" for text in facts) \
            + (grid([found.groups() for found in effects if found], ("effect", "state", "reason"))
               if effects else "<p>The log has no table of effects.</p>") \
            + (folded(f"{len(changes)} changes during the run",
                      f"<pre>{escaped(chr(10).join(changes))}</pre>") if changes else "")

    def cost(self, run):
        """Total, per step and per clump, and the time breakdown."""
        log = run.log
        seconds, steps = log.seconds()
        of = ", of the last run" if len(log.runs) > 1 else ""
        lines = [line.split() for line in log.lines_after("Time breakdown")]
        wide = len(lines[0]) if lines else 0
        parts = f"<p>Wall clock time of the parts{of}:</p>" + grid(
            [[" ".join(line[:len(line) - wide + 1])] + line[len(line) - wide + 1:]
             for line in lines]) if lines else ""
        if not steps:
            return ("" if log.quiet else "<p>The log has no complete step.</p>") + parts
        clumps = log.one(r", (\d+) clumps$")
        ranks = log.one(r"^nProcs +: (\d+)$")
        of = " of the first rank" if ranks and int(ranks) > 1 else ""
        text = f"<p>{seconds:.4g} s of processor time{of}, {steps} steps, " \
               f"{seconds/steps:.3g} s per step"
        if clumps and int(clumps):
            text += f", {seconds/steps/int(clumps):.3g} s per step and clump " \
                    f"({clumps} clump{'s'[:int(clumps) > 1]} at the end)"
        return text + ".</p>" + parts

    def stability(self):
        """Courant number, continuity error and overlaps over time."""
        figures, none = [], []
        for title, pattern, log in STABILITY:
            curves = [run.log.per_step(pattern) for run in self.runs]
            if not any(times for times, _ in curves):
                continue
            if "overlap" in title and not any(any(values) for _, values in curves):
                none.append(title.split(" [")[0])
                continue
            several = len(self.runs) > 1
            series = [Series(name if several else "", *c, run=k)
                      for k, (name, c) in enumerate(zip(self.names, curves))]
            lowest = min(v for _, values in curves for v in values)
            figures.append(Figure(title, "time [s]", title, series, log=log and lowest > 0))
        text = "".join(f"<p>{words.capitalize()}: none.</p>" for words in none)
        if any(run.log.quiet for run in self.runs):
            text += "<p>The log of a quiet run has no lines about it.</p>"
        elif not figures and not none:
            text += "<p>The log has no Courant numbers (there is no fluid), and no overlaps.</p>"
        return text + self.drawn(figures)

    def settings(self):
        each = [run.settings() for run in self.runs]
        if len(each) == 1:
            return "".join(folded(name, f"<pre>{escaped(text)}</pre>")
                           for name, text in each[0].items())
        parts = []
        for name in dict.fromkeys(name for files in each for name in files):
            texts = [files.get(name, "").splitlines() for files in each[:2]]
            lines = list(difflib.unified_diff(*texts, *self.names[:2], lineterm="", n=1))
            if lines:
                parts.append(f"<h3>{escaped(name)}</h3><pre>{escaped(chr(10).join(lines))}</pre>")
        return "".join(parts) or "<p>The dictionaries are the same.</p>"

    def text(self, refresh=0):
        """The whole page, which the browser reads again after some seconds if refresh is given."""
        title = escaped(" and ".join(self.names))
        again = f'<meta http-equiv="refresh" content="{refresh}">' if refresh else ""
        several = len(self.runs) > 1
        hint = '<p class="soft">Drag in a plot to zoom, double-click to see all of it.</p>' \
            if self.libraries else ""
        drawn = '<p class="soft">The view and the plots are drawn by three.js and dygraphs (MIT ' \
            "licence), which are in this file.</p>" if self.libraries else ""
        return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">{again}
<title>{title}</title><style>{readText(os.path.join(HERE, "report.css"))}</style></head><body>
<h1>{title}</h1>
{self.answer()}
<h2>Results</h2>{hint}
{self.results()}
<h2>How it was computed</h2>
{'<h3>What differs in the settings</h3>' + self.settings() if several else ''}
{self.each(self.computed)}
{folded("What it cost", self.each(self.cost))}
{folded("How stable it was", self.stability())}
{'' if several else folded("Settings", self.settings())}
{drawn}{scripts(self.libraries) if self.libraries else ''}
</body></html>
"""
