#!/usr/bin/env bash
# Makes a film, or the summary of an ensemble, by three Slurm jobs: plan, an array with one task for
# each chunk, and join. The jobs run copies of this file with --job as their first argument; `usage`
# describes the call by users.
set -euo pipefail

usage() {
    cat <<'TEXT'
slurm-array.sh SCENE [options] [options of carom plan]
  -o FILE         the film (.mp4, .webm, .gif; FOLDER/: single frames), or with --seeds the summary (.json); default out/SCENE.mp4, .json
  --plan FOLDER   where the plan and its chunks are; default FILE.plan
  --cpus N        processors for each job; default 1
  --mem MB        memory for each job; default 4000 for the plan, and what it expects for its chunks if it is there already
  --time MINUTES  limit for each job; default that of the partition, and three times what an existing plan expects for its chunks
  --at-once N     at most N chunks at a time
  --words, --poster, --csv FILE   options of carom join
  --wait          returns when the result is there, with exit code 0, or cannot be made
All other options go to carom plan: --chunks N (default 16), --seeds 1:10000, --vary, --set, --quality and so on.
The same command again makes only what is missing. sbatch reads SBATCH_ACCOUNT and SBATCH_PARTITION; CAROM is the program.
TEXT
}

die() { printf 'slurm-array: %s\n' "$*" >&2; exit 2; }

carom=${CAROM:-carom}
most_requeues=3

# --- in the jobs

# Runs a command. If carom exits with 75 (such as a full disk) or is killed from outside, the job is
# requeued, a limited number of times. Any other failure is final, and Slurm then removes the jobs
# that depend on this one.
work() {
    local code=0
    "$@" || code=$?
    case $code in
        75 | 137)
            if [ "${SLURM_RESTART_COUNT:-0}" -lt "$most_requeues" ]; then
                printf 'slurm-array: exit code %s: job %s goes back to the queue\n' "$code" "$SLURM_JOB_ID" >&2
                scontrol requeue "$SLURM_JOB_ID"
            fi ;;
    esac
    exit "$code"
}

kind_of() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["kind"])' "$1/plan.json"; }

do_chunk() {  # PLAN
    local command=render numbers
    # The array may be longer than the plan, which did not exist when the array was submitted.
    numbers=$("$carom" plan "$1" --list)
    if ! grep -qx "$SLURM_ARRAY_TASK_ID" <<<"$numbers"; then
        printf 'slurm-array: the plan has no chunk %s\n' "$SLURM_ARRAY_TASK_ID"
        exit 0
    fi
    [ "$(kind_of "$1")" = film ] || command=run
    work "$carom" "$command" "$1" --chunk "$SLURM_ARRAY_TASK_ID" --quiet
}

if [ "${1:-}" = --job ]; then
    job=$2
    shift 2
    case $job in
        plan) work "$carom" plan "$@" --quiet ;;
        chunk) do_chunk "$1" ;;
        join) work "$carom" join "$@" --quiet ;;
    esac
fi

# --- where they are submitted

case ${1:-} in '' | -h | --help) usage; exit 0 ;; -*) usage >&2; exit 2 ;; esac
scene=$1
shift
result='' plan='' cpus=1 mem='' minutes='' at_once='' wait=() join_options=() plan_options=() scene_options=() force='' chunks='' sweep=''
while [ $# -gt 0 ]; do
    [ $# -gt 1 ] || case $1 in --words | --poster | --wait | --no-sound | --force) ;; *) die "$1 needs a value" ;; esac
    case $1 in
        -o | --output) result=$2; shift ;;
        --plan) plan=$2; shift ;;
        --cpus) cpus=$2; shift ;;
        --mem) mem=$2; shift ;;
        --time) minutes=$2; shift ;;
        --at-once) at_once=$2; shift ;;
        --words | --poster) join_options+=("$1") ;;
        --csv) join_options+=("$1" "$2"); shift ;;
        --wait) wait=(--wait) ;;
        --chunk-seconds) die "the length of an array is a number: use --chunks N" ;;
        --chunks) chunks=$2; shift ;;
        --seeds) sweep=yes plan_options+=("$1" "$2"); shift ;;
        --force) plan_options+=("$1") force=yes ;;
        --no-sound) plan_options+=("$1") scene_options+=("$1") ;;
        --vary | --format) plan_options+=("$1" "$2"); shift ;;
        -*) plan_options+=("$1" "$2") scene_options+=("$1" "$2"); shift ;;
        *) die "one scene at a time: $1 is neither an option nor the value of one" ;;
    esac
    shift
done
chunks=${chunks:-16}
[ -r "$scene" ] || die "cannot read $scene"
command -v "$carom" >/dev/null || die "$carom is not found; CAROM=/path/of/carom names it"
for program in sbatch scontrol; do
    command -v "$program" >/dev/null ||
        die "$program is not found: this machine has no Slurm; without it carom plan, carom render (for a sweep carom run) and carom join do the same"
