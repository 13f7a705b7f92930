#!/usr/bin/env bash
# Renders COUNT films in a row, in one process and one folder. Checks that all have the same bytes,
# that nothing else is left in the folder, and that the peak memory of the process hardly grows
# after a tenth of them. Called by `./dev soak`.
set -euo pipefail
[ $# -eq 2 ] || { echo 'usage: films.sh CAROM COUNT' >&2; exit 2; }
carom=$(readlink -f "$1") count=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
die() { echo "soak: $*" >&2; exit 1; }

cat >scene.yaml <<'TEXT'
title: A small gas
box: {size: [12, 8]}
gas: [{count: 12, radius: 0.3, speed: 1}]
run: {until: 2}
film: {seconds: 0.4, size: [160, 96], panels: [speed-histogram]}
TEXT
mkdir scenes
for ((i = 1; i <= count; ++i)); do cp scene.yaml "scenes/film-$i.yaml"; done

# Prints the peak memory after a tenth of the films and after all, in kB. All scenes are read before
# the first film.
films() {
    local scenes=()
    for ((i = 1; i <= count; ++i)); do scenes+=("scenes/film-$i.yaml"); done
    python3 - "films/film-$((count / 10)).mp4" "$carom" render "${scenes[@]}" -o films --quality draft --quiet <<'TEXT'
import os, resource, subprocess, sys, time
process = subprocess.Popen(sys.argv[2:], stdin=subprocess.DEVNULL)
while not os.path.exists(sys.argv[1]) and process.poll() is None:
    time.sleep(0.01)
if process.poll() is None:
    status = open(f"/proc/{process.pid}/status").read().split()
    print(status[status.index("VmHWM:") + 1])
code = process.wait()
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
sys.exit(code)
TEXT
}

memory=$(films) || die "$count films were not made"
[ "$(find films -mindepth 1 | wc -l)" -eq "$count" ] || die "the folder of $count films holds something else"
first=$(sha256sum <films/film-1.mp4)
for film in films/*.mp4; do
    [ "$(sha256sum <"$film")" = "$first" ] || die "$film has other bytes than the first film"
done
read -r early all <<<"${memory//$'\n'/ }"
[ -n "$all" ] || die "$count films are too few to measure memory on the way"
[ "$all" -le $((early + early / 10)) ] || die "memory grows: $early kB after $((count / 10)) films, $all kB after $count"
echo "$count films in a row: the same bytes, $all kB (after $((count / 10)): $early kB)"
