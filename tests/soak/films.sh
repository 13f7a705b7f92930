#!/usr/bin/env bash
# Renders COUNT films in a row, by one process into one folder. All have the same bytes, nothing else is left there, and
# the process needs no more memory than for ten. Called by `./dev soak`.
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

# films NUMBER FOLDER: prints the peak of memory, in kB
films() {
    local scenes=()
    for ((i = 1; i <= $1; ++i)); do scenes+=("scenes/film-$i.yaml"); done
    python3 - "$carom" render "${scenes[@]}" -o "$2" --quality draft --quiet <<'TEXT'
import resource, subprocess, sys
code = subprocess.run(sys.argv[1:], stdin=subprocess.DEVNULL).returncode
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
sys.exit(code)
TEXT
}

few=$(films 10 few) || die 'ten films were not made'
many=$(films "$count" many) || die "$count films were not made"
[ "$(find many -mindepth 1 | wc -l)" -eq "$count" ] || die "the folder of $count films holds something else"
first=$(sha256sum <few/film-1.mp4)
for film in many/*.mp4; do
    [ "$(sha256sum <"$film")" = "$first" ] || die "$film has other bytes than the first film"
done
[ "$many" -le $((few + few / 10)) ] || die "memory grows: $few kB for ten films, $many kB for $count"
echo "$count films in a row: the same bytes, $many kB (ten films: $few kB)"
