"""The largest eigenvalue of one outer corrector with the correction of the solver lies inside the
unit circle in every domain."""

from results import Results, read

results = Results()
rows = read("data.csv")
for domain in dict.fromkeys(r["domain"] for r in rows):
    own = [r for r in rows if r["domain"] == domain]
    worst = {c: max((r["eigenvalue"] for r in own if r["c"] == c), key=abs)
             for c in dict.fromkeys(r["c"] for r in own)}
    results.add(f"{domain}: largest |eigenvalue|", abs(worst["w min(nu, 1/G)"]), "1", 0, 0.999,
                "unit circle")
    for c in worst:
        if c != "w min(nu, 1/G)":
            print(f"{domain}, c = {c}: {worst[c]:.4f}")
results.write()
