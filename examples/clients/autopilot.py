"""Steers a torpedo by waypoints through a sheared current. Python 3 and its standard library.

    ./auvsim serve examples/scenarios/remus-survey.xml      # in one shell
    python3 examples/clients/autopilot.py                   # in another; [host] [port]"""
import math
import socket
import sys
from xml.etree.ElementTree import XMLPullParser

WAYPOINTS = [(60, 0, -20), (90, 40, -14), (40, 70, -10), (0, 40, -16)]  # m east, north, up
RUDDERS, PLANES = ["Upper Rudder", "Lower Rudder"], ["Port Stern Plane", "Starboard Stern Plane"]

host, port = (sys.argv[1:] + ["127.0.0.1", "40001"][len(sys.argv) - 1:])[:2]
try:
    link = socket.create_connection((host, int(port)))
except OSError as refusal:
    sys.exit(f"no simulator at {host}:{port} ({refusal}); start one as above")
parser = XMLPullParser(["end"])
parser.feed("<stream>")  # roots follow one another on the wire; this makes them one document


def send(*messages):
    link.sendall(f"<auvsml>{''.join(messages)}</auvsml>".encode())


def turn(fins, angle):
    angle = max(-0.227, min(0.227, angle))  # rad: 13 degrees
    return [f'<set-control-surface-command world-object-id="1" name="{fin}" angle="{angle}"/>' for fin in fins]


def numbers(message, element, axes="xyz"):
    return [float(message.find(element).get(axis)) for axis in axes]


def steer(state, goal):
    (x, y, z), (east, north, _) = numbers(state, "position"), numbers(state, "velocity")
    qw, qx, qy, qz = numbers(state, "quaternion", "wxyz")
    _, sinking, yawing = numbers(state, "body-angular-velocity")  # rad/s: bow down, bow to port
    off_course = math.remainder(math.atan2(goal[1] - y, goal[0] - x) - math.atan2(north, east), 2 * math.pi)
    climb = math.asin(max(-1.0, min(1.0, 2 * (qx * qz - qw * qy))))
    wanted = max(-0.35, min(0.35, 0.12 * (goal[2] - z)))
    send(*turn(RUDDERS, 0.6 * off_course - 0.6 * yawing), *turn(PLANES, 1.5 * (climb - wanted) - 0.8 * sinking))


send('<listener-registration-request-command register="1"><world-object id="1">'
     '<listener type="KinematicState"/></world-object></listener-registration-request-command>')
steered, left = -1.0, list(WAYPOINTS)
while left and (data := link.recv(65536)):
    parser.feed(data)
    for _, message in parser.read_events():
        if message.tag == "error-response":
            sys.exit(f"the server refuses: {message.get('text')}")
        if message.tag == "kinematic-state-message" and left:
            time, place = float(message.get("timestamp")), numbers(message, "position")
            if math.dist(place[:2], left[0][:2]) < 4:  # m, seen from above
                print(f"{time:7.1f} s  {left.pop(0)} reached at a height of {place[2]:.1f} m")
            elif time - steered > 0.1:
                steer(message, left[0])
                steered = time
sys.exit(f"the server has gone; {len(left)} waypoints are left" if left else 0)
