#!/usr/bin/env bash
# Draws every scene of a folder and its subfolders at the start, a quarter, half and the end of its
# run, side by side in one picture, with the folder names as headings. Folders that have no scenes,
# such as that of figure sets, are left out.
# Usage: contact-sheet.sh CAROM SCENES OUTPUT.jpg
set -euo pipefail
carom=$1 scenes=$2 output=$3
stills=$(mktemp -d)
trap 'rm -rf "$stills"' EXIT
name=$(basename "$scenes")
parts=()
for folder in "$scenes" "$scenes"/*/; do
    number=0
    rm -f "$stills"/*.png
    for scene in "$folder"/*.yaml; do
        grep -qs '^run:' "$scene" || continue  # skips a figure set, or an empty match
        end=$("$carom" check --json "$scene" | sed -n 's/^ *"time": \([0-9.e+-]*\),*$/\1/p')
        for share in 0 0.25 0.5 1; do
            at=$(awk -v end="$end" -v share="$share" 'BEGIN { printf "%.12g", end * share }')
            "$carom" still "$scene" --at "$at" --size 1280x720 --quiet -o "$stills/$(printf %03d "$number").png"
            number=$((number + 1))
        done
    done
    [ "$number" -gt 0 ] || continue
    words=$name
    [ "$folder" = "$scenes" ] || words=$name/$(basename "$folder")
    part=$stills/${#parts[@]}.bmp
    ffmpeg -v error -y -i "$stills/%03d.png" -frames:v 1 -vf "scale=352:198:flags=area,tile=4x$((number / 4)):padding=8:margin=8:color=0x30363d,pad=iw:ih+34:0:34:0x30363d,drawtext=font=Inter:text='$words':x=10:y=8:fontsize=24:fontcolor=white" "$part"
    parts+=("$part")
done
inputs=()
for part in "${parts[@]}"; do inputs+=(-i "$part"); done
ffmpeg -v error -y "${inputs[@]}" -filter_complex "vstack=inputs=${#parts[@]}" -frames:v 1 -q:v 9 "$stills/sheet.jpg"
mv "$stills/sheet.jpg" "$output"
