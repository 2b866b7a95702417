#!/usr/bin/env bash
# Proves the recipe for a Slurm job array on one machine: starts munge and Slurm
# in a directory of its own, runs a sweep as an array, merges the parts, and
# compares with the sweep in one piece. By hand, as root; needs the packages
# slurm-wlm and munge.
#
#   slurm_test.sh BRACHISTO PROBLEM SHARDS
set -euo pipefail
. "$(dirname "$0")/table.sh"
brachisto=$(realpath "$1") problem=$(realpath "$2") shards=$3
scratch=$(mktemp -d)
chmod 755 "$scratch"
mkdir "$scratch/spool" "$scratch/state"
host=$(hostname -s)
pids=()
finish() {
  [ ${#pids[@]} -eq 0 ] || kill "${pids[@]}" 2>/dev/null || true
  munged --stop --socket="$scratch/munge/socket" 2>/dev/null || true
  rm -rf "$scratch"
}
trap finish EXIT

# The key and the socket are of this test alone.
install -d -m 755 "$scratch/munge"
head -c 1024 /dev/urandom >"$scratch/munge/key"
chmod 600 "$scratch/munge/key"
munged --force --key-file="$scratch/munge/key" \
  --socket="$scratch/munge/socket" --pid-file="$scratch/munge/pid" \
  --log-file="$scratch/munge/log" --seed-file="$scratch/munge/seed"

cat >"$scratch/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$scratch/munge/socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmctldLogFile=$scratch/slurmctld.log
SlurmdLogFile=$scratch/slurmd.log
SlurmctldPort=16817
SlurmdPort=16818
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP MaxTime=60
CONF
export SLURM_CONF=$scratch/slurm.conf
slurmctld -D -f "$SLURM_CONF" >/dev/null 2>&1 &
pids+=($!)
slurmd -D -f "$SLURM_CONF" -N "$host" >/dev/null 2>&1 &
pids+=($!)
for _ in $(seq 60); do
  sinfo -h -o %T 2>/dev/null | grep -q idle && break
  sleep 1
done
sinfo

cat >"$scratch/array.sh" <<JOB
#!/bin/sh
#SBATCH --ntasks=1
#SBATCH --output=$scratch/log-%a
exec "$brachisto" sweep "$problem" --resume --quiet --jobs 1 \
  --shard "\$SLURM_ARRAY_TASK_ID/$shards" \
  --out "$scratch/part\$SLURM_ARRAY_TASK_ID"
JOB
sbatch --wait --array="1-$shards" "$scratch/array.sh" || {
  cat "$scratch"/log-* "$scratch"/slurm*.log >&2
  exit 1
}
"$brachisto" merge "$scratch"/part* --out "$scratch/merged"

"$brachisto" sweep "$problem" --out "$scratch/whole" --quiet
cmp <(table "$scratch/merged") <(table "$scratch/whole")
echo "slurm_test: an array of $shards jobs gives the table of the whole"
