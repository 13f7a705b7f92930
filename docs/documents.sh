#!/usr/bin/env bash
# Draws the pictures of docs/documents.md: the page of a film, the site of the scene library, slides, and
# the example of integrations/ as rendered by pandoc, MyST, Jupyter and LaTeX. Needs what
# `./dev setup full` installs.
# Usage: documents.sh CAROM SITE OUTPUT, where SITE was made by `./dev gallery`
set -euo pipefail
carom=$(readlink -f "$1") site=$(readlink -f "$2") output=$(readlink -f "$3")
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
export CAROM=$carom NODE_PATH=$root/build/npm/node_modules
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$root/integrations" "$work"
cd "$work/integrations/example"

# picture PAGE NAME WIDTH HEIGHT
picture() { node "$root/tests/browser/pages.cjs" picture "$1" "$output/$2.png" "${@:3}"; }

picture "$site/films/time-reversal.html" page 1200 800
picture "$site/index.html" gallery 1200 1000

"$carom" render "$root"/scenes/{one-hot-particle,time-reversal,mixed-masses}.yaml --slides "$work/talk" --size 720p --quiet
picture "$work/talk/index.html" slides 1280 720

pandoc -s lecture.md -L ../pandoc/carom.lua -o lecture.html
picture lecture.html pandoc 820 1150

# MyST downloads its themes from a server, so its JATS export is rendered by pandoc instead.
myst() { node "$NODE_PATH/mystmd/dist/myst.cjs" "$@"; }
myst build page.md --jats --force --ci -o page.xml >/dev/null
pandoc -s -f jats -V header-includes="<style>video, img { max-width: 100% }</style>" page.xml -o myst.html
picture myst.html myst 820 900

/usr/bin/python3 -m nbconvert --execute --to html --output notebook.html notebook.ipynb
picture notebook.html notebook 820 1000

"$carom" render gas.yaml -o frames.pdf --fps 12 --theme print --quiet
cat >slide.tex <<'TEX'
\documentclass{beamer}
\usepackage{graphicx,animate}
\begin{document}
\begin{frame}{How a gas comes to equilibrium}
\animategraphics[controls,width=\textwidth,poster=24]{12}{frames}{}{}
\end{frame}
\end{document}
TEX
pdflatex -interaction=nonstopmode -halt-on-error slide.tex >/dev/null
pdftoppm -r 150 -png -singlefile slide.pdf "$output/latex"
