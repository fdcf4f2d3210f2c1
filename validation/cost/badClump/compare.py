"""What one bad clump among many costs the others."""

from results import Results, read

results = Results()
rows = {row["factor"]: row for row in read("data.csv")}
alike = rows[1]
for factor, row in rows.items():
    name = "all alike" if factor == 1 else f"one of the stiffness {factor:g}"
    results.report(f"{name}: outer correctors per step", row["correctors"], "-",
                   f"{row['cells']:.0f} red cells")
    results.add(f"{name}: red cells left", row["left"], "-", row["cells"], 0, "the run goes on")
    results.add(f"{name}: steps repeated", row["repeated"], "-", alike["repeated"], 0,
                "as where all are alike")
    if factor != 1:
        ratio = f"{name}: outer correctors over those where all are alike"
        change = row["correctors"]/alike["correctors"]
        if row["cells"] < 1000:
            results.report(ratio, change, "-", "few cells: any change of one changes it")
        else:
            results.add(ratio, change, "-", 1, "5%", "the others pay nothing")
        results.report(f"{name}: processor time over that where all are alike",
                       row["seconds"]/alike["seconds"], "-", "one run after the other")
results.write()
