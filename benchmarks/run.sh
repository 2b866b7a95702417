#!/usr/bin/env bash
# All benchmarks one after the other, each into its own log:
#
#   benchmarks/run.sh BUILD       those that are done within half an hour
#   benchmarks/run.sh BUILD long  what takes longer
#
# BUILD is a build folder with the benchmarks in it, such as build/release;
# results and logs go to BUILD/benchmarks/results. A step that fails does not
# keep the others from running; the end of this is then an error.
set -uo pipefail
cd "$(dirname "$0")/.."

build=${1:-}
suite=${2:-usual}
if [ ! -d "$build" ] || { [ "$suite" != usual ] && [ "$suite" != long ]; }; then
  sed -n '4,5s/^# \{0,1\}//p' benchmarks/run.sh >&2
  exit 2
fi
results=$build/benchmarks/results
brachisto=$build/src/app/brachisto
program=$build/benchmarks/benchmark_
mkdir -p "$results/logs"

failed=()
summary=()

# step NAME COMMAND …: what it prints goes to the log of that name.
step() {
  local name=$1 code=0 verdict=done times
  shift
  printf '== %s\n' "$name"
  local TIMEFORMAT='%R %U %S'
  times=$( { time "$@" >"$results/logs/$name.log" 2>&1; } 2>&1 ) || code=$?
  if [ "$code" -ne 0 ]; then
    verdict="failed with code $code"
    failed+=("$name")
    tail -n 3 "$results/logs/$name.log" | sed 's/^/   /'
  fi
  read -r wall user system <<<"$(tail -n 1 <<<"$times")"
  summary+=("$(printf '%-32s %8.1f s %8.1f s  %s' "$name" "$wall" \
    "$(awk "BEGIN {print $user + $system}")" "$verdict")")
}

chain() {
  local elements
  for elements in 4 200 2000 20000; do
    for task in factor newton ipopt; do
      printf '\n%s, %s elements, chain: ' "$task" "$elements"
      "${program}chain" "$task" --elements "$elements" || return
    done
    [ "$elements" -le 2000 ] || continue
    for task in newton ipopt; do
      printf '\n%s, %s elements, KLU or MUMPS: ' "$task" "$elements"
      "${program}chain" "$task" --elements "$elements" --general || return
    done
  done
}

# One at a time where time is measured.
usual() {
  step micro "${program}micro" --benchmark_out="$results/micro.json" \
    --benchmark_out_format=json
  step chain chain
  step fsolve "${program}fsolve" --out "$results/fsolve"
  step compare "$brachisto" compare problems/paper/fig04_reference_case.yaml \
    --out "$results/compare" --force
  for file in problems/work_precision/*.yaml; do
    name=$(basename "$file" .yaml)
    step "work_precision_$name" "$brachisto" work-precision "$file" \
      --out "$results/work_precision/$name" --force
  done
  step scaling "${program}scaling" --out "$results/scaling"
  step peers "${program}peers" --out "$results/peers"
  step million_nodes "$brachisto" solve problems/large/million_nodes.yaml
  step gallery "${program}gallery" --jobs 2 --out "$results/gallery.csv"
  step honesty "${program}honesty" --jobs 2 --out "$results/honesty.csv"
  step random_starts "${program}random_starts" --jobs 2 \
    --out "$results/random_starts.csv"
  step reference_set "${program}reference_set" --out "$results/reference_set"
  step campaign "${program}campaign" --jobs 2 --out "$results/campaign.csv"
  step worlds "${program}worlds" --jobs 2 --out "$results/worlds.csv"
  step hostile benchmarks/hostile/hostile.py --program "$brachisto" --jobs 2 \
    --out "$results/hostile.csv"
}

long() {
  step limits "${program}limits" --jobs 2 --out "$results/limits.csv"
  step limits_in_worlds "${program}limits" --worlds --witness --count 200 \
    --jobs 2 --out "$results/random_limits_in_worlds.csv"
  step limits_with_losses "${program}limits" --worlds --losses --witness \
    --count 50 --jobs 2 --out "$results/random_limits_with_losses.csv"
  step limited_worlds "${program}limited_worlds" --jobs 2 \
    --out "$results/limited_worlds.csv"
  step honesty_limited "${program}honesty" --limited --jobs 2 \
    --out "$results/honesty_limited.csv"
  step feasibility "${program}feasibility" --jobs 2 \
    --out "$results/feasibility.csv"
  step scaling_million "${program}scaling" --sizes 1000000 --mumps-up-to 0 \
    --out "$results/scaling_million"
  step fsolve_long "${program}fsolve" --seconds 900 --largest-dense 3200 \
    --out "$results/fsolve_long"
}

"$suite"
{
  printf '%-32s %10s %10s\n' step wall CPU
  printf '%s\n' "${summary[@]}"
  printf 'all: %d min %d s\n' $((SECONDS / 60)) $((SECONDS % 60))
} | tee "$results/logs/summary_$suite.txt"
if [ ${#failed[@]} -gt 0 ]; then
  printf 'FAILED: %s; see %s\n' "${failed[*]}" "$results/logs"
  exit 1
fi
