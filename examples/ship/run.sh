#!/bin/sh
# A measured zigzag of a ship model corrects a simulated ship that knows too little; three times:
# without feedback, with direct alteration, and with vector adjustment. Every second sample is held
# back and never told to the simulator; the errors are those at these samples.
#
#   examples/ship/run.sh DATA_DIR      the folder with ship_data_hsva.yml and hsva_Z_20_05.csv
set -eu

here=$(cd "$(dirname "$0")" && pwd)
auvsim=${AUVSIM:-$here/../../auvsim}
if [ $# -ne 1 ] || [ ! -f "$1/ship_data_hsva.yml" ] || [ ! -f "$1/hsva_Z_20_05.csv" ]; then
    echo "usage: examples/ship/run.sh DATA_DIR, which holds ship_data_hsva.yml and hsva_Z_20_05.csv" >&2
    exit 2
fi
log=$1/hsva_Z_20_05.csv

work=$(mktemp -d)
servers=
stop() {
    for server in $servers; do kill "$server" 2>/dev/null || true; done
    rm -rf "$work"
}
trap stop EXIT
trap 'exit 130' INT TERM

python3 "$here/scenario.py" "$1/ship_data_hsva.yml" "$log" >"$work/ship.xml"
end=$(tail -n 1 "$log" | cut -d, -f1)
"$auvsim" validate "$work/ship.xml" >/dev/null

# Serves the ship on a free port and feeds it the log; $1 names the run, the rest goes to feed.
corrected() {
    name=$1
    shift
    "$auvsim" serve "$work/ship.xml" --port 0 --rate max --paused --until "$end" \
        >"$work/$name.port" 2>"$work/$name.server" &
    server=$!
    servers="$servers $server"
    until grep -q '^serving' "$work/$name.port"; do
        kill -0 "$server" 2>/dev/null || { cat "$work/$name.server" >&2; exit 1; }
        sleep 0.1
    done
    port=$(sed -n 's/^serving .*:\([0-9]*\)$/\1/p' "$work/$name.port")
    "$auvsim" feed "$log" "127.0.0.1:$port" --object ship --frame ned \
        --columns t=time_s,x=x0_m,y=y0_m --resume "$@" >"$work/$name.out" 2>&1 &
    feeds="$feeds $!"
}

feeds=
corrected none --every 0
corrected direct --every 2 --handler DirectPositionChangeFeedbackHandler
corrected vector --every 2 --handler VectorAdjustmentFeedbackHandler
failed=
for feed in $feeds; do wait "$feed" || failed=yes; done
if [ -n "$failed" ]; then
    cat "$work"/*.out "$work"/*.server >&2
    exit 1
fi

row() {
    awk -v title="$2" '
        /^samples:/ { split($0, n, /[^0-9]+/); sent = n[2]; applied = n[3] }
        /^error:/ { rms = $3; largest = $6; compared = $9 }
        END { printf "%-20s %6d %8d %9d %10.3f %10.3f\n", title, sent, applied, compared, rms, largest }
    ' "$work/$1.out"
}
echo "Position of the simulated ship against the measured one, at samples that were held back:"
printf '%-20s %6s %8s %9s %10s %10s\n' feedback sent applied compared 'RMS m' 'largest m'
row none none
row direct 'direct alteration'
row vector 'vector adjustment'
grep -h '^warning\|^the simulation ended' "$work"/*.out || true
