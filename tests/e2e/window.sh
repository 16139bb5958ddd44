#!/bin/bash
# window.sh FOLDER_OF_PROGRAMS PRESETS OUTPUT: the real window under Xvfb, used as by hand: a preset is
# opened, a slider and a handle dragged, the light moved, canvas and sphere painted on, an edit undone, the
# design saved, the window resized, hidden and shown again, and closed.
# Pictures of it stay in OUTPUT.
set -euo pipefail
programs=$(realpath "$1") presets=$(realpath "$2") out=$3

if [ -z "${NACRE_E2E_INSIDE:-}" ]; then
    export NACRE_E2E_INSIDE=1 LIBGL_ALWAYS_SOFTWARE=1
    exec xvfb-run --auto-servernum --server-args='-screen 0 1280x800x24' "$0" "$@"
fi

mkdir -p "$out"
rm -f "$out"/*.png "$out"/*.txt
work=$(mktemp -d)
pid=''
cleanup() {
    if [ -n "$pid" ] && kill -0 "$pid" 2>/dev/null; then kill "$pid"; fi
    rm -rf "$work"
}
trap cleanup EXIT
fail() {
    import -window root "$out/failed.png" || true
    echo "window.sh: $1 (see $out)" >&2
    exit 1
}

# A user's own settings and unsaved work stay out of it. The dialogs are Nacre's, whatever this machine has.
export HOME=$work/home XDG_CONFIG_HOME=$work/config XDG_STATE_HOME=$work/state XDG_DATA_HOME=$work/data
mkdir -p "$HOME" "$XDG_CONFIG_HOME/nacre"
echo '{"nacre_settings": 1, "system_dialogs": false}' >"$XDG_CONFIG_HOME/nacre/settings.json"

preset='Brushed gold'
[ -e "$presets/brushed-gold.nacre" ] || fail "$presets has no brushed-gold.nacre"

# The places are found by the designer without a window, before the real one runs.
# place STEPS WIDGET: left, top, right and bottom after the steps.
place() {
    printf '%b' "$1" >"$work/steps"
    "$programs/nacre-where" --script "$work/steps" "$2"
}
# at PLACE FRACTION: a point of a place as "X Y".
at() { awk -v f="$2" '{ printf "%d %d", $1 + f * ($3 - $1), ($2 + $4) / 2 }' <<<"$1"; }
pause() { sleep "${1:-0.3}"; }
click() {
    xdotool mousemove "$1" "$2"
    pause 0.4
    xdotool mousedown 1
    pause 0.3
    xdotool mouseup 1
    pause 0.6
}
# drag X1 Y1 X2 Y2
drag() {
    xdotool mousemove "$1" "$2"
    pause 0.4
    xdotool mousedown 1
    pause 0.2
    for i in 1 2 3 4 5 6 7 8 9 10; do
        xdotool mousemove $(($1 + ($3 - $1) * i / 10)) $(($2 + ($4 - $2) * i / 10))
        sleep 0.03
    done
    pause 0.1
    xdotool mouseup 1
    pause
}
# chord MODIFIER KEY: held long enough for a slow frame to see it.
chord() {
    xdotool keydown "$1"
    pause 0.1
    xdotool keydown "$2"
    pause 0.25
    xdotool keyup "$2"
    pause 0.1
    xdotool keyup "$1"
    pause 0.5
}
picture() { import -window root "$out/$1.png"; }

opened="click \"Presets\"\\nclick \"Preset $preset\"\\nclick \"Layers\"\\nwait\\n"
presets_tab=$(place '' Presets)
layers_tab=$(place '' Layers)
preset_row=$(place 'click "Presets"\n' "Preset $preset")
width=$(place "$opened" 'Width x')
sphere=$(place "$opened" Preview)
canvas=$(place "$opened" Canvas)
brush=$(place "$opened" Paint)

"$programs/nacre" >"$out/nacre.log" 2>&1 &
pid=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --class nacre | head -n 1) || fail 'no window came up'
pause 2
xdotool windowfocus "$window" || true
picture 1-start

# shellcheck disable=SC2046  # "X Y" is two words
{
    click $(at "$presets_tab" 0.5)
    click $(at "$preset_row" 0.5)
    pause 2
    click $(at "$layers_tab" 0.5)
    pause 1
    picture 2-preset
    drag $(at "$width" 0.5) $(at "$width" 0.85)
    drag $(at "$sphere" 0.5) $(at "$sphere" 0.65)
    drag $(at "$canvas" 0.5) $(at "$canvas" 0.6)
    pause 1
    picture 3-handle
    click $(at "$brush" 0.5)
    drag $(at "$canvas" 0.3) $(at "$canvas" 0.7)
    drag $(at "$sphere" 0.6) $(at "$sphere" 0.75)
    pause 1
    picture 4-edited
}

# Two saves: what was dragged, and what is left after undo.
save_as() {
    xdotool key --clearmodifiers ctrl+shift+s
    pause 0.6
    xdotool key --clearmodifiers ctrl+a
    xdotool type --clearmodifiers --delay 15 "$1"
    pause
    picture 5-save-as
    xdotool key Return
    for _ in $(seq 50); do
        [ -e "$1" ] && break
        sleep 0.1
    done
    [ -e "$1" ] || fail "nothing was saved at $1"
    pause
}
save_as "$work/edited.nacre"
chord ctrl z
save_as "$work/undone.nacre"
picture 6-undone

"$programs/nacre-cli" info "$work/edited.nacre" >"$out/edited.txt" || fail 'the saved design is refused'
"$programs/nacre-cli" info "$work/undone.nacre" >"$out/undone.txt" || fail 'the design saved after undo is refused'
grep -q '"lobe": "painted"' "$work/edited.nacre" || fail 'nothing was painted'
cmp -s "$work/edited.nacre" "$work/undone.nacre" && fail 'the drag or the undo changed nothing'

# Nobody touches it: two seconds of its own thread, which draws, in ticks.                            (proc(5))
ticks() { sed 's/.*) //' "/proc/$pid/task/$pid/stat" | awk '{ print $12 + $13 }'; }
pause 3
idle=$(ticks)
pause 2
idle=$(($(ticks) - idle))
[ $((100 * idle)) -le $((2 * 2 * $(getconf CLK_TCK))) ] || fail "left alone it takes $idle ticks in two seconds"

# The pixel in the corner of the status line, which stands elsewhere in every size.
corner() { import -window "$window" png:- | convert - -format "%[pixel:p{$(($1 - 3)),$(($2 - 3))}]" info:; }
# drawn WIDTH HEIGHT WHAT: soon, and with no further input.
drawn() {
    for _ in $(seq 30); do
        [ "$(corner "$1" "$2")" = "$corner" ] && return
        sleep 0.1
    done
    fail "not drawn after $3"
}
# Left alone, then changed at any moment of its sleep.
xdotool mousemove 5 5
corner=$(corner 1280 800)
for i in $(seq 8); do
    sleep "1.$((RANDOM % 5))$((RANDOM % 10))"
    width=$((i % 2 ? 760 + 10 * i : 1270 - 10 * i)) height=$((i % 2 ? 560 + 7 * i : 790 - 7 * i))
    xdotool windowsize "$window" $width $height
    drawn $width $height "size $width x $height"
done
pause 1.2
xdotool windowunmap "$window"
pause 1.2
xdotool windowmap "$window"
drawn $width $height 'it was hidden'
pause 1.2
xdotool windowmove "$window" 3000 0
pause 1.2
xdotool windowmove "$window" 0 0
drawn $width $height 'it was away'
xdotool windowfocus "$window" || true

xdotool key --clearmodifiers ctrl+q
for _ in $(seq 50); do
    kill -0 "$pid" 2>/dev/null || break
    sleep 0.1
done
kill -0 "$pid" 2>/dev/null && fail 'the window did not close'
wait "$pid" || fail "nacre ended with status $?"
pid=''
[ ! -s "$out/nacre.log" ] || fail "nacre complained: $(cat "$out/nacre.log")"
echo "pictures in $out"
