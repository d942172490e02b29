#!/bin/sh
# Records again what the tests replay: when the robots' programs are others, or a change of the
# model is meant to move them.
#
#   examples/replay-tests/record.sh
set -eu

here=$(cd "$(dirname "$0")" && pwd)
examples=$here/..
auvsim=${AUVSIM:-$examples/../auvsim}
recordings=$here/src/test/resources/org/auvsim/examples/replay

work=$(mktemp -d)
server=
stop() {
    if [ -n "$server" ]; then kill "$server" 2>/dev/null || true; fi
    rm -rf "$work"
}
trap stop EXIT
trap 'exit 130' INT TERM

# record NAME SCENARIO END CLIENT [ARGUMENT]: a Python client's conversation up to world time END.
record() {
    name=$1 scenario=$2 end=$3 client=$4
    shift 4
    "$auvsim" serve "$scenario" --port 0 --rate 10 --until "$end" \
        --record "$recordings/$name.auvsml.gz" --force >"$work/out" &
    server=$!
    until port=$(sed -n 's/^serving .*:\([0-9]*\)$/\1/p' "$work/out") && [ -n "$port" ]; do
        kill -0 "$server"
        sleep 0.1
    done
    python3 "$client" 127.0.0.1 "$port" "$@" || [ "$name" = leg ]
    wait "$server"
    server=
}

record tank "$examples/scenarios/tank.xml" 11 "$examples/python/robot.py" 10
# The first leg of a survey, in long steps to keep the file small. The server ends before the
# autopilot is done, which complains.
sed 's/<time-step delta="0.02"/<time-step delta="0.1"/' "$examples/scenarios/remus-survey.xml" >"$work/leg.xml"
record leg "$work/leg.xml" 60 "$examples/clients/autopilot.py"
ls -l "$recordings"
