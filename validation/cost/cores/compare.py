"""Seconds of a step of dense blood over the ranks, each on a core of its own."""

from results import Results, plt, read, save

results = Results()
rows = read("data.csv")
times = {}
for row in rows:
    times.setdefault(row["what"], {})[row["ranks"]] = row["step_s"]
cells = {(row["what"], row["ranks"]): row["cells"] for row in rows}

perCell = {what: times[what][1]/cells[what, 1] for what in ("strong", "weak")}
results.report(f"one of {cells['strong', 1]:g} red cells over one of {cells['weak', 1]:g}, 1 rank",
               perCell["strong"]/perCell["weak"], "-",
               f"{1e3*perCell['strong']:.2f} and {1e3*perCell['weak']:.2f} ms per step")
for ranks, seconds in times["strong"].items():
    results.report(f"{cells['strong', 1]:g} red cells, {ranks:g} ranks: speed-up",
                   times["strong"][1]/seconds, "-", f"a step takes {1e3*seconds:.0f} ms")
for ranks, seconds in times["weak"].items():
    each = f"{cells['weak', 1]:g} red cells per rank, {ranks:g} ranks"
    results.report(f"{each}: time of a step over that of one rank",
                   seconds/times["weak"][1], "-", f"a step takes {1e3*seconds:.0f} ms")
    results.report(f"{each}: the same for separate runs at once",
                   times["separate"][ranks]/times["separate"][1], "-",
                   "they share nothing but the memory of the machine")

figure, axes = plt.subplots(1, 2, figsize=(9, 3.6))
ranks = sorted(times["strong"])
axes[0].plot(ranks, [times["strong"][1]/times["strong"][n] for n in ranks], "o-")
axes[0].plot(ranks, ranks, "--", color="grey", label="ideal")
axes[0].set_yscale("log", base=2)
axes[0].set_yticks(ranks, [f"{n:g}" for n in ranks])
axes[0].set(title=f"speed-up, {cells['strong', 1]:g} red cells")
axes[0].legend()
for what, label in (("weak", "one run"), ("separate", "separate runs")):
    axes[1].plot(ranks, [times[what][n]/times[what][1] for n in ranks], "o-", label=label)
axes[1].set_ylim(bottom=0)
axes[1].set(title=f"step over that on one rank, {cells['weak', 1]:g} red cells each")
axes[1].legend()
for ax in axes:
    ax.set_xscale("log", base=2)
    ax.set_xticks(ranks, [f"{n:g}" for n in ranks])
    ax.set_xlabel("ranks")
save(figure, "result.png")
results.write()
