"""A robot that keeps step with its simulated self, and heads for a point. Python 3, nothing else.

    ./auvsim serve tank.xml      # with <lockstep-timestepper/> in it
    python3 examples/python/lockstep.py HOST PORT OBJECT-ID X Y Z [SEED]

X, Y and Z say where the object starts. Each step is shown before it is made; the robot answers with
the force that is to push it from the step's end on, and the simulator waits for it: the course does
not depend on how long the answer takes. With a seed the robot dawdles at random, to show that.
"""
import math
import random
import socket
import sys
import time
from xml.etree.ElementTree import XMLPullParser

TARGET = (0.0, 0.0, 0.0)
FORCE = 10.0  # N
RADIUS = 0.1  # m: nearer than this it rests

if len(sys.argv) not in (7, 8):
    sys.exit(__doc__)
host, port, me = sys.argv[1], int(sys.argv[2]), sys.argv[3]
position = [float(number) for number in sys.argv[4:7]]
delays = random.Random(f"{sys.argv[7]} {me}") if len(sys.argv) == 8 else None
pushed = False


def dawdle(longest):
    if delays:
        time.sleep(delays.random() * longest)


def steering():
    """The command that sets the force toward the target, or ends it."""
    global pushed
    way = [to - here for to, here in zip(TARGET, position)]
    distance = math.sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2])
    if distance > RADIUS:
        pushed = True
        x, y, z = (part * (FORCE / distance) for part in way)
        return (f'<apply-direct-force-command world-object-id="{me}" name="drive" '
                f'orientation="WORLD"><force-vector x="{x}" y="{y}" z="{z}"/>'
                '</apply-direct-force-command>')
    if pushed:
        pushed = False
        return f'<remove-force-command world-object-id="{me}" force-name="drive"/>'
    return ""


def answer(step):
    send(steering() + f'<ready-command step="{step}"/>')


dawdle(0.05)
try:
    link = socket.create_connection((host, port))
except OSError as refusal:
    sys.exit(f"no simulator at {host}:{port} ({refusal}); start one with ./auvsim serve SCENARIO")
link.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
parser = XMLPullParser(["end"])
parser.feed("<stream>")  # messages follow one another on the wire; this makes them one document


def send(messages):
    link.sendall(f"<auvsml>{messages}</auvsml>".encode())


send(f'<listener-registration-request-command register="1"><world-object id="{me}">'
     '<listener type="ProjectedMovement"/><listener type="TimestepAdvanced"/>'
     f'</world-object></listener-registration-request-command><hello-command name="robot {me}"/>')
step = 0
while data := link.recv(65536):
    parser.feed(data)
    for _, message in parser.read_events():
        if message.tag == "error-response":
            sys.exit(f"the server refuses: {message.get('text')}")
        if message.tag == "hello-response":
            step = int(message.get("step"))  # the first step that it will be shown
            send(steering() + "<get-simulator-state-request/>")
        if message.tag == "simulator-state-response":  # so what was sent before it is there, too
            print("a member from step", step, flush=True)
        if message.tag == "movement-state-change-message" and message.get("is-projected-state") == "1":
            position = [float(message.find("position").get(axis)) for axis in "xyz"]
        if message.tag == "timestep-advanced-notification" and message.get("state-type") == "PROJECTED":
            dawdle(0.002)
            answer(step)
            step += 1
print("the simulation ended after step", step - 1)
