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

channels = {r["channel"]: r for r in read("channels.csv")}
for name, what in (("drag_N", "drag of a cell that is held"), ("Lx_m", "extent along x"),
                   ("Ly_m", "extent along y"), ("Lz_m", "extent along z"),
                   ("volume_m3", "volume")):
    results.add(f"open over periodic channel: {what}",
                channels["open"][name]/channels["periodic"][name], "", 1, "1%",
                "the same flow far from the ends")

# Force, and pressure drop times cross-section, over the drag of a cell that is held. A change of
# the flow that is no jump becomes less with the time step, its second difference with its square
for r in read("leaving.csv"):
    name = f"cell from inlet to outlet, acceleration {r['acceleration_m_s2']:g} m/s2, steps of " \
        f"{r['deltaT_s']:g} s"
    drag = channels["open"]["drag_N"]
    for column, what in (("force_jump_N", "jump of its force"),
                         ("drop_jump_N", "jump of the pressure drop"),
                         ("last_N", "change of the pressure drop when it is removed")):
        results.add(f"{name}: largest {what} over the drag" if "jump" in what
                    else f"{name}: {what} over the drag",
                    abs(r[column])/drag, "", 0, 0.02, "fades before it leaves")
    results.add(f"{name}: largest difference of inflow and outflow over the inflow",
                r["imbalance"], "", 0, 1e-5, "tolerance of the linear solver")

results.write()
