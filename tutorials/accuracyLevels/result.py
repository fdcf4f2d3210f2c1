"""Angle by which the red cell has turned, its difference to that of the finest level, the cost."""
from clumps import seconds_of_steps, table


def angle(level):
    """Integral of the rotation over time [rad]."""
    rows = table(level, "clumpShape")
    total, time, rate = 0, 0, rows[0]["omegaz"]
    for row in rows:
        total += (row["time"] - time)*(row["omegaz"] + rate)/2
        time, rate = row["time"], row["omegaz"]
    return -total


fine = angle("fine")
print("level      steps   rotation   difference   seconds")
for level in "draft", "standard", "fine":
    seconds = seconds_of_steps(level)
    difference = 100*(angle(level)/fine - 1)
    print(f"{level:10s} {len(seconds):5d} {angle(level):8.3f} rad {difference:9.1f} % "
          f"{sum(seconds):9.0f}")
