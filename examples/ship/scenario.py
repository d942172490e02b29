"""Writes a ship scenario for auvsim from a ship's data and a measured manoeuvre.

    python3 scenario.py ship_data_hsva.yml hsva_Z_20_05.csv >ship.xml

What the data say goes in, and nothing else: mass, inertia, size, the first row's pose and velocity,
and the measured thrust. There is no hull resistance, no rudder and no added mass: how far such a
model goes astray, and what corrective feedback makes of it, is what this example shows.

The data are north-east-down and forward-starboard-down, auvsim's world is east-north-up and its
bodies forward-port-up: (x, y, z) becomes (y, x, -z) in the world and (x, -y, -z) in the body.
"""
import csv
import math
import sys
from xml.sax.saxutils import quoteattr

TIME_STEP = 0.2  # s, that of the samples
WAIT = 0.08  # s of real time that the simulator waits for feedback in each step


def ship_data(path):
    """The numbers of a flat YAML file."""
    data = {}
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            key, colon, value = line.split("#")[0].partition(":")
            if colon:
                try:
                    data[key.strip()] = float(value)
                except ValueError:
                    sys.exit(f"{path}: expected a number for {key.strip()}, but found {value.strip()}")
    missing = {"m", "I_z", "L", "B", "T", "x_p", "tdf"} - data.keys()
    if missing:
        sys.exit(f"{path}: {', '.join(sorted(missing))} missing")
    return data


def manoeuvre(path):
    """The rows of a measured manoeuvre, as numbers."""
    with open(path, encoding="utf-8", newline="") as lines:
        rows = [{name: float(text) for name, text in row.items()} for row in csv.DictReader(lines)]
    if not rows:
        sys.exit(f"{path}: no rows")
    return rows


def vector(name, x, y, z):
    return f'<{name} x="{x:.9g}" y="{y:.9g}" z="{z:.9g}"/>'


def heading(psi):
    """Orientation, body to world: a compass heading (rad, clockwise from north)."""
    half = (math.pi / 2 - psi) / 2
    return f'<orientation w="{math.cos(half):.12g}" x="0" y="0" z="{math.sin(half):.12g}"/>'


def velocity(psi, u, v):
    """Speeds ahead and to starboard (m/s) as a velocity in the world."""
    north = u * math.cos(psi) - v * math.sin(psi)
    east = u * math.sin(psi) + v * math.cos(psi)
    return vector("velocity", east, north, 0)


def scenario(ship, rows):
    mass, length, breadth, draught = ship["m"], ship["L"], ship["B"], ship["T"]
    # The data give yaw alone. Roll and pitch are those of a box of the ship's size and mass, scaled
    # as its yaw has to be; they do not matter for a ship that stays upright.
    scale = ship["I_z"] / (mass * (length**2 + breadth**2) / 12)
    roll = scale * mass * (breadth**2 + draught**2) / 12
    pitch = scale * mass * (length**2 + draught**2) / 12
    # Behind a ship the propeller draws water from the hull: part of its thrust is lost.
    thrusts = [(row["time_s"], row["thrust_N"] * (1 - ship["tdf"])) for row in rows]
    most = max(abs(thrust) for _, thrust in thrusts)
    first = rows[0]
    psi = math.radians(first["psi_deg"])
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield f'<scenario start-time="{first["time_s"]:.9g}">'
    yield f'  <time-step delta="{TIME_STEP}"/>'
    yield f'  <simple-fixed-time-feedback-timestepper wait="{WAIT}"/>'
    yield f'  <world-object id="1" name="ship" mass="{mass:.9g}">'
    yield f'    <box>{vector("size", length, breadth, draught)}</box>'
    yield f'    <inertia xx="{roll:.9g}" yy="{pitch:.9g}" zz="{ship["I_z"]:.9g}"/>'
    yield f'    {vector("position", first["y0_m"], first["x0_m"], 0)}'
    yield f"    {heading(psi)}"
    yield f'    {velocity(psi, first["u_m_s"], first["v_m_s"])}'
    yield f'    {vector("angular-velocity", 0, 0, -math.radians(first["r_deg_s"]))}'
    yield f'    <propulsor name={quoteattr("Propeller")} maximum-thrust="{most:.9g}">'
    yield f'      {vector("position", ship["x_p"], 0, 0)}'
    yield "    </propulsor>"
    yield '    <propulsor-schedule name="Measured Thrust" propulsor="Propeller">'
    for time, thrust in thrusts:
        yield f'      <timed-level at="{time:.9g}" level="{thrust / most:.9g}"/>'
    yield "    </propulsor-schedule>"
    yield "  </world-object>"
    yield "</scenario>"


if len(sys.argv) != 3:
    sys.exit("usage: python3 scenario.py SHIP.yml MANOEUVRE.csv")
for line in scenario(ship_data(sys.argv[1]), manoeuvre(sys.argv[2])):
    print(line)
