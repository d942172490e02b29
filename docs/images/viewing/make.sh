#!/bin/sh
# Makes the pictures of docs/viewing.md and docs/osp.md again: when the viewer looks otherwise.
# Needs a display of 1280x800 or more with OpenGL 3.2 (Xvfb will do), xdotool and ImageMagick;
# for osp.png also sim-osp/target/extensions (docs/osp.md) and the path of the OSP jar.
#
#   docs/images/viewing/make.sh [OSP-JAR]
set -eu

pictures=$(cd "$(dirname "$0")" && pwd)
osp=${1:+$(realpath "$1")}
cd "$pictures/../../.."

work=$(mktemp -d)
stop() {
    kill $(cat "$work"/*.pid) 2>/dev/null || true
    rm -rf "$work"
}
trap stop EXIT
trap 'exit 130' INT TERM

# record NAME UNTIL: a run of a scenario, $work/NAME.auvsml.gz.
record() {
    ./auvsim serve "examples/scenarios/$1.xml" --port 0 --until "$2" --rate max --record "$work/$1.auvsml.gz"
}

# The window, while its tank's vehicle is driven by keys.
window() {
    ./auvsim serve examples/scenarios/tank.xml --port 0 --paused >"$work/out" &
    echo $! >"$work/serve.pid"
    until port=$(sed -n 's/^serving .*:\([0-9]*\)$/\1/p' "$work/out") && [ -n "$port" ]; do
        kill -0 $!
        sleep 0.1
    done
    ./auvsim view "127.0.0.1:$port" --follow AUV-1701 &
    echo $! >"$work/view.pid"
    viewer=$(xdotool search --sync --onlyvisible --name '^auvsim' | tail -n 1)
    xdotool windowmove "$viewer" 0 0 windowsize --sync "$viewer" 1280 800
    sleep 5
    press 80 142   # the vehicle in the tree
    press 1031 69  # the tab Control
    xdotool mousemove --window "$viewer" 600 300 click --repeat 4 5 # away a little
    press 20 761   # goes on
    xdotool key ctrl+d
    drive 4 w
    drive 2 w a
    drive 2 w r
    xdotool keydown w keydown a
    sleep 2
    import -window "$viewer" "$pictures/window.png"
    xdotool keyup w keyup a
}

press() {
    xdotool mousemove --window "$viewer" "$1" "$2" click 1
    sleep 1
}

# drive SECONDS KEY...: keys that are held.
drive() {
    seconds=$1
    shift
    for key in "$@"; do xdotool keydown "$key"; done
    sleep "$seconds"
    for key in "$@"; do xdotool keyup "$key"; done
}

window
record remus-survey 40
./auvsim view "$work/remus-survey.auvsml.gz" --picture "$pictures/remus.png" --size 1200x700 --at 38 \
    --follow "REMUS 100"
if [ -n "$osp" ]; then
    cp "$osp" sim-osp/target/extensions
    record tank 20
    env -u DISPLAY ./auvsim view "$work/tank.auvsml.gz" --renderer osp --picture "$pictures/osp.png" \
        --size 640x400 --at 18 --extensions sim-osp/target/extensions
fi
