#!/usr/bin/env bash
# Kills the manager and workers of a sweep by turns, at random moments, again and
# again, and checks that nothing that was stored is lost, changed, damaged or done
# twice, and that the table in the end is that of an undisturbed run, except for
# times.
#
#   kill_test.sh BRACHISTO PROBLEM KILLS [SEED]
set -euo pipefail
. "$(dirname "$0")/table.sh"
brachisto=$1 problem=$2 kills=$3
RANDOM=${4:-1}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
die() { echo "kill_test: $*" >&2; exit 1; }

start=$(date +%s%N)
"$brachisto" sweep "$problem" --out "$scratch/calm" --quiet
# Kills come at any moment of a run, its beginning and its end included.
range=$(($(date +%s%N) / 1000000 - start / 1000000))
[ "$range" -lt 700 ] || range=700
table "$scratch/calm" >"$scratch/calm.csv"

round=0 done_kills=0 of_manager=0 of_worker=0
while [ "$done_kills" -lt "$kills" ]; do
  round=$((round + 1))
  out=$scratch/round$round
  : >"$scratch/before.csv"
  while true; do
    "$brachisto" sweep "$problem" --out "$out" --resume --quiet &
    manager=$!
    sleep "0.$(printf '%03d' $((RANDOM % range)))"
    if [ "$done_kills" -lt "$kills" ] && kill -0 "$manager" 2>/dev/null; then
      read -r -a workers \
        <<<"$(cat "/proc/$manager/task/$manager/children" 2>/dev/null || true)"
      if [ "$of_manager" -le "$of_worker" ] || [ ${#workers[@]} -eq 0 ]; then
        kill -KILL "$manager" 2>/dev/null && of_manager=$((of_manager + 1))
      else
        victim=${workers[RANDOM % ${#workers[@]}]}
        kill -KILL "$victim" 2>/dev/null && of_worker=$((of_worker + 1))
        # The manager goes on with another worker, for a while at least.
        if [ $((RANDOM % 4)) -ne 0 ]; then
          sleep "0.$(printf '%03d' $((RANDOM % 900)))"
          kill -KILL "$manager" 2>/dev/null || true
        fi
      fi
      done_kills=$((of_manager + of_worker))
    fi
    code=0
    wait "$manager" 2>/dev/null || code=$?
    if [ -e "$out/sweep.sqlite" ]; then
      "$brachisto" export "$out" --csv >/dev/null 2>"$scratch/said" ||
        die "a store cannot be read: $(cat "$scratch/said")"
      table "$out" >"$scratch/after.csv"
      # Stored rows stay as they are: those of before are among those of after.
      lost=$(sort "$scratch/before.csv" |
        comm -23 - <(sort "$scratch/after.csv") | wc -l)
      [ "$lost" -eq 0 ] || die "$lost stored rows were lost or changed"
      twice=$(cut -d, -f1 "$scratch/after.csv" | sort | uniq -d | wc -l)
      [ "$twice" -eq 0 ] || die "$twice scenes were stored twice"
      cp "$scratch/after.csv" "$scratch/before.csv"
    fi
    [ "$code" -eq 0 ] && break
    [ "$code" -eq 137 ] || die "the sweep ended with $code"
  done
  cmp -s "$scratch/calm.csv" "$scratch/before.csv" ||
    die "round $round: the table differs from that of an undisturbed run"
  rm -rf "$out"
done
echo "kill_test: $done_kills kills ($of_manager of the manager, $of_worker of a" \
  "worker) in $round rounds; every table equals the undisturbed one"
