#!/usr/bin/env bash
# Runs a sweep as shards under GNU parallel, merges them, and compares with the
# sweep in one piece. By hand; needs the package parallel.
#
#   parallel_test.sh BRACHISTO PROBLEM SHARDS
set -euo pipefail
. "$(dirname "$0")/table.sh"
brachisto=$1 problem=$2 shards=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

parallel --halt now,fail=1 "$brachisto" sweep "$problem" --jobs 1 --quiet \
  --resume --out "$scratch/part{}" --shard "{}/$shards" \
  ::: $(seq "$shards")
"$brachisto" merge "$scratch"/part* --out "$scratch/merged"

"$brachisto" sweep "$problem" --out "$scratch/whole" --quiet
cmp <(table "$scratch/merged") <(table "$scratch/whole")
echo "parallel_test: $shards shards give the table of the whole"
