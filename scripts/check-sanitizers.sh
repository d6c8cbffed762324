#!/usr/bin/env bash
# scripts/check-sanitizers.sh [asan|tsan] [FOLDER...]: builds test_FOLDER with the sanitizer and runs its tests but the
# long ones. Without folders those of the numerics and of the session: what runs while a scene does.
source "$(dirname "${BASH_SOURCE[0]}")/setup.sh"
preset=${1:-asan}
shift || true
folders=("$@")
if ((${#folders[@]} == 0)); then
  case $preset in
    asan) folders=(bases energies expression geometry grid materials math output params scene_io session simulation solvers transfers) ;;
    # Threads meet in the session, in the loops of the numerics and in studies.
    tsan) folders=(session simulation) ;;
    *) say "asan or tsan, not $preset"; exit 2 ;;
  esac
fi
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1:strict_string_checks=1} UBSAN_OPTIONS=${UBSAN_OPTIONS:-halt_on_error=1:print_stacktrace=1}
export TSAN_OPTIONS=${TSAN_OPTIONS:-halt_on_error=1}
build "$preset" "${folders[@]/#/test_}"
pattern=$(IFS='|' && printf '^(%s): ' "${folders[*]}")
cd "$root/build/$preset"
exec ctest --output-on-failure -LE 'long|timing' -R "$pattern" -j "$(nproc 2>/dev/null || echo 2)"
