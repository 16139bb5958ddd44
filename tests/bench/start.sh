#!/bin/bash
# start.sh FOLDER_OF_PROGRAMS PRESETS [RUNS]: the real window under Xvfb. For each preset, from the start of the
# process to the first shaded picture on the screen: seconds on the clock and of the processor, the median of
# RUNS (5), and the same with Mesa's cache of compiled shaders off, as in the first run ever. Then the share of
# one core that the window takes in ten seconds in which nobody touches it.
set -euo pipefail
programs=$(realpath "$1") presets=$(realpath "$2") runs=${3:-5}

if [ -z "${NACRE_START_INSIDE:-}" ]; then
    export NACRE_START_INSIDE=1 LIBGL_ALWAYS_SOFTWARE=1
    exec xvfb-run --auto-servernum --server-args='-screen 0 1280x800x24' "$0" "$@"
fi

# What the last line of --time-start tells: "picture WALL CPU".
picture() { "$programs/nacre" --time-start "$1" | tail -n 1; }
# median COLUMN: of the lines read.
median() { sort -n -k "$1,$1" | awk -v c="$1" '{ v[NR] = $c } END { printf "%.2f", v[int((NR + 1) / 2)] }'; }
# timed PRESET: "WALL CPU", medians.
timed() {
    local lines
    lines=$(for _ in $(seq "$runs"); do picture "$1"; done)
    printf '%s %s' "$(median 2 <<<"$lines")" "$(median 3 <<<"$lines")"
}

uptime
printf '%-26s %10s %10s %16s %16s\n' 'first picture after' 's' 's of CPU' 's, no cache' 's of CPU'
for preset in "$presets"/*.nacre; do
    picture "$preset" >/dev/null # fills the cache
    warm=$(timed "$preset")
    cold=$(MESA_SHADER_CACHE_DISABLE=true timed "$preset")
    # shellcheck disable=SC2086  # two words each
    printf '%-26s %10s %10s %16s %16s\n' "$(basename "$preset" .nacre)" $warm $cold
done

"$programs/nacre" "$presets/satin.nacre" &
pid=$!
trap 'kill "$pid"' EXIT
# Fields 14 and 15, user and system, in ticks.                                                        (proc(5))
ticks() { sed 's/.*) //' "/proc/$pid/stat" | awk '{ print $12 + $13 }'; }
# Until the final tables are baked, which takes long where others share the machine; a minute at the most.
for _ in $(seq 30); do
    before=$(ticks)
    sleep 2
    [ $(($(ticks) - before)) -gt 2 ] || break
done
before=$(ticks)
sleep 10
after=$(ticks)
awk -v t=$((after - before)) -v hz="$(getconf CLK_TCK)" \
    'BEGIN { printf "idle: %.1f %% of a core over 10 s\n", 100 * t / hz / 10 }'
