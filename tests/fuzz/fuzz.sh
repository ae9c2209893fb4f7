#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# fuzz.sh SECONDS [NAME...]: searches for inputs that crash a reader, make it slow or make it take too much memory: each
# fuzz test of build/fuzz (preset fuzz), or those named, for so many seconds. What was found is in build/fuzz/found; the
# inputs that reach new places stay in build/fuzz/corpus and are where the next search starts.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
seeds=$root/tests/fuzz/seeds
seconds=${1:?seconds for each}
shift
names=("$@")
((${#names[@]})) || mapfile -t names < <(find "$root/build/fuzz/tests" -maxdepth 1 -name '*Fuzz' -printf '%f\n' | sort)

# UBSan prints and goes on by default; leaks are looked for by libFuzzer itself.
export ASAN_OPTIONS=allocator_may_return_null=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1
failed=()
for name in "${names[@]}"; do
  corpus=$root/build/fuzz/corpus/$name
  found=$root/build/fuzz/found/$name
  mkdir -p "$corpus" "$found"
  dictionary=()
  [[ -f $seeds/$name.dict ]] && dictionary=(-dict="$seeds/$name.dict")
  log=$root/build/fuzz/$name.log
  status=0
  "$root/build/fuzz/tests/$name" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -max_len=65536 \
    -print_final_stats=1 -artifact_prefix="$found/" "${dictionary[@]}" "$corpus" "$seeds/$name" > "$log" 2>&1 || status=$?
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  if ((status == 0)); then
    echo "$name: ${runs:-?} inputs in $seconds s, $(find "$corpus" -type f | wc -l) kept"
  else
    failed+=("$name")
    echo "$name: failed, see $log"
    grep -E 'ERROR|SUMMARY|runtime error|written to' "$log" || tail -n 20 "$log"
  fi
done
((${#failed[@]} == 0))
