"""Motion of the red cell in the two media, over the strain of the flow."""
import matplotlib
import numpy as np
from clumps import table

matplotlib.use("Agg")
import matplotlib.pyplot as plt     # noqa: E402

SHEAR = 50              # [1/s]: 0.8 mm/s over 16 um (0.orig/U, system/blockMeshDict)


figure, axes = plt.subplots(1, 2, figsize=(9, 3.5), sharex=True)
for medium in "dextran", "plasma":
    rows = table(medium, "clumpShape")
    strain = [SHEAR*r["time"] for r in rows]
    inclination = np.degrees(np.unwrap([2*r["inclination"] for r in rows])/2)   # of an axis
    node = np.degrees(np.unwrap([r["phase"] for r in rows]))
    print(f"{medium}: the cell turns by {inclination[0] - inclination[-1]:.0f} degrees, "
          f"its membrane by {node[0] - node[-1]:.0f}")
    for axis, angle in zip(axes, (inclination, node)):
        axis.plot(strain, angle, label=medium)

for axis, what in zip(axes, ("long axis of the cell", "node of the membrane")):
    axis.set_xlabel("strain of the flow")
    axis.set_ylabel("angle [degrees]")
    axis.set_title(what)
    axis.grid(alpha=0.3)
axes[0].legend()
figure.tight_layout()
figure.savefig("result.png", dpi=120)
