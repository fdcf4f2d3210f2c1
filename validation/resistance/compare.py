"""Asymmetry and spectrum of discrete resistance matrices over the resolution and the body."""

from results import Results, plt, read, save
from spheres import resistance, stretch

SOURCE = "the adjoint pair; a spectrum of the body, not of the mesh"
rows = read("data.csv")
rings = [r for r in rows if r["body"] == "ring"]
steady = [r for r in rings if r["dilation"] == "yes" and r["steps"] == 20]
finest = max(r["D_dx"] for r in steady)
last = next(r for r in steady if r["D_dx"] == finest)

results = Results()
for r in rows:
    print(f"{r['body']}, D/dx {r['D_dx']:g}, {r['width_r']:g} radii wide, {r['steps']:g} steps, "
          f"dilation {r['dilation']}: asymmetry {r['asymmetry']:.1e}, eigenvalues "
          f"{r['smallest']:.4f} to {r['largest']:.3f}, coefficient above {r['largest']/2:.2f}")
    if r["steps"] > 1:
        name = f"{r['body']}, D/dx {r['D_dx']:g}, width {r['width_r']:g}, dilation {r['dilation']}"
        results.add(f"asymmetry, {name}", r["asymmetry"], "", 0, "1e-5", SOURCE)
        results.add(f"negative eigenvalue, {name}", min(r["smallest"], 0), "6 pi mu r", 0, "0",
                    "a motion in a viscous fluid costs power")
for r in steady:
    results.add(f"largest eigenvalue, D/dx {r['D_dx']:g}", r["largest"], "6 pi mu r", 0, "1.5",
                SOURCE)
    if r is not last:
        results.add(f"the same over that at D/dx {finest:g}", r["largest"]/last["largest"], "", 1,
                    "8%", SOURCE)


def row(body, resolution, width, dilation="yes"):
    """Stretching of a row of spheres; None where the run was left out."""
    return next((r["stretch"] for r in rows if r["body"] == body and r["dilation"] == dilation
                 and (r["D_dx"], r["width_r"]) == (resolution, width)), None)


# The disturbance of a stretched body is that of a dipole of forces: walls at a distance L change
# its resistance by a part of 1/L^3, in boxes that are large beside the body. Their part follows
# from two of these on the coarse mesh
SMALL, BOXES = 14, (20, 26)
for body, n, spacing, fine, known in (
        ("dumbbell", 2, 3, "2%", None), ("triplet", 3, 2.5, "4%", 1.724)):
    centres = [spacing*k for k in range(n)]
    exact = stretch(resistance(centres), centres)
    small, near, far = (row(body, 4, width) for width in (SMALL, *BOXES))
    source = "Gluckman, Pfeffer & Weinbaum 1971, unbounded"
    name = f"{body} stretched"
    if far is None:
        results.add(f"{name}, between walls", small, "6 pi mu r", exact, "8%", source)
        continue
    unbounded = far - (near - far)/((BOXES[1]/BOXES[0])**3 - 1)
    walls = small - unbounded
    results.add(f"{name}, D/dx 4", unbounded, "6 pi mu r", exact, "4%", source, known=known)
    results.add(f"{name}, D/dx 8", row(body, 8, SMALL) - walls, "6 pi mu r", exact, fine, source)
    if row(body, 4, SMALL, "no"):
        results.report(f"{name}, D/dx 4, without dilation", row(body, 4, SMALL, "no") - walls,
                       "6 pi mu r", source)

# That of a fibre is a line of dipoles: 1/L^2
if row("fibre", 4, 28):
    centres = [2.5*k for k in range(8)]
    exact = stretch(resistance(centres), centres)
    near, far = row("fibre", 4, 20), row("fibre", 4, 28)
    results.add("fibre stretched, D/dx 4", far - (near - far)/((28/20)**2 - 1), "6 pi mu r", exact,
                "4%", "the same")

figure, axes = plt.subplots()
for dilation, style in ("yes", "o-"), ("no", "s--"):
    curve = sorted((r["D_dx"], r["largest"], r["smallest"]) for r in rings
                   if r["dilation"] == dilation and r["steps"] == 20)
    name = "dilating" if dilation == "yes" else "locked"
    axes.semilogy([p[0] for p in curve], [p[1] for p in curve], "C0" + style,
                  label=f"largest, {name} interior")
    axes.semilogy([p[0] for p in curve], [p[2] for p in curve], "C1" + style,
                  label=f"smallest, {name} interior")
axes.set_xlabel("sphere diameter / mesh cell width")
axes.set_ylabel("eigenvalue / (6 pi mu r)")
axes.legend(loc=(0.35, 0.3))
save(figure, "resistance.png")
results.write()
