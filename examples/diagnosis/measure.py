#!/usr/bin/env python3
"""Writes run1.csv to run3.csv: what a vehicle that model.xml gets wrong would measure.

Its equations of motion are here, not the simulator's: mass 30 kg, a box of 0.8 x 0.5 x 0.3 m, linear drag
as in model.xml, and what the model lacks, a drag with the square of the speed. Runge-Kutta of fourth order,
steps of 5 ms. Needs nothing but Python 3; the same seed writes the same files.
"""

import math
import random
from pathlib import Path

MASS = 30.0
INERTIA = MASS / 12 * (0.8**2 + 0.5**2)  # about the vertical, kg m^2
LINEAR = 8.0  # N s/m
TURNING = 2.0  # N m s/rad
QUADRATIC = 12.4  # kg/m: what model.xml does not have
THRUST, LIFT, ARM = 20.0, 15.0, 0.25

STEP = 0.005  # s
ROWS_A_SECOND = 10
POSITION_NOISE = 0.01  # m
YAW_NOISE = 0.005  # rad

# From when on (s), levels of port, starboard and vertical.
RUNS = {
    "run1": [(0, 0.6, 0.6, 0.0), (12, 0.9, 0.6, -0.4), (25, 0.3, 0.5, 0.2), (40, 0.0, 0.0, 0.0)],
    "run2": [(0, 0.2, 0.3, -0.6), (10, 1.0, 1.0, 0.0), (22, -0.5, -0.2, 0.5), (36, 0.7, 0.4, 0.0)],
    "run3": [(0, 0.8, 0.5, -0.3), (15, 0.4, 0.8, 0.3), (30, 1.0, 0.9, -0.5), (42, -0.3, -0.3, 0.1)],
}
DURATION = 50.0


def derivative(state, levels):
    """Of x, y, z, yaw, vx, vy, vz and the rate of yaw (world: x east, y north, z up)."""
    _, _, _, yaw, vx, vy, vz, rate = state
    port, starboard, vertical = levels
    ahead = THRUST * (port + starboard)
    drag = LINEAR + QUADRATIC * math.sqrt(vx * vx + vy * vy + vz * vz)
    return (
        vx,
        vy,
        vz,
        rate,
        (ahead * math.cos(yaw) - drag * vx) / MASS,
        (ahead * math.sin(yaw) - drag * vy) / MASS,
        (LIFT * vertical - drag * vz) / MASS,
        (ARM * THRUST * (starboard - port) - TURNING * rate) / INERTIA,
    )


def step(state, levels):
    """Runge-Kutta of fourth order."""

    def ahead(slope, span):
        return tuple(s + span * d for s, d in zip(state, slope))

    k1 = derivative(state, levels)
    k2 = derivative(ahead(k1, STEP / 2), levels)
    k3 = derivative(ahead(k2, STEP / 2), levels)
    k4 = derivative(ahead(k3, STEP), levels)
    slope = tuple((a + 2 * b + 2 * c + d) / 6 for a, b, c, d in zip(k1, k2, k3, k4))
    return ahead(slope, STEP)


def measure(name, schedule, noise, out):
    state = (0.0, 0.0, -5.0, noise.uniform(-1, 1), 0.0, 0.0, 0.0, 0.0)
    out.write("t,x,y,z,yaw,port,starboard,vertical\n")
    steps = round(1 / (STEP * ROWS_A_SECOND))
    for row in range(round(DURATION * ROWS_A_SECOND) + 1):
        time = row / ROWS_A_SECOND
        levels = [entry for entry in schedule if entry[0] <= time][-1][1:]
        place = (f"{p + noise.gauss(0, POSITION_NOISE):.4f}" for p in state[:3])
        yaw = f"{state[3] + noise.gauss(0, YAW_NOISE):.4f}"
        out.write(",".join([f"{time:.1f}", *place, yaw, *(f"{level:g}" for level in levels)]) + "\n")
        for _ in range(steps):
            state = step(state, levels)


def main():
    folder = Path(__file__).resolve().parent
    noise = random.Random(7)
    for name, schedule in RUNS.items():
        with open(folder / f"{name}.csv", "w", newline="\n", encoding="utf-8") as out:
            measure(name, schedule, noise, out)


if __name__ == "__main__":
    main()
