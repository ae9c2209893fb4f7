#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fuzz.sh SECONDS [NAME...]: searches for inputs that crash a reader, make it slow or make it take too much memory: each
# fuzz test of build/fuzz (preset fuzz), or those named, for so many seconds, one on each core. What was found is in
# build/fuzz/found; the inputs that reach new places stay in build/fuzz/corpus and are where the next search starts.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
seeds=$root/tests/fuzz/seeds
seconds=${1:?seconds for each}
shift
names=("$@")
((${#names[@]})) || mapfile -t names < <(find "$root/build/fuzz/tests" -maxdepth 1 -name '*Fuzz' -printf '%f\n' | sort)

# UBSan prints and goes on by default; leaks are looked for by libFuzzer itself.
export ASAN_OPTIONS=allocator_may_return_null=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1

# fuzz_one NAME: false when something was found.
fuzz_one() {
  local name=$1 corpus=$root/build/fuzz/corpus/$1 found=$root/build/fuzz/found/$1 log=$root/build/fuzz/$1.log
  local dictionary=() patience=10 runs status=0
  # Seconds for one input. RepairFuzz itself judges the CPU time of a repair, which here may be a hundred seconds on a
  # slow machine; this only stops what does not end.
  [[ $name == RepairFuzz ]] && patience=300
  mkdir -p "$corpus" "$found"
  [[ -f $seeds/$name.dict ]] && dictionary=(-dict="$seeds/$name.dict")
  "$root/build/fuzz/tests/$name" -max_total_time="$seconds" -timeout="$patience" -rss_limit_mb=2048 -max_len=65536 \
    -print_final_stats=1 -artifact_prefix="$found/" "${dictionary[@]}" "$corpus" "$seeds/$name" > "$log" 2>&1 || status=$?
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  if ((status == 0)); then
    echo "$name: ${runs:-?} inputs in $seconds s, $(find "$corpus" -type f | wc -l) kept"
    return
  fi
  echo "$name: failed, see $log"
  grep -E 'ERROR|SUMMARY|runtime error|written to' "$log" || tail -n 20 "$log"
  return "$status"
}

# As many at a time as there are cores; xargs fails when one of them did.
export -f fuzz_one
export root seeds seconds
# shellcheck disable=SC2016  # for the inner shell
printf '%s\0' "${names[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c 'fuzz_one "$1"' _ {}
