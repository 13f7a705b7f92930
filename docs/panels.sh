#!/usr/bin/env bash
# Draws the figures of a set as NAME.png next to it, 840 pixels wide and with a palette of 256
# colours, and saves the captions that carom writes for them as captions.json there. Pictures of
# figures that the set no longer has are removed.
# Usage: panels.sh CAROM SET.yaml
set -euo pipefail
carom=$1 set=$2
folder=$(dirname "$set")
fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
"$carom" figures "$set" -o "$fresh/drawn" --formats png --quiet
for picture in "$fresh"/drawn/*.png; do
    ffmpeg -v error -bitexact -i "$picture" -vf "scale=840:-1:flags=area+accurate_rnd,split[all][seen];[seen]palettegen=reserve_transparent=0[colors];[all][colors]paletteuse=dither=none" "$fresh/$(basename "$picture")"
done
rm -f "$folder"/*.png
mv "$fresh"/*.png "$fresh/drawn/captions.json" "$folder"
