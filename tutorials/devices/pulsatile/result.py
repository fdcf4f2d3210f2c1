"""Gradient that drives a pulse of blood in a slit, and that of plasma alone.

Reads postProcessing/drivingGradient and clumpForce. Writes result.csv and result.png.

The mean velocity U exp(i omega t) of a plain fluid between walls at the distance H needs the
gradient [m/s2] (J. R. Womersley, J. Physiol. 127, 553, 1955, for a slit)
    G = i omega U/(1 - tanh(k)/k),   k = H/2 sqrt(i omega/nu)
which is 12 nu U/H^2 for a steady flow.
"""

import cmath
import csv
import math

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from clumps import table

HEIGHT = 32e-6                          # of the slit [m]
NU = 1.171e-6                           # of the plasma [m2/s]
FREQUENCY = 200                         # of the pulse [Hz]

period = 1/FREQUENCY
omega = 2*math.pi*FREQUENCY
rows = table(".", "drivingGradient")
last = [r for r in rows if r["time"] > rows[-1]["time"] - 2.0001*period][-2*len(rows)//4:]


def parts(column):
    """Mean, and complex amplitude of the pulse, over whole periods"""
    mean = sum(r[column] for r in last)/len(last)
    pulse = 2*sum(r[column]*cmath.exp(-1j*omega*r["time"]) for r in last)/len(last)
    return mean, pulse


meanU, pulseU = parts("Ux")
meanG, pulseG = parts("Gx")
k = HEIGHT/2*cmath.sqrt(1j*omega/NU)
plasma = 1j*omega/(1 - cmath.tanh(k)/k)
steady = 12*NU/HEIGHT**2


def lead(z):
    """Angle by which the gradient is ahead of the velocity [degrees]"""
    return math.degrees(cmath.phase(z))


blood = pulseG/pulseU
print("mean velocity  %.3f mm/s, pulse %.3f mm/s" % (1e3*meanU, 1e3*abs(pulseU)))
print("mean gradient  %.2f of that of plasma" % (meanG/meanU/steady))
print("pulse of it    %.2f of that of plasma" % (abs(blood)/abs(plasma)))
print("it leads by    %.1f degrees, in plasma by %.1f" % (lead(blood), lead(plasma)))

forces = table(".", "clumpForce")
cells = sorted({r["clump"] for r in forces})
speed = {}
for r in forces:
    speed.setdefault(r["time"], []).append(r["Ux"])
speed = {t: sum(u)/len(u) for t, u in speed.items()}
times = [r["time"] for r in last]
swing = abs(2*sum(speed[t]*cmath.exp(-1j*omega*t) for t in times)/len(times))
mean = sum(speed[t] for t in times)/len(times)
print("%d red cells   %.2f of the mean velocity, %.2f of its pulse"
      % (len(cells), mean/meanU, swing/abs(pulseU)))

with open("result.csv", "w", newline="") as out:
    result = csv.writer(out)
    result.writerow(["time_ms", "U_mm_s", "cells_mm_s", "G_m_s2", "plasma_m_s2"])
    alone = [steady*meanU + (plasma*pulseU*cmath.exp(1j*omega*t)).real for t in times]
    for r, g in zip(last, alone):
        t = r["time"]
        result.writerow(["%.4g" % (1e3*t), "%.4f" % (1e3*r["Ux"]), "%.4f" % (1e3*speed[t]),
                         "%.4f" % r["Gx"], "%.4f" % g])

figure, (above, below) = plt.subplots(2, 1, figsize=(7, 6), sharex=True)
ms = [1e3*t for t in times]
above.plot(ms, [1e3*r["Ux"] for r in last], label="blood")
above.plot(ms, [1e3*speed[t] for t in times], "--", label="red cells")
above.set_ylabel("mean velocity [mm/s]")
above.legend()
below.plot(ms, [r["Gx"] for r in last], label="blood")
below.plot(ms, alone, "--", label="plasma")
below.set_ylabel("gradient [m/s2]")
below.set_xlabel("time [ms]")
below.legend()
figure.tight_layout()
figure.savefig("result.png", dpi=110)
