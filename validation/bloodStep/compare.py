"""Blood over the time step: viscosity and discharge haematocrit against the smallest step."""

from results import Results, plt, read, save

TODAY = {"tube": 2e-4, "shear": 5e-4}       # steps of the tutorials [s]
CORRECTORS = {"plain": "one corrector, nothing carried", "one": "one corrector",
              "two": "two correctors"}
SHADES = {"plain": "0.6", "one": "C2", "two": "C3"}
KNOWN = {2e-4: 0.849458}        # Ht/Hd, explained in the README
rows = read("data.csv")
results = Results()
figure, axes = plt.subplots(1, 2, figsize=(12, 4))


def spent(row):
    """Milliseconds of one core per clump and simulated millisecond."""
    return row["seconds"]/(row["cells"]*row["end_s"])


for scene in dict.fromkeys(r["scene"] for r in rows):
    runs = [r for r in rows if r["scene"] == scene]
    best = min((r for r in runs if r["sliding"] == "auto" and r["correctors"] == "many"),
               key=lambda r: r["deltaT_s"])
    usual = next((r for r in runs if r["deltaT_s"] == TODAY[scene]), best)
    for r in runs:
        mesh = "mesh slides" if r["sliding"] == "auto" else "mesh at rest"
        name = f"{scene}, {r['deltaT_s']:g} s, {mesh}"
        if r["correctors"] != "many":
            name += f", {CORRECTORS[r['correctors']]}"
        off = r["muRel"]/best["muRel"] - 1
        error = (r["muRel_error"]**2 + best["muRel_error"]**2)**0.5/best["muRel"]
        print(f"{name}: viscosity {r['muRel']:.3f} +- {r['muRel_error']:.3f} ({100*off:+.1f} +- "
              f"{100*error:.1f} %), Ht/Hd {r['HtHd']:.3f}, {r['mean_correctors']:.1f} correctors, "
              f"{spent(r):.1f} ms per cell and ms, {spent(r)/spent(usual):.2f} of today")
        if r is not best:
            if r["correctors"] == "many" and r["sliding"] == "auto":
                results.add(f"{name}: viscosity", r["muRel"], "-", best["muRel"],
                            f"{100*(0.02 + 2*error):.3g}%", "the smallest step, 2 % + 2 errors")
                if scene == "tube":
                    results.add(f"{name}: tube over discharge haematocrit", r["HtHd"], "-",
                                best["HtHd"], "2%", "the smallest step",
                                KNOWN.get(r["deltaT_s"]))
            else:
                results.report(f"{name}: viscosity over that of the smallest step", 1 + off, "-",
                               "")
        results.report(f"{name}: time per cell over that of {TODAY[scene]:g} s",
                       spent(r)/spent(usual), "-", "")
    for mesh, marker in ("auto", "o-"), ("off", "s--"):
        for correctors in "many", *CORRECTORS:
            shade = SHADES.get(correctors, "C0" if scene == "tube" else "C1")
            line = sorted((r["deltaT_s"], r["muRel"]/best["muRel"], r["muRel_error"]/best["muRel"],
                           spent(r)) for r in runs
                          if r["sliding"] == mesh and r["correctors"] == correctors)
            if not line:
                continue
            label = f"{scene}, mesh {'slides' if mesh == 'auto' else 'at rest'}"
            if correctors != "many":
                label += f", {CORRECTORS[correctors]}"
            steps, values, errors, costs = zip(*line)
            axes[0].errorbar(steps, values, errors, fmt=marker, color=shade, label=label)
            axes[1].loglog(steps, costs, marker, color=shade)
axes[0].set_xscale("log")
axes[0].axhspan(0.98, 1.02, color="0.9", zorder=0)
axes[0].set_xlabel("time step [s]")
axes[0].set_ylabel("viscosity over that of the smallest step")
axes[1].legend(*axes[0].get_legend_handles_labels(), fontsize=7, bbox_to_anchor=(1.02, 1),
               loc="upper left")
axes[1].set_xlabel("time step [s]")
axes[1].set_ylabel("ms of one core per cell and simulated ms")
figure.tight_layout()
save(figure, "bloodStep.png")
results.write()
