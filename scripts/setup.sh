# shellcheck shell=bash
# Sourced by run.sh, test.sh and .ci/run. Everything here talks on stderr: stdout belongs to the program.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
assume_yes=${assume_yes:-no}

say() { printf '%s\n' "$*" >&2; }

# Where headers and libraries live, first match wins.
prefixes=(/usr /usr/local /opt/homebrew /home/linuxbrew/.linuxbrew)

# probe KIND:NAME: is this need met already?
probe() {
  local kind=${1%%:*} name=${1#*:} prefix
  case $kind in
    cmd) command -v "$name" >/dev/null ;;
    pc) command -v pkg-config >/dev/null && pkg-config --exists "$name" ;;
    header)
      for prefix in "${prefixes[@]}"; do [ -e "$prefix/include/$name" ] && return 0; done
      return 1 ;;
    file)
      for prefix in "${prefixes[@]}"; do
        # shellcheck disable=SC2086  # the pattern is meant to expand
        compgen -G "$prefix/lib/${name#\*/}" >/dev/null && return 0
        compgen -G "$prefix/lib/$name" >/dev/null && return 0
        compgen -G "$prefix/lib64/${name#\*/}" >/dev/null && return 0
      done
      return 1 ;;
  esac
}

# The package manager of this machine, and its column in packages.tsv.
find_manager() {
  local pair
  for pair in apt-get:3 dnf:4 pacman:5 brew:6; do
    if command -v "${pair%%:*}" >/dev/null; then
      manager=${pair%%:*} column=${pair##*:}
      return 0
    fi
  done
  manager='' column=3
}

# missing_packages WHAT...: names of the packages of needs that are not met.
missing_packages() {
  local line purpose need fields
  while IFS=$'\t' read -r -a fields; do
    line=${fields[0]:-}
    [[ -z $line || $line == \#* ]] && continue
    purpose=$line need=${fields[1]}
    [[ " $* " == *" $purpose "* ]] || continue
    [[ ${fields[column - 1]} == - ]] && continue
    probe "$need" || printf '%s\n' "${fields[column - 1]}"
  done <"$root/scripts/packages.tsv" | sort -u
}

install_command() {
  case $manager in
    apt-get) install=(apt-get install -y --no-install-recommends) ;;
    dnf) install=(dnf install -y) ;;
    pacman) install=(pacman -S --needed --noconfirm) ;;
    brew) install=(brew install) ;;
  esac
}

# install_missing WHAT...: installs what is not there; asks before sudo.
install_missing() {
  local missing as=() answer
  find_manager
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]} == 0)) && return 0
  if [ -z "$manager" ]; then
    say "These are needed and no known package manager (apt, dnf, pacman, brew) is here; their Debian names: ${missing[*]}"
    exit 2
  fi
  install_command
  if [ "$manager" != brew ] && [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null; then
      say "These packages are missing, and there is no sudo. As root: ${install[*]} ${missing[*]}"
      exit 2
    fi
    as=(sudo)
    if [ "$assume_yes" != yes ]; then
      if [ ! -t 0 ]; then
        say "These packages are missing: ${missing[*]}"
        say "Install them with: sudo ${install[*]} ${missing[*]}   or run this again with --yes."
        exit 2
      fi
      printf 'Missing: %s\nInstall them with sudo %s? [y/N] ' "${missing[*]}" "$manager" >&2
      read -r answer
      if [[ $answer != [yY]* ]]; then
        say "Nothing installed."
        exit 2
      fi
    fi
  fi
  say "Installing: ${missing[*]}"
  if [ "$manager" = apt-get ]; then
    as+=(env DEBIAN_FRONTEND=noninteractive)
    "${as[@]}" apt-get update -qq >&2 </dev/null || say "The package lists could not be refreshed; going on with those at hand."
  fi
  "${as[@]}" "${install[@]}" "${missing[@]}" >&2 </dev/null
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]} == 0)) || say "Still not found after installing: ${missing[*]}. Going on; the build will say what it misses."
}

# What native code depends on: a checkout that moved to another processor or compiler is built anew.
machine_key() {
  { grep -m1 -E '^(flags|Features)' /proc/cpuinfo 2>/dev/null || uname -m; c++ --version 2>/dev/null | head -n 1; } | cksum
}

# build PRESET [TARGET...]: configures once, then builds what is left to do.
build() {
  local preset=$1 folder="$root/build/$1" jobs
  shift
  jobs=$(nproc 2>/dev/null || sysctl -n hw.ncpu 2>/dev/null || echo 2)
  if [ ! -f "$folder/build.ninja" ] || [ "$(cat "$folder/machine" 2>/dev/null)" != "$(machine_key)" ]; then
    say "Configuring build/$preset"
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
    (cd "$root" && cmake --preset "$preset") >&2
    [ ! -f "$folder/machine" ] || cmake --build "$folder" --target clean >&2
    machine_key >"$folder/machine"
  fi
  cmake --build "$folder" -j "$jobs" ${1:+--target "$@"} >&2
}

# take_yes ARGS...: sets assume_yes where --yes is among them, and `arguments` to the others.
take_yes() {
  local argument
  arguments=()
  for argument in "$@"; do
    if [ "$argument" = --yes ]; then assume_yes=yes; else arguments+=("$argument"); fi
  done
}
