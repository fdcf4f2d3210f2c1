"""Which particles the posts displace, against Davis' critical diameter."""

from results import Results, plt, read, save

PERIOD, RADIUS = 20, 5          # of the array of posts [um]
GAP = PERIOD - 2*RADIUS
SOURCE = "Davis 2008: critical diameter 1.4 G e^0.48"

rows = read("data.csv")
results = Results()
figure, axes = plt.subplots(figsize=(9, 4.6))


def path(row):
    """Places in the axes of the rows of posts, mirrored back [um]."""
    slope = row["slope"]
    turn = 1e6*(1 + 1j*slope)/abs(1 + 1j*slope)
    # The coordinate across of a mirrored case is that of the mirrored direction
    return [turn*(p["along_m"] + 1j*p["across_m"]*row["mirror"]) for p in read(row["file"])]


def displaced(places):
    """A displaced particle stays below the posts of its row; the other ones pass above one."""
    posts = int(places[-1].real/PERIOD)
    return all(z.imag < 0 for z in places), posts


modes, paths = {}, {}
for row in rows:
    places = path(row)
    what = f"{row['diameter_um']:g} um" if row["particle"] == "sphere" else row["particle"]
    scene = f"{what}, slope {row['slope']:g}"
    if row["particle"] != "sphere":
        scene += f", {row['speed_mm_s']:g} mm/s"
    settings = []
    if row["step"] != 1:
        settings.append(f"{row['step']:g} of the step")
    if row["fineness"] != 1:
        settings.append(f"{row['fineness']:g} times finer")
    if row["posts"] != 1:
        settings.append("four posts")
    if row["settings"] == "tight":
        settings.append("iterated to round-off")
    if row["mirror"] != 1:
        settings.append("mirrored")
    is_displaced, posts = displaced(places)
    print(f"{', '.join([scene] + settings)}: {'displaced' if is_displaced else 'with the flow'}, "
          f"{posts} posts, ends at {places[-1].real:.1f} {places[-1].imag:.2f} um, "
          f"{row['seconds']:g} s")
    modes[scene, tuple(settings)] = is_displaced
    paths[scene, tuple(settings)] = places
    line = axes.plot([z.real for z in places], [z.imag for z in places],
                     "-" if not settings else "--", lw=1)[0]
    if not settings:
        line.set_label(scene)
    name = ", ".join([scene] + settings)
    if "mirrored" in settings:
        original = paths[scene, tuple(settings[:-1])]
        apart = max(abs(a - b) for a, b in zip(places, original))
        way = abs(places[-1] - places[0])
        if row["settings"] == "tight":
            results.add(f"{name}, largest distance from the path", apart, "um", 0, "1e-6",
                        "the mesh is its own mirror image")
        else:
            results.add(f"{name}, largest distance from the path", 100*apart/way, "%", 0, "2",
                        "couplingTolerance 0.02")
    if row["settings"] == "tight":
        continue
    if row["particle"] == "sphere":
        critical = 1.4*GAP*row["slope"]**0.48
        results.add(f"displaced: {name}", int(is_displaced), "",
                    int(row["diameter_um"] > critical), "0", SOURCE)
    elif settings:
        results.add(f"displaced: {name}", int(is_displaced), "",
                    int(modes[scene, ()]), "0", "the whole step")
    else:
        results.report(f"displaced: {name}", int(is_displaced), "", "")

for column in range(7):
    for line in range(-1, 3):
        axes.add_patch(plt.Circle((PERIOD*column, PERIOD*line), RADIUS, fc="0.7", ec="k"))
axes.set_aspect("equal")
axes.set_xlim(-12, 130)
axes.set_ylim(-16, 36)
axes.set_xlabel("along the rows of posts [um]")
axes.set_ylabel("across them [um]")
axes.legend(fontsize=7, ncol=4, loc="upper center", bbox_to_anchor=(0.5, -0.14))
save(figure, "lateralDisplacement.png")
results.write()
