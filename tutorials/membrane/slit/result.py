"""When the red cell is in the slit, and how it is deformed there."""

from clumps import frames, membranes, table

SLIT = 14, 20           # [um]


ends = []
for time, path in frames():
    x = 1e6*membranes(path)["x"][:, 0]
    ends.append((1e3*time, x.min(), x.max()))
print("front enters at %.0f ms, rear at %.0f ms; front leaves at %.0f ms, rear at %.0f ms" % tuple(
    next((time for time, *x in ends if x[end] > place), float("nan"))
    for place in SLIT for end in (1, 0)))

rows = table(".", "clumpShape")
first = rows[0]
longest = max(rows, key=lambda r: r["Lx"])
print("longest at %.0f ms: %.1f x %.1f x %.1f um" % (
    1e3*longest["time"], *(1e6*longest[c] for c in ("Lx", "Ly", "Lz"))))
for what in "area", "volume":
    values = [r[what]/first[what] - 1 for r in rows]
    print("%s: %.2g to %.2g %%" % (what, 100*min(values), 100*max(values)))
