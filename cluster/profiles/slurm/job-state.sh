#!/usr/bin/env bash
# job-state.sh JOB: prints the state of a Slurm job as Snakemake expects it: running, success or
# failed.
set -euo pipefail
job=${1%%;*}  # sbatch --parsable prints JOB;CLUSTER where there are several clusters

state_of() {
    local state
    # Slurm forgets a job some minutes after it has ended; its accounting, if enabled, does not.
    state=$(scontrol show job "$job" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p' | head -n 1)
    [ -n "$state" ] || state=$(sacct --noheader --parsable2 --allocations --format=State --jobs "$job" 2>/dev/null | head -n 1) || true
    printf '%s' "${state%% *}"
}

state=$(state_of) || true
case $state in
    COMPLETED) echo success ;;
    PENDING | RUNNING | CONFIGURING | COMPLETING | REQUEUED | RESIZING | SUSPENDED | STAGE_OUT | SIGNALING | STOPPED) echo running ;;
    '')  # no answer: the job is unknown, or Slurm is temporarily unreachable
        if scontrol ping >/dev/null 2>&1; then echo failed; else echo running; fi ;;
    *) echo failed ;;
esac
