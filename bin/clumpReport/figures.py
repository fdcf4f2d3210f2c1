"""Plots of the page: as data that its script draws, or as still pictures without that."""
import base64
import html
import io
import json
import math
from dataclasses import dataclass, field

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

MOST_POINTS = 1000      # of a curve
DASHES = "-", "--", ":", "-."


@dataclass
class Series:
    """A curve with the band between low and high, where it has one; kind: number of the type of
    clumps, None where it is of none; run: number of the run."""
    name: str
    x: list
    y: list
    low: list = None
    high: list = None
    kind: int = None
    run: int = 0

    def scaled(self, ofX, ofY):
        """Thinned out, with factors; a list of pairs or quadruples."""
        columns = [np.asarray(self.x, dtype=float)*ofX, np.asarray(self.y, dtype=float)*ofY]
        if self.low is not None:
            columns += [np.asarray(values, dtype=float)*ofY for values in (self.low, self.high)]
        step = -(-len(columns[0])//MOST_POINTS) or 1
        return np.stack(columns, axis=1)[::step]


@dataclass
class Figure:
    title: str
    x: str                  # names of the axes with their units
    y: str
    series: list = field(default_factory=list)
    factors: tuple = (1, 1)     # to these units
    log: bool = False
    steps: bool = False
    zero: bool = False          # whether y begins there
    limits: tuple = None        # of y, in these units


def embedded(figure):
    """An img element with a figure of matplotlib in it."""
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=90, bbox_inches="tight")
    plt.close(figure)
    data = base64.b64encode(buffer.getvalue()).decode()
    return f'<img alt="" src="data:image/png;base64,{data}">'


def still(figure, colours):
    """A picture of a plot; colours: of the types."""
    drawn, ax = plt.subplots(figsize=(4.6, 2.6))
    for k, series in enumerate(figure.series):
        data = series.scaled(*figure.factors)
        colour = colours[series.kind] if series.kind is not None else f"C{k}"
        ax.plot(data[:, 0], data[:, 1], DASHES[series.run % len(DASHES)], color=colour, lw=1.2,
                label=series.name or None, drawstyle="steps-post" if figure.steps else "default")
        if data.shape[1] > 2:
            ax.fill_between(data[:, 0], data[:, 2], data[:, 3], color=colour, alpha=0.25, lw=0)
    if figure.log:
        ax.set_yscale("log")
    if figure.zero:
        ax.set_ylim(bottom=0)
    if figure.limits:
        ax.set_ylim(*figure.limits)
    ax.set(xlabel=figure.x, ylabel=figure.y)
    if len(figure.series) > 1:
        ax.legend(fontsize=7)
    return embedded(drawn)


def number(value):
    return float(f"{value:.6g}") if math.isfinite(value) else None


def data(figure):
    """What the script of the page needs to draw a plot."""
    series = [{"name": s.name or figure.y, "kind": s.kind, "run": s.run,
               "points": [[number(v) for v in row] for row in s.scaled(*figure.factors)]}
              for s in figure.series]
    return {"x": figure.x, "y": figure.y, "log": figure.log, "steps": figure.steps,
            "zero": figure.zero, "limits": figure.limits, "series": series}


def asJson(value):
    """For a script element."""
    return json.dumps(value, separators=(",", ":")).replace("</", "<\\/")


def element(figure, colours, live):
    """A figure element with a plot."""
    body = f'<script type="application/json">{asJson(data(figure))}</script>' if live \
        else still(figure, colours)
    return f'<figure class="plot"><figcaption>{html.escape(figure.title)}</figcaption>' \
           f'{body}</figure>'
