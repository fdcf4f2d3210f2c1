"""A white cell with a nucleus into a slit of half its width."""

from results import Results, plt, read, save

results = Results()
(r,) = read("data.csv")
results.add("nucleus in the slit at the end", float(r["nucleusEnters_ms"] > 0), "-", 1, 0,
            "it is pressed in")
results.add("volume of the cell", r["cellVolume"], "-", 1, 1e-6, "volume at rest")
results.add("volume of the nucleus", r["nucleusVolume"], "-", 1, 1e-6, "volume at rest")
results.add("nodes of the nucleus inside the cell, least part", r["inside"], "-", 1, 0,
            "all of them")
results.add("height of the nucleus in the slit", r["widest_um"], "um", 3.6, 0.4,
            "at rest; the slit has 4 um")
results.report("front of the cell to nucleus in the slit", r["nucleusEnters_ms"] - r["enters_ms"],
               "ms", "%g Pa, %.1f outer correctors, %d steps repeated, %.0f s" % (
                   r["pressure_Pa"], r["correctors"], r["repeated"], r["seconds"]))

rows = read("history.csv")
figure, axes = plt.subplots(figsize=(5, 3.6))
for part, colour in (("cell", "firebrick"), ("nucleus", "navy")):
    for end in ("Rear", "Front"):
        axes.plot([1e3*h["time_s"] for h in rows], [1e6*h[part + end + "_m"] for h in rows],
                  color=colour, lw=1)
axes.axhspan(14, 20, color="0.9")
axes.set(xlabel="time [ms]", ylabel="ends of cell and nucleus [um]")
save(figure, "whiteCell.png")
results.write()
