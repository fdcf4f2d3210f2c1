"""Asymmetry and spectrum of the discrete resistance matrix of a ring over the resolution."""

from results import Results, plt, read, save

SOURCE = "the adjoint pair; a spectrum of the body, not of the mesh"
rows = read("data.csv")
steady = [r for r in rows if r["dilation"] == "yes" and r["steps"] == 20]
finest = max(r["D_dx"] for r in steady)
last = next(r for r in steady if r["D_dx"] == finest)

results = Results()
for r in rows:
    print(f"D/dx {r['D_dx']:g}, {r['steps']:g} steps, dilation {r['dilation']}: asymmetry "
          f"{r['asymmetry']:.1e}, "
          f"eigenvalues {r['smallest']:.3f} to {r['largest']:.3f}, coefficient above "
          f"{r['largest']/2:.2f}")
for r in steady:
    results.add(f"asymmetry, D/dx {r['D_dx']:g}", r["asymmetry"], "", 0, "1e-5", SOURCE)
    results.add(f"largest eigenvalue, D/dx {r['D_dx']:g}", r["largest"], "6 pi mu r", 0, "1.5",
                SOURCE)
    if r is not last:
        results.add(f"the same over that at D/dx {finest:g}", r["largest"]/last["largest"], "", 1,
                    "8%", SOURCE)

figure, axes = plt.subplots()
for dilation, style in ("yes", "o-"), ("no", "s--"):
    line = sorted((r["D_dx"], r["largest"], r["smallest"]) for r in rows
                  if r["dilation"] == dilation and r["steps"] == 20)
    name = "dilating" if dilation == "yes" else "locked"
    axes.semilogy([p[0] for p in line], [p[1] for p in line], "C0" + style,
                  label=f"largest, {name} interior")
    axes.semilogy([p[0] for p in line], [p[2] for p in line], "C1" + style,
                  label=f"smallest, {name} interior")
axes.set_xlabel("sphere diameter / mesh cell width")
axes.set_ylabel("eigenvalue / (6 pi mu r)")
axes.legend(loc=(0.35, 0.3))
save(figure, "resistance.png")
results.write()
