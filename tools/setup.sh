# shellcheck shell=bash
# SPDX-FileCopyrightText: 2026 The Handwheel developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What ./run and ./check share. Sourced, with these set:
: "${root:?the checkout}" "${assume_yes:?true: install packages without asking}"

# packages_listed WHICH: names in packages.txt; WHICH is "basic" or "full" (all).
packages_listed() {
  local line
  while IFS= read -r line; do
    [[ $line =~ ^[a-z0-9] ]] || continue
    [[ $1 == basic && $line == *"# full:"* ]] && continue
    echo "${line%% *}"
  done < "$root/tools/packages.txt"
}

packages_missing() {
  local installed name
  installed=$(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' | sed -n 's/^ii *//p' | sort -u)
  for name in $(packages_listed "$1"); do
    grep -qxF "$name" <<< "$installed" || echo "$name"
  done
}

# Installs what is missing, after asking, unless root or --yes.
install_packages() {
  if ! command -v dpkg-query apt-get > /dev/null; then
    echo "This is not Debian or a relative of it; what is needed stands in tools/packages.txt." >&2
    return 0
  fi
  local missing
  mapfile -t missing < <(packages_missing "$1")
  ((${#missing[@]})) || return 0

  local sudo=()
  if ((EUID != 0)); then
    sudo=(sudo)
    if [[ $assume_yes != true ]]; then
      local answer=
      read -r -p "Install ${missing[*]} with apt-get? [y/N] " answer || true
      if [[ $answer != [yY]* ]]; then
        echo "Missing packages: ${missing[*]}" >&2
        return 1
      fi
    fi
  fi
  step "Package lists" packages "${sudo[@]}" apt-get update -q || true
  step "Packages: ${missing[*]}" packages "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

# What took how long, for the table at the end.
times=()
note_time() {
  times+=("$(printf '%-36.36s %6d s' "$1" "$2")")
}
time_table() {
  echo "Where the time went"
  printf '  %s\n' "${times[@]}"
}

# step TITLE LOG COMMAND...: runs a command with its output in build/LOG.log, then prints the seconds it took, and the
# errors if it failed.
step() {
  local title=$1 log=$root/build/$2.log start=$SECONDS status=0
  shift 2
  mkdir -p "$root/build"
  printf '%s (%s) … ' "$title" "${log#"$root"/}"
  "$@" > "$log" 2>&1 < /dev/null || status=$?
  note_time "$title" $((SECONDS - start))
  if ((status == 0)); then
    echo "$((SECONDS - start)) s"
    return 0
  fi
  echo "failed after $((SECONDS - start)) s"
  grep -E -A 8 'error|FAILED|Error|^E:' "$log" | grep -v '^ccache ' | head -n 80 || tail -n 40 "$log"
  return "$status"
}

# build PRESET [TARGET...]: configures where needed and builds, without targets what the build preset names, and says how
# many units came from the compiler's cache. One build folder per preset.
build() {
  local preset=$1
  shift
  # ninja runs cmake again by itself when a list file changed; a moved checkout needs a new configuration.
  if ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$root/build/$preset/CMakeCache.txt" 2> /dev/null ||
    [[ ! -f $root/build/$preset/build.ninja ]]; then
    step "Configure $preset" "configure-$preset" cmake --fresh -S "$root" --preset "$preset" || return
  elif [[ $root/CMakePresets.json -nt $root/build/$preset/CMakeCache.txt ]]; then
    step "Configure $preset" "configure-$preset" cmake -S "$root" --preset "$preset" || return
    touch "$root/build/$preset/CMakeCache.txt"
  fi
  local statistics=$root/build/ccache-$preset.log
  rm -f "$statistics"
  CCACHE_STATSLOG=$statistics step "Build $preset${1:+ ($*)}" "build-$preset" \
    cmake --build "$root/build/$preset" ${1:+--target "$@"} || return
  [[ ! -f $statistics ]] || awk '/^(direct|preprocessed)_cache_hit$/ { ++hits } /^cache_miss$/ { ++misses }
    END { printf "  %d of %d units from the compiler\047s cache\n", hits, hits + misses }' "$statistics"
}
