"""Which particles the posts displace, against Davis' critical diameter."""

from results import Results, plt, read, save

PERIOD, RADIUS = 20, 5          # of the array of posts [um]
GAP = PERIOD - 2*RADIUS
SETTLED = 0.01                  # rise from a post to the next that is one of the step [um]
MODES = {1: "displaced", 0: "with the flow", 0.5: "undecided"}
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
    """1: displaced, 0: with the flow, 0.5: undecided; and the number of posts passed.

    A particle that passes above a post goes with the flow. Paths do not cross: one that is below a
    post not higher than below the post before never comes above one. One that is still rising may.
    """
    posts = [k for k in range(len(places)) if places[-1].real > PERIOD*k >= places[0].real]
    if any(z.imag >= 0 for z in places):
        return 0, len(posts)

    def below(post):
        after = next(k for k, z in enumerate(places) if z.real > PERIOD*post)
        a, b = places[after - 1], places[after]
        return a.imag + (b.imag - a.imag)*(PERIOD*post - a.real)/(b.real - a.real)

    heights = [below(post) for post in posts]
    settled = any(b - a < SETTLED for a, b in zip(heights, heights[1:]))
    return (1 if settled else 0.5), len(posts)


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
    print(f"{', '.join([scene] + settings)}: {MODES[is_displaced]}, "
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
        results.add(f"displaced: {name}", is_displaced, "",
                    int(row["diameter_um"] > critical), "0", SOURCE)
    elif settings:
        results.add(f"displaced: {name}", is_displaced, "",
                    modes[scene, ()], "0", "the whole step")
    else:
        results.report(f"displaced: {name}", is_displaced, "", "")

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
