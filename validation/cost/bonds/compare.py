"""Million sphere-steps per second and microseconds per clump and step: best of the runs."""
import os
import re

from results import Results, read, write_table

rings, steps = (int(word) for word in open("size").read().split())
runs, data = {}, []
for run in (1, 2, 3):
    for row in read(f"cost.{run}"):
        runs.setdefault(row["case"], []).append(float(row["value"]))
    if os.path.exists(f"log.lammps{run}"):
        log = open(f"log.lammps{run}").read()
        # Processor time, as of the others
        seconds = (float(re.search(r"Loop time of (\S+) on 1 procs", log).group(1))
                   *float(re.search(r"(\S+)% CPU use", log).group(1))/100)
        runs.setdefault("LAMMPS, harmonic bonds", []).append(1e-6*rings*10*steps/seconds)
for case, values in runs.items():
    data.extend([case, k + 1, value] for k, value in enumerate(values))
write_table("data.csv", ["case", "run", "value"], data)

out = Results()
speed = max(runs["explicit undamped"])
out.add("explicit, six stiffnesses: time per million sphere-steps", 1e3/speed, "ms", 0,
        round(1e3/30, 1),
        "wanted: 30 million a second")
for case, values in runs.items():
    # Steps of 1 ms, in which the cells of this test turn a twentieth of a radian, take more
    # iterations: data.csv
    if case.startswith("implicit") and float(case.split()[2]) < 1e-3:
        out.add(f"{case}: time per clump and step", min(values), "us", 0, 20, "wanted")

for case, values in runs.items():
    print(f"{case:<32} {min(values) if case.startswith('implicit') else max(values):8.1f}",
          "us per clump and step" if case.startswith("implicit")
          else "million sphere-steps per second")
if "LAMMPS, harmonic bonds" in runs:
    print(f"explicit, six stiffnesses over LAMMPS, one: "
          f"{speed/max(runs['LAMMPS, harmonic bonds']):.2f}")
out.write()
