"""A robot from which the simulator learns. Python 3 and its standard library, nothing else.

    ./auvsim serve --paused examples/scenarios/learning.xml    # in one shell
    python3 examples/python/learning.py                        # in another; [host] [port] [seed]

The robot feels a quadratic drag of 12 kg/m that its simulated self lacks. It asks for one step after
the other, tells where it measured itself to be at the end of each and, after 31 s of that, waits
until the simulator says what its model lacks; then it goes on for 5 s.
"""
import random
import socket
import sys
from xml.etree.ElementTree import XMLPullParser

MASS, DRAG, THRUST, STEP, NOISE = 10.0, 12.0, 20.0, 0.05, 0.005
LEARNED_AT, END = 31.0, 36.0
host, port, seed = (sys.argv[1:] + ["127.0.0.1", "40001", "1"][len(sys.argv) - 1 :])[:3]
lot = random.Random(int(seed))
link = socket.create_connection((host, int(port)))
parser = XMLPullParser(["end"])
parser.feed("<stream>")  # messages follow one another on the wire; this makes them one document


def send(message):
    link.sendall(f"<auvsml>{message}</auvsml>".encode())


def rates(state, levels):
    velocity = state[3:]
    speed = sum(v * v for v in velocity) ** 0.5
    return velocity + [(THRUST * u - DRAG * speed * v) / MASS for u, v in zip(levels, velocity)]


def moved(state, levels, time):
    """The state after a time (s), by steps of 5 ms of the classical Runge-Kutta method."""
    steps = max(1, round(time / 0.005))
    h = time / steps
    for _ in range(steps):
        k1 = rates(state, levels)
        k2 = rates([s + h / 2 * k for s, k in zip(state, k1)], levels)
        k3 = rates([s + h / 2 * k for s, k in zip(state, k2)], levels)
        k4 = rates([s + h * k for s, k in zip(state, k3)], levels)
        state = [s + h / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
    return state


state, levels, found, time, steps = [0.0] * 6, [0.0] * 3, None, 0.0, 0


def next_step():
    global levels
    if steps % 40 == 0:  # every 2 s the thrusters get new levels
        levels = [lot.uniform(-1, 1) for _ in range(3)]
        for name, level in zip(("Surge", "Sway", "Heave"), levels):
            send(f'<set-propulsor-command world-object-id="1" name="{name}" level="{level}"/>')
    send('<step-command count="1"/>')


def answer(projected):
    global state
    state = moved(state, levels, projected - time)
    x, y, z = (s + lot.gauss(0, NOISE) for s in state[:3])
    a, b, c = (lot.gauss(0, NOISE / 2) for _ in "xyz")  # it does not turn
    w = (1 - a * a - b * b - c * c) ** 0.5
    send(f'<different-state-feedback-message world-object-id="1" timestamp="{projected}" '
         f'handler-name="LearningFeedbackHandler"><position x="{x}" y="{y}" z="{z}"/>'
         f'<orientation w="{w}" x="{a}" y="{b}" z="{c}"/>'
         '</different-state-feedback-message>')


def waits():
    return time >= LEARNED_AT and found is None


send('<hello-command name="robot"/>')
send('<listener-registration-request-command register="1"><world-object id="1">'
     + "".join(f'<listener type="{event}"/>' for event in
               ("ProjectedMovement", "TimestepAdvanced", "ModelCorrection"))
     + "</world-object></listener-registration-request-command>")
next_step()
while time < END and (data := link.recv(65536)):
    parser.feed(data)
    for _, message in parser.read_events():
        if message.tag == "error-response":
            sys.exit(f"the server refuses: {message.get('text')}")
        if message.tag == "model-correction-notification" and found is None:
            found = message.find("model-correction")
            print(found.get("sentence"))
            if time >= LEARNED_AT:
                next_step()
        if message.tag == "movement-state-change-message":
            answer(float(message.get("timestamp")))
        if message.tag == "timestep-advanced-notification" and message.get("state-type") == "ACTUAL":
            time, steps = float(message.get("timestamp")), steps + 1
            if not waits() and time < END:
                next_step()
names = [cause.get("name") for cause in found.findall("cause")] if found is not None else []
print(f"learned: {', '.join(names)}")
sys.exit(0 if names else 1)
