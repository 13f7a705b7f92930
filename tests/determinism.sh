#!/usr/bin/env bash
# Checks that outputs do not depend on threads, compiler, optimisation or processor: builds carom in
# several ways in build/determinism; each build must reach the states listed in docs/portability.md
# and write films, frames, tables and figures with the same bytes. Prints a row for each. Called by
# `./dev determinism`.
# shellcheck disable=SC2016,SC2317  # $ is for sed; the functions are called by row
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
readonly here=build/determinism
readonly scenes=(one-hot-particle mixed-masses gaslab/heat-box)
readonly small=(--quality draft --size 640x360 --seconds 4 --quiet)
log=$here/log

# make_outputs CAROM FOLDER THREADS
make_outputs() {
    local carom=$1 folder=$2 threads=$3 scene name
    rm -rf "$folder" && mkdir -p "$folder"
    for scene in "${scenes[@]}"; do
        name=$(basename "$scene")
        "$carom" render "scenes/$scene.yaml" -o "$folder/$name.mp4" --threads "$threads" "${small[@]}"
    done
    "$carom" render scenes/two-to-one.yaml -o "$folder/film.webm" --threads "$threads" "${small[@]}"
    "$carom" render scenes/two-to-one.yaml -o "$folder/film.gif" --threads "$threads" "${small[@]}"
    "$carom" run scenes/mixed-masses.yaml --csv "$folder/run.csv" --threads "$threads" --quiet
    "$carom" figures scenes/sets/collisions.yaml -o "$folder/figures" --threads "$threads" --quiet
    rm -f "$folder/figures/figures.json"  # holds the fingerprint of the program
}

# differing_states CAROM: the scenes whose final state differs from docs/portability.md
differing_states() {
    sed -n 's/.*](\.\.\/\(scenes[^)]*\)) | `\([0-9a-f]*\)`.*/\1 \2/p' docs/portability.md | while read -r scene state; do
        [ "$("$1" run "$scene" --json - --quiet | sed -n 's/.*"state": *"\([0-9a-f]*\)".*/\1/p')" = "$state" ] || echo "$scene"
    done
}

# row WHAT COMMAND...
row() {
    local what=$1 begun=$SECONDS result=same
    shift
    printf '%-34s' "$what"
    echo "== $what" >>"$log"
    "$@" >>"$log" 2>&1 || { result=DIFFERENT; failed=1; }
    printf ' %3d:%02d %s\n' $(((SECONDS - begun) / 60)) $(((SECONDS - begun) % 60)) "$result"
}

same_outputs() {  # CAROM NAME THREADS
    make_outputs "$1" "$here/$2-outputs" "$3" && diff -r "$here/outputs" "$here/$2-outputs" && rm -r "$here/$2-outputs"
}

same_build() {  # must give the same outputs as another build of the same sources
    local name=$1 differing
    shift
    cmake -G Ninja -B "$here/$name" -DCMAKE_BUILD_TYPE=Release -DCAROM_TESTS=OFF -DCAROM_UNITY=ON "$@" \
        && cmake --build "$here/$name" || return 1
    differing=$(differing_states "$here/$name/bin/carom")
    [ -z "$differing" ] || { echo "other states: $differing"; return 1; }
    same_outputs "$here/$name/bin/carom" "$name" 2
}

mkdir -p "$here" && : >"$log"
failed=0
carom=build/release/bin/carom
make_outputs "$carom" "$here/outputs" 1
for ((threads = 2; threads <= 16; ++threads)); do row "$threads threads" same_outputs "$carom" threads "$threads"; done
row 'GCC, -O1' same_build gcc-o1 '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG'
row 'GCC, -O2' same_build gcc-o2 '-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG'
row 'GCC, without AVX' same_build gcc-plain '-DCMAKE_CXX_FLAGS=-DCAROM_ONE_VERSION'
row 'GCC, AVX2 in all of it' same_build gcc-avx2 '-DCMAKE_CXX_FLAGS=-mavx2'
row 'Clang, -O3' same_build clang -DCMAKE_CXX_COMPILER=clang++
row 'Clang, -O1' same_build clang-o1 -DCMAKE_CXX_COMPILER=clang++ '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG'
[ "$failed" -eq 0 ] || echo "what differs: $log" >&2
exit "$failed"