done
name=$(basename "${scene%.*}")
if [ -z "$result" ]; then
    if [ -n "$sweep" ]; then result=out/$name.json; else result=out/$name.mp4; fi
fi
plan=${plan:-${result%/}.plan}
if [ -z "$sweep" ]; then
    case $result in
        *.mp4 | *.webm | *.gif) plan_options+=(--format "${result##*.}") ;;
        */) plan_options+=(--format png) ;;
        *) die "-o $result: expected an ending .mp4, .webm, .gif, or FOLDER/" ;;
    esac
fi
plan_options+=(--chunks "$chunks")

# A fingerprint of the program, the scene and the files that it names; empty if the scene is not
# valid.
made_from() {
    "$carom" check --json "$scene" "${scene_options[@]}" 2>/dev/null |
        python3 -c 'import json, sys; print(json.load(sys.stdin)[0].get("made_from", ""))' 2>/dev/null || true
}

# Does the plan exist, made by this command from these files? If in doubt, all chunks count as
# missing: a task whose chunk is done ends at once.
made_from=$(made_from)
request="$scene ${plan_options[*]} $made_from"
is_planned() {
    [ -z "$force" ] && [ -n "$made_from" ] && [ -e "$plan/plan.json" ] && [ "$(cat "$plan/.request" 2>/dev/null)" = "$request" ]
}

# Converts lines of numbers to the ranges of sbatch: 1-3,7.
as_ranges() {
    awk 'NR > 1 && $1 == last + 1 { last = $1; next }
         NR > 1 { printf "%s%s", sep, first == last ? first : first "-" last; sep = "," }
         { first = last = $1 }
         END { if (NR) printf "%s%s", sep, first == last ? first : first "-" last }'
}

# Memory (MB) and time (minutes) of the most expensive chunk, with a margin.
needs() {
    python3 - "$plan/plan.json" "$cpus" <<'PYTHON'
import json, math, sys
chunks = json.load(open(sys.argv[1]))["chunks"]
memory = max(c["memory_bytes"] + (int(sys.argv[2]) - 1) * c["memory_bytes_per_thread"] for c in chunks)
print(math.ceil(256 + 1.25 * memory / 2**20), math.ceil(5 + 3 * max(c["seconds"] for c in chunks) / 60))
PYTHON
}

logs=$plan.logs
mkdir -p "$plan" "$logs"
tasks=1-$chunks chunk_mem=${mem:-4000} chunk_minutes=$minutes
if is_planned; then
    tasks=$("$carom" plan "$plan" --missing | as_ranges)
    read -r expected_mem expected_minutes < <(needs)
    chunk_mem=${mem:-$expected_mem} chunk_minutes=${minutes:-$expected_minutes}
else
    printf '%s' "$request" >"$plan/.request"
fi
last=${tasks##*[-,]}
most=$(scontrol show config | awk '$1 == "MaxArraySize" { print $3 }')
[ "${last:-0}" -lt "${most:-1001}" ] || die "this Slurm numbers the tasks of an array up to $((most - 1)): use --chunks $((most - 1)), or fewer"

submit() {  # NAME MEMORY MINUTES OPTION... -- ARGUMENT...
    local options=(--parsable --requeue --open-mode=append --kill-on-invalid-dep=yes --job-name="carom-$1" --mem="$2" --cpus-per-task="$cpus")
    [ -z "$3" ] || options+=(--time="$3")
    shift 3
    while [ "$1" != -- ]; do options+=("$1"); shift; done
    shift
    sbatch "${options[@]}" "$self" --job "$@"
}

self=$(readlink -f "${BASH_SOURCE[0]}")
after=$(submit plan "${mem:-4000}" "$minutes" --output="$logs/plan-%j.log" -- plan "$scene" "${plan_options[@]}" -o "$plan")
after=${after%%;*}
printf 'plan    job %s\n' "$after"
if [ -n "$tasks" ]; then
    after=$(submit chunk "$chunk_mem" "$chunk_minutes" --dependency="afterok:$after" --array="$tasks${at_once:+%$at_once}" \
        --output="$logs/chunk-%A-%a.log" -- chunk "$plan")
    after=${after%%;*}
    printf 'chunks  job %s, tasks %s\n' "$after" "$tasks"
fi
printf 'join    writes %s; logs are in %s\n' "$result" "$logs"
code=0
join=$(submit join 1000 "$minutes" "${wait[@]}" --dependency="afterok:$after" --output="$logs/join-%j.log" \
    -- join "$plan" -o "$result" "${join_options[@]}") || code=$?
printf 'join    job %s\n' "${join%%;*}"
# sbatch --wait exits with 0 if its job was removed because an earlier one failed.
if [ ${#wait[@]} -gt 0 ] && [ "$code" -eq 0 ]; then
    state=$(scontrol show job "${join%%;*}" | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p')
    [ "$state" = COMPLETED ] || { printf 'slurm-array: not joined, since a job before failed (%s); see %s\n' "$state" "$logs" >&2; exit 1; }
fi
exit "$code"
