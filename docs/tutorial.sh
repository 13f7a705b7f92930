#!/usr/bin/env bash
# Draws the pictures of docs/tutorial.md as tutorial/STEP.png, with a palette of 256 colours. The
# last, a page in a browser, is drawn anew only where the browser of `./dev setup full` is.
# Usage: tutorial.sh CAROM
set -euo pipefail
carom=$(readlink -f "$1")
folder=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/tutorial
root=$(dirname "$(dirname "$folder")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# small STEP WIDTH: the picture STEP.png in the folder of work, for the page.
small() {
    ffmpeg -v error -y -bitexact -i "$work/$1.png" -vf "scale=$2:-1:flags=area+accurate_rnd,split[all][seen];[seen]palettegen=reserve_transparent=0[colors];[all][colors]paletteuse=dither=none" "$work/small.png"
    mv "$work/small.png" "$folder/$1.png"
}

# step STEP TIME: a frame of its film.
step() {
    "$carom" still "$folder/$1.yaml" --at "$2" --size 720p -o "$work/$1.png" --quiet
    small "$1" 800
}

step 1 22
step 2 10
step 3 22
step 4 30
step 5 22
step 6 15
"$carom" render "$folder/7.yaml" --size 720p --fps 2 -o "$work/frames/" --quiet
cp "$(find "$work/frames" -name '*.png' | sort | tail -n 2 | head -n 1)" "$work/7.png"
small 7 800
"$carom" figures "$folder/8.yaml" --only spreading --formats png -o "$work/figures" --quiet
cp "$work/figures/spreading.png" "$work/8.png"
small 8 800
"$carom" still "$folder/8.yaml" --template portrait --size 1080x1920 --set 'film.panels=[sides]' --at 30 -o "$work/9.png" --quiet
small 9 320
if [ -d "$root/build/npm/node_modules" ] && command -v node >/dev/null && command -v chromium >/dev/null; then
    "$carom" render "$folder/10.yaml" --size 720p --fps 10 --page html -o "$work/page.html" --quiet
    NODE_PATH=$root/build/npm/node_modules node "$root/tests/browser/pages.cjs" picture "$work/page.html" "$work/10.png" 1200 700
    small 10 800
fi
