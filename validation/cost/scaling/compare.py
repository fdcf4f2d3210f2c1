"""Messages and waits of a rank and step in dense blood and around one red cell, over the number of
ranks, and what they would take on a large machine with a stated network."""

import math
from results import Results, plt, read, save

# Stated, not measured: an InfiniBand network, its bandwidth shared by the ranks of a node
LATENCY = 2e-6          # of a message [s]
BANDWIDTH = 0.4e9       # of a rank [B/s]

# validation/cost/suspension: processor time of a step per red cell [s], slow machine
CPU = {0.20: 7.7e-3, 0.45: 6.7e-3}
CORRECTORS = {0.20: 4.7, 0.45: 6.8}     # outer ones, of such a step
HERE = 4                                # the same in these runs
PER_RANK = 16           # red cells here
LARGE = 4096, 1e5       # ranks, red cells

results = Results()
rows = read("data.csv")
KINDS = {"yes": "blood", "no": "one red cell"}
MEASURES = {"sent": ("kB", "calls of MPI in a step"), "memory": ("MB", "resident, at most")}


def ranks_of(row):
    return row["haematocrit"], row["blood"], row["ranks"]


counts = {}
for key in sorted({ranks_of(row) for row in rows}):
    own = [row for row in rows if ranks_of(row) == key]
    # A rank at the end of the tree sends once per gather, the others what they pass on, too. Of a
    # scatter it sends nothing; OpenFOAM's reductions are a gather and a scatter
    counts[key] = {
        "messages to neighbours": max(row["messages"] for row in own),
        "sent": max(row["bytes"] for row in own)/1e3,
        "collectives": max(row["collectives"] for row in own),
        "trees": min(row["tree_messages"] for row in own),
        "linear iterations": own[0]["linear_iterations"],
        "memory": max(row["memory_MB"] for row in own),
    }

for (haematocrit, blood, ranks), values in counts.items():
    for name, value in values.items():
        results.report(f"{100*haematocrit:g} %, {KINDS[blood]}, {ranks:g} ranks: {name}",
                       value, *MEASURES.get(name, ("-", "calls of MPI in a step")))


def waits(values):
    """How often all ranks wait for each other."""
    return values["collectives"] + values["trees"]


def predicted(haematocrit, blood):
    """Seconds of a step on the large machine: to compute, for messages, for collectives as often as
    on the most ranks here, and, from more than two ranks, if they grow further with every
    doubling."""
    of = {ranks: values for (h, b, ranks), values in counts.items()
          if (h, b) == (haematocrit, blood)}
    ranks, cells = LARGE
    last = max(of)
    surface = (cells/ranks/PER_RANK)**(2/3)
    steps = CORRECTORS[haematocrit]/HERE
    messages = of[last]["messages to neighbours"]*LATENCY \
        + 1e3*of[last]["sent"]*surface/BANDWIDTH
    # Along a tree of the ranks and back
    wait = 2*math.log2(ranks)*LATENCY
    result = [cells/ranks*CPU[haematocrit], steps*messages, steps*waits(of[last])*wait]
    if last > 2:
        growth = max((waits(of[last]) - waits(of[2]))/math.log2(last/2), 0)
        result.append(steps*(waits(of[last]) + growth*math.log2(ranks/last))*wait)
    return result


for haematocrit in sorted(CPU):
    for name, value in zip(("computing", "messages", "collectives, as many as measured",
                            "collectives, growing with every doubling"),
                           predicted(haematocrit, "yes")):
        results.report(
            f"predicted for 1e5 red cells on 4096 ranks, {100*haematocrit:g} %: {name}",
            1e3*value, "ms", f"latency {1e6*LATENCY:g} us, {BANDWIDTH/1e9:g} GB/s a rank")

figure, axes = plt.subplots(1, 2, figsize=(9, 3.6))
for (haematocrit, blood) in sorted({key[:2] for key in counts}):
    at = sorted(key[2] for key in counts if key[:2] == (haematocrit, blood))
    style = "o-" if blood == "yes" else "o--"
    label = ("" if blood == "yes" else "one cell, box of ") + f"{100*haematocrit:g} %"
    for ax, value in zip(axes, (waits, lambda v: v["messages to neighbours"])):
        ax.plot(at, [value(counts[haematocrit, blood, n]) for n in at], style, label=label)
for ax, title in zip(axes, ("collectives of a step", "messages of the busiest rank to neighbours")):
    ax.set_xscale("log", base=2)
    ax.set_ylim(bottom=0)
    ax.set(xlabel="ranks", title=title)
axes[0].legend(fontsize=8)
save(figure, "result.png")
results.write()
