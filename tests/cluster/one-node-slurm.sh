#!/usr/bin/env bash
# one-node-slurm.sh FOLDER COMMAND...: runs COMMAND where sbatch and its like speak to a Slurm of this machine alone: its
# daemons keep all files in FOLDER, listen on 127.0.0.1 only, run as the present user, and end with COMMAND.
set -euo pipefail
folder=$(readlink -f "$1")
shift
PATH=$PATH:/usr/sbin
daemons=()

stop() {
    local pid
    for ((i = ${#daemons[@]} - 1; i >= 0; --i)); do  # slurmd before slurmctld, munged last
        pid=${daemons[i]}
        kill "$pid" 2>/dev/null || continue
        for _ in $(seq 100); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
        kill -KILL "$pid" 2>/dev/null || true
    done
}
trap stop EXIT

daemon() {  # NAME COMMAND...
    local name=$1
    shift
    "$@" >"$folder/$name.out" 2>&1 &
    daemons+=($!)
}

until_ready() {  # WHAT COMMAND...
    local what=$1
    shift
    for _ in $(seq 200); do if "$@" >/dev/null 2>&1; then return; fi; sleep 0.1; done
    printf '%s does not answer:\n' "$what" >&2
    tail -n 20 "$folder"/*.out "$folder"/*.log >&2
    exit 70
}

free_ports() {  # two that the kernel hands out at the same time
    python3 -c 'import socket
sockets = [socket.socket() for _ in range(2)]
for s in sockets: s.bind(("127.0.0.1", 0))
print(*(s.getsockname()[1] for s in sockets))'
}

read -r controller_port node_port < <(free_ports)
mkdir -p "$folder/state" "$folder/spool"
chmod 755 "$folder"
(umask 077 && head -c 128 /dev/urandom >"$folder/munge.key")
cat >"$folder/slurm.conf" <<CONF
ClusterName=carom-test
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=$controller_port
SlurmdPort=$node_port
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0,sched_min_interval=0
KillWait=2
SlurmdTimeout=300
NodeName=one NodeHostname=$(hostname) NodeAddr=127.0.0.1 CPUs=2 RealMemory=16000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
daemon munged munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" --seed-file="$folder/munged.seed"
until_ready munged munge --socket="$folder/munge.socket" --no-input
daemon slurmctld slurmctld -D
until_ready slurmctld scontrol ping
daemon slurmd slurmd -D -N one
until_ready slurmd sh -c 'sinfo --noheader --format=%t | grep -qx idle'
"$@"
