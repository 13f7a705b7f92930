#!/usr/bin/env bash
# attempt.sh MARK NUMBER COMMAND...: runs a command of carom as attempt NUMBER (from 1) of a job,
# for workflow engines that repeat a job regardless of why it failed.
#
# carom exits with 75 where another attempt may help (such as a full disk), and with 1 or 2 where it
# cannot. In the latter case the code is stored in the file MARK, and further attempts exit with it
# at once. A code above 128 is that of a signal: the process was killed from outside. Attempt 1 is a
# new start by the user, and removes the mark.
set -euo pipefail
mark=$1 number=$2
shift 2
if [ "$number" -gt 1 ] && [ -e "$mark" ]; then
    printf 'carom: trying again would not help (exit code %s above)\n' "$(cat "$mark")" >&2
    exit "$(cat "$mark")"
fi
rm -f "$mark"
code=0
"$@" || code=$?
case $code in
    1 | 2)
        mkdir -p "$(dirname "$mark")"
        printf '%s' "$code" >"$mark" ;;
esac
exit "$code"
