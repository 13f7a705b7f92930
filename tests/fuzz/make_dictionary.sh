#!/usr/bin/env bash
# Prints the words of the scene language, of figure sets and of the command line as a libFuzzer
# dictionary. Usage: make_dictionary.sh CAROM
set -euo pipefail
{
    "$1" schema
    "$1" schema --for set
} | grep -oE '"[A-Za-z0-9_.#-]{1,40}"' | sort -u
for command in $("$1" __complete bash ''); do
    "$1" __complete bash "$command" -
done | grep -oE -- '--[a-z][a-z-]+' | sort -u | sed 's/.*/"&"/'
printf '"%s"\n' ': ' ', ' '[' ']' '{' '}' '- ' '{{#' '{{^' '{{/' '}}' '$' '&a ' '*a' '.nan' '1e300' '-1'
