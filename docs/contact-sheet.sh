#!/usr/bin/env bash
# Draws every scene of a folder at its start, a quarter, half and end, side by side into one picture.
# Usage: contact-sheet.sh CAROM SCENES OUTPUT.jpg
set -euo pipefail
carom=$1 scenes=$2 output=$3
stills=$(mktemp -d)
trap 'rm -rf "$stills"' EXIT
number=0
for scene in "$scenes"/*.yaml; do
    end=$("$carom" check --json "$scene" | sed -n 's/^ *"time": \([0-9.e+-]*\),*$/\1/p')
    for share in 0 0.25 0.5 1; do
        at=$(awk -v end="$end" -v share="$share" 'BEGIN { printf "%.12g", end * share }')
        "$carom" still "$scene" --at "$at" --size 1280x720 --quiet -o "$stills/$(printf %03d "$number").png"
        number=$((number + 1))
    done
done
ffmpeg -v error -y -i "$stills/%03d.png" -frames:v 1 -q:v 9 \
    -vf "scale=352:198:flags=area,tile=4x$((number / 4)):padding=8:margin=8:color=0x30363d" "$stills/sheet.jpg"
mv "$stills/sheet.jpg" "$output"
