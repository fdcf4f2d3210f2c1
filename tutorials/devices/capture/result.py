"""At which stress at the wall the red cells leave, and how far they come."""

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import table

RATE = 100/1.0          # of the shear rate [1/s2]
VISCOSITY = 1.2e-3      # [Pa s]

figure, axes = plt.subplots(figsize=(6, 3.6))
for kind, colour in (("healthy", "firebrick"), ("sickle", "0.3")):
    rows = [row for row in table(".", "clumpForce") if row["type"] == kind]
    stress = [1e3*VISCOSITY*RATE*row["time"] for row in rows]
    way = [1e6*(row["x"] - rows[0]["x"]) for row in rows]
    leaves = next((s for s, row in zip(stress, rows) if row["Ux"] > 2e-6), None)
    print("%s: %s; way %.1f um, largest force along the wall %.1f pN" % (
        kind, "held" if leaves is None else "slides from %.0f mPa on" % leaves, way[-1],
        1e12*max(row["Fx"] for row in rows)))
    axes.plot(stress, way, color=colour, label=kind)
axes.set_xlabel("shear stress at the wall [mPa]")
axes.set_ylabel("way [um]")
axes.grid(alpha=0.3)
axes.legend(frameon=False)
figure.tight_layout()
figure.savefig("result.png", dpi=120)
