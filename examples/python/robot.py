"""A robot that corrects its simulated self. Python 3 and its standard library, nothing else.

    ./auvsim serve examples/scenarios/tank.xml        # in one shell
    python3 examples/python/robot.py                  # in another; [host] [port] [seconds]

The robot's thrusters push its simulated self; a current that the simulator knows nothing of pushes
the real one. Whenever the server says where it will be, the robot answers where it really is.
"""
import math
import socket
import sys
from xml.etree.ElementTree import XMLPullParser

host, port, seconds = (sys.argv[1:] + ["127.0.0.1", "40001", "10"][len(sys.argv) - 1 :])[:3]
try:
    link = socket.create_connection((host, int(port)))
except OSError as refusal:
    sys.exit(f"no simulator at {host}:{port} ({refusal}); start one as above")
parser = XMLPullParser(["end"])
parser.feed("<stream>")  # messages follow one another on the wire; this makes them one document


def send(message):
    link.sendall(f"<auvsml>{message}</auvsml>".encode())


send('<listener-registration-request-command register="1"><world-object id="1">'
     '<listener type="*ALL*"/></world-object></listener-registration-request-command>')
send('<set-propulsor-command world-object-id="1" name="Port Thruster" level="0.2"/>')
send('<set-propulsor-command world-object-id="1" name="Starboard Thruster" level="0.2"/>')

old = ""
time, until, corrections, errors = 0.0, math.inf, 0, []
while time < until and (data := link.recv(65536)):
    parser.feed(data)
    for _, message in parser.read_events():
        if message.tag == "error-response":
            print(f"\nthe server refuses: {message.get('text')}", file=sys.stderr)
            if message.get("code") != "REFUSED":  # a correction that came late is no catastrophe
                sys.exit(1)
        if message.tag == "feedback-applied-notification":
            errors.append((float(message.get("error-before")), float(message.get("error-after"))))
        if message.tag == "movement-state-change-message" and message.get("is-projected-state") == "1":
            time = float(message.get("timestamp"))
            until = min(until, time + float(seconds))
            x, y, z = (float(message.find("position").get(axis)) for axis in "xyz")
            y += 0.005  # what the robot's own sensor says: the current carries it to the left
            here = f'<old-position x="{x}" y="{y}" z="{z}"/>'  # for the answer after this one
            send(f'<different-position-feedback-message world-object-id="1" timestamp="{time}" '
                 'handler-name="DirectPositionChangeFeedbackHandler">'
                 f'<virtual-position x="{x}" y="{y - 0.005}" z="{z}"/>'
                 f'<actual-position x="{x}" y="{y}" z="{z}"/>{old or here}'
                 '</different-position-feedback-message>')
            old = here
            corrections += 1
            if sys.stdout.isatty():
                print(f"\r{time:8.2f} s   x {x:8.3f}   y {y:8.3f}   z {z:8.3f} m", end="")

if time >= until:  # or else the simulator has gone
    send('<set-propulsor-command world-object-id="1" name="Port Thruster" level="0"/>')
    send('<set-propulsor-command world-object-id="1" name="Starboard Thruster" level="0"/>')
print()
if len(errors) < corrections / 2 or max(after for _, after in errors or [(1, 1)]) > 1e-6:
    sys.exit(f"the server applied {len(errors)} of {corrections} corrections: {errors[:3]} ...")
print(f"{len(errors)} of {corrections} corrections applied; each moved the simulated robot by "
      f"{errors[0][0] * 1000:.1f} mm, {errors[0][1] * 1000:.1f} mm were left")
