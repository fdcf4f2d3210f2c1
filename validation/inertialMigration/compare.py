"""Drift of a sphere across ducts and tubes, the places where it stays, and the lift on it."""

import math

import numpy as np
from results import Results, plt, read, save

H, MU = 50e-6, 1e-3     # of Allrun
rows = read("data.csv")
results = Results()

# Misses that the README explains: (size, cells): place in a tube [R]
KNOWN = {(0.15, 27): 0.566098, (0.2, 20): 0.531513, (0.2, 30): 0.543702}
KNOWN_LIFT = {50: 1.86693}      # Re: lift over drift


def path(r):
    """Time, place along the flow and distance from the middle, in H/U and H."""
    t, x, y = (np.array([p[k] for p in read(r["file"])]) for k in ("t_s", "x_m", "y_m"))
    middle = 0.5 if r["shape"] == "duct" else 0
    return t*r["U_m_s"]/H, x/H, y/H - middle


def drift(r):
    """Away from the middle, over the largest velocity of the flow, in the second half of a run."""
    t, _, y = path(r)
    half = np.searchsorted(t, 0.5*t[-1])
    return (y[-1] - y[half])/(t[-1] - t[half])


def select(**values):
    return [r for r in rows if all(r[k] == v for k, v in values.items())]


short = [r for r in rows if r["end"] < 10 and r["Re"] > 1 and r["held"] == "no"]


def same(r):
    """The run at a Courant number of 1 with walls at rest and a mesh that slides."""
    keys = "shape", "size", "Re", "cells"
    return next(s for s in short if (s["sliding"], s["scheme"]) == ("auto", "Euler")
                and (s["Courant"], s["frame"]) == (1, 0) and all(s[k] == r[k] for k in keys))


base = same({"shape": "duct", "size": 0.22, "Re": 50, "cells": 24})
reference = drift(base)
results.add("drift by clumpMigration", read(base["file"])[-1]["drift_m_s"]/base["U_m_s"], "U",
            reference, "5%", "difference of the places")
for r in short:
    value = drift(r)
    name = (f"drift, {r['shape']}, {r['size']:g} H, Re {r['Re']:g}, walls at {r['frame']:g} U, "
            f"Courant {r['Courant']:g}, {r['size']*r['cells']:.1f} cells"
            + ("" if r["sliding"] == "auto" else ", mesh at rest")
            + ("" if r["scheme"] == "Euler" else f", {r['scheme']}"))
    print(f"{name}: {value:.5f} U")
    if r["shape"] == "plates":
        inside = r["from"] < 0.3
        results.add(f"{name}, from {r['from']:g} H: goes outwards", int(value > 0), "", int(inside),
                    "0", "stays at 0.3 H: Vasseur and Cox 1976; Asmolov et al. 2018")
    elif r is same(r) or r["scheme"] != "Euler":
        results.report(name, value, "U", "")
    elif r["sliding"] == "auto":
        results.add(name, value, "U", drift(same(r)), "5%", "walls at rest, Courant number 1")
    else:
        results.add(name, value, "U", drift(same(r)), "10%", "the mesh that slides")
for r in select(Re=0.02):
    results.add(f"drift, Re {r['Re']:g}, convection {r['convection']}", drift(r), "U", 0, "2e-5",
                "creeping flow is reversible")
for r in [r for r in rows if r["end"] > 10]:
    t, x, y = path(r)
    late = y[t > 0.9*t[-1]]
    what = f"{r['shape']}, {r['size']:g} H, Re {r['Re']:g}, from {r['from']:g} H"
    print(f"{what}: stays at {late.mean():.4f} H, moves by {late[-1] - late[0]:.1e} H at the end")
    if r["shape"] == "duct":
        results.add(f"place, {what}", 2*late.mean(), "H/2", 0.55, "0.05",
                    "Di Carlo 2009, Chun and Ladd 2006: faces, 0.5 to 0.6")
    else:
        results.add(f"place, {what}, {r['size']*r['cells']:.1f} cells", 2*late.mean(), "R", 0.65,
                    "0.05", "Segre and Silberberg 1962: 0.6 to 0.7",
                    KNOWN.get((r["size"], r["cells"])))


# The lift on a sphere that is held is what moves a free one across against its resistance
for r in select(held="yes"):
    history = read(r["file"])
    stokes = 6*math.pi*MU*0.5*r["size"]*H
    lifts = [p["lift_N"] for p in history[len(history)//2:]]
    lift = np.mean(lifts)
    ratio = lift/(drift(same(r))*r["U_m_s"])/stokes
    what = f"Re {r['Re']:g}"
    print(f"{what}: lift {lift:.3e} N, {lift/(1e3*r['U_m_s']**2*(r['size']*H)**4/H**2):.3f} rho U2 "
          f"d4/H2; over the drift {ratio:.3f} x 6 pi mu a; between {min(lifts)/lift:.2f} and"
          f" {max(lifts)/lift:.2f} of this mean")
    results.add(f"lift over drift, {what}", ratio, "6 pi mu a", r["resistance_N_s_m"]/stokes,
                "10%", "clumpResistance, of creeping flow in the same mesh",
                KNOWN_LIFT.get(r["Re"]))
    force = history[-1]["applied_N"]/history[-1]["lift_N"]
    results.add(f"force of the hold over lift, {what}", force, "", -1, "1e-3",
                "momentum of the sphere across")
    moved = max(p["y_m"] for p in history) - min(p["y_m"] for p in history)
    results.add(f"way of the held sphere across, {what}", moved/H, "H", 0, "1e-12", "it is held")

figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4))
for sliding, style in ("auto", "o-"), ("off", "s--"):
    points = sorted((r["Courant"], drift(r)) for r in short if r["sliding"] == sliding
                    and (r["cells"], r["size"], r["Re"], r["frame"]) == (24, 0.22, 50, 0)
                    and (r["shape"], r["scheme"]) == ("duct", "Euler"))
    if points:
        left.plot(*zip(*points), style,
                  label="mesh slides" if sliding == "auto" else "mesh at rest")
left.set_xlabel("Courant number")
left.set_ylabel("drift / largest velocity")
left.set_ylim(0, 1.5*reference)
left.legend()
for r in [r for r in rows if r["end"] > 10]:
    t, x, y = path(r)
    right.plot(t, y, label=f"{r['shape']}, {r['size']:g}")
right.set_xlabel("time U/H")
right.set_ylabel("distance from the middle / H")
right.legend()
save(figure, "inertialMigration.png")
results.write()
