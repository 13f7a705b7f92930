#!/usr/bin/env bash
# attempt.sh MARK NUMBER COMMAND...: runs a command of carom as attempt NUMBER, from 1, of a job that an engine repeats
# whatever it failed of.
#
# carom ends with 75 where another try may help (a full disk), and with 1 or 2 where it cannot. After those the file MARK
# holds the code, and further attempts end with it at once. A code above 128 is that of a signal: the machine ended the
# process, not carom. Attempt 1 is the user's new start, and removes the mark.
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
