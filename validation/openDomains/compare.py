"""Open patches: the Courant number of an empty channel stays, the level of the pressure does
nothing to a cell."""

from results import Results, read

results = Results()

for r in read("outlets.csv"):
    results.add(f"{r['outlet']}, {r['ranks']:g} ranks: largest Courant number of steps 101 to "
                f"{r['steps']:g} over that at 101",
                r["largest_after"]/r["courant_at_101"], "", 1, "0.01%", "a steady flow")

data = read("data.csv")
for kind, limit, source in ("box", "1e-9", "a fluid at rest"), ("channel", "1e-6",
                                                                "the flow knows differences of "
                                                                "the pressure"):
    rows = [r for r in data if r["kind"] == kind]
    reference = [r for r in rows if r["outlet_Pa"] == 0][:1]
    for r in rows:
        if reference and r["outlet_Pa"] != 0:
            worst = max(abs(r[name]/reference[0][name] - 1)
                        for name in ("Lx_m", "Ly_m", "Lz_m", "volume_m3"))
            results.add(f"{kind}, outlet at {r['outlet_Pa']:g} Pa against 0: extents along x, y "
                        f"and z, and volume", worst, "", 0, limit, source)

results.write()
