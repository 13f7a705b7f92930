#!/usr/bin/env bash
# Runs all checks that a release must pass. Each step is recorded in the table of docs/trust.md with
# its commit, duration and result; rows of steps that are not run stay unchanged. Called by
# `./dev release`.
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.."
readonly page=docs/trust.md
fuzz_seconds=3600 collisions=1e10

usage() {
    cat <<'TEXT'
usage: ./dev release [--fuzz-seconds S] [--collisions N] [STEP...]
  without steps: all of them
TEXT
    printf '  steps: %s\n' "${steps[*]}"
}

readonly steps=(lint test asan tsan slow fuzz soak determinism validate bench package bookworm trixie)

# run_step STEP: its command; what it says goes to build/release-STEP.log
run_step() {
    case $1 in
        lint) ./dev lint ;;
        test) ./dev test ;;
        asan) ./dev test --asan ;;
        tsan) ./dev test --tsan ;;
        slow) ./dev test --slow ;;
        fuzz) ./dev fuzz "$fuzz_seconds" ;;
        soak) ./dev soak "$collisions" ;;
        determinism) ./dev determinism ;;
        validate) ./dev validate ;;
        bench) ./dev bench ;;
        package) ./dev package ;;
        bookworm | trixie) ./dev portability "$1" ;;
    esac
}

# summary STEP LOG: a few words on what the step has counted
summary() {
    case $1 in
        test | asan | tsan | slow) grep -o '[0-9]*% tests passed.*' "$2" | tail -n 1 ;;
        fuzz) awk '/ inputs, / {inputs += $2; finds += $4} END {print inputs " inputs, " finds " finds"}' "$2" ;;
        soak) grep -o '^[0-9.e+]* collisions' "$2" | tail -n 1 ;;
        determinism) printf '%s outputs the same\n' "$(grep -c ' same$' "$2")" ;;
        bookworm | trixie) printf '%s rows passed\n' "$(grep -c ' passed$' "$2")" ;;
        *) echo ;;
    esac
}

# record STEP SECONDS RESULT: replaces the row of the step in the table of docs/trust.md
record() {
    local row date commit
    date=$(date -u +%F) commit=$(git rev-parse --short HEAD)
    git diff --quiet HEAD -- . ":!$page" ":!docs/validation*" || commit="$commit and changes"
    row="| $1 | $date | $commit | $(($2 / 60)):$(printf %02d $(($2 % 60))) | $3 |"
    awk -v step="| $1 |" -v row="$row" '
        index($0, step) == 1 { if (!done) print row; done = 1; next }
        { print }' "$page" >"$page.new"
    grep -qF "$row" "$page.new" || { rm "$page.new"; echo "release: $page has no row for $1" >&2; exit 1; }
    mv "$page.new" "$page"
}

chosen=()
while [ $# -gt 0 ]; do
    case $1 in
        --fuzz-seconds) fuzz_seconds=${2:?a number of seconds}; shift 2 ;;
        --collisions) collisions=${2:?a number of collisions}; shift 2 ;;
        --help | -h) usage; exit 0 ;;
        *)
            case " ${steps[*]} " in *" $1 "*) chosen+=("$1") ;; *) usage >&2; exit 2 ;; esac
            shift ;;
    esac
done
[ ${#chosen[@]} -gt 0 ] || chosen=("${steps[@]}")

mkdir -p build
failed=()
for step in "${chosen[@]}"; do
    begun=$SECONDS log=build/release-$step.log result=passed
    printf '%-12s' "$step"
    run_step "$step" >"$log" 2>&1 || { result=FAILED; failed+=("$step"); }
    counted=$(summary "$step" "$log")
    record "$step" $((SECONDS - begun)) "$result${counted:+: $counted}"
    printf ' %5d s  %s%s\n' $((SECONDS - begun)) "$result" "${counted:+: $counted}"
done
[ ${#failed[@]} -eq 0 ] || { echo "release: failed: ${failed[*]}; what was said: build/release-STEP.log" >&2; exit 1; }
