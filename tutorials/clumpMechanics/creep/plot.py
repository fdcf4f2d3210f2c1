"""Length of the red cell and its normalised creep compliance (Eq. 14 of the paper) over time."""
from clumps import table
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

DIAMETER = 7.6e-6      # at rest

shape = table(".", "clumpShape")
time = [row["time"] for row in shape]
length = [row["Lx"] for row in shape]
final = length[-1]
compliance = [(final - x)/(final - DIAMETER) for x in length]

figure, axes = plt.subplots(figsize=(5, 3.6))
axes.plot(time, compliance)
axes.set(xlabel="time (s)", ylabel="normalised creep compliance")
figure.tight_layout()
figure.savefig("result.png", dpi=120)

half = next(t for t, c in zip(time, compliance) if c < 0.5)
print(f"length at the end {1e6*final:.3f} um, half of the elongation after {1e3*half:.0f} ms")
print("Picture: result.png")
