"""How fast the drug leaves the capsule, and where it is at the end."""
from clumps import table

rows = table(".", "drug")
first, last = rows[0], rows[-1]
start = first["inside"] + first["outside"] + first["out_bottom"]*first["time"]
half = next(r["time"] for r in rows if r["inside"] < 0.5*start)
taken, before = 0, 0
for r in rows:
    taken += r["out_bottom"]*(r["time"] - before)
    before = r["time"]
print(f"half of the drug has left after {1000*half:.1f} ms, "
      f"{100*(1 - last['inside']/start):.1f} % after {1000*last['time']:.0f} ms")
print(f"{100*last['outside']/start:.1f} % is in the fluid, {100*taken/start:.1f} % in the wall; "
      f"with what is inside {100*(last['inside'] + last['outside'] + taken)/start:.6f} %")
