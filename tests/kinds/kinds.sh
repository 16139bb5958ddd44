#!/bin/bash
# kinds.sh SOURCE FOLDER: a kind is one file (two with GLSL) and one line in a list. In a copy of the tree one of each
# set is added just so; all of it must build, and each work in whatever follows from the lists: files, checks, fields,
# bake, preview against core, manifest, exports, menus, keys, buttons.
set -euo pipefail
source=$(realpath "$1") folder=$2
more=$source/tests/kinds/more
tree=$folder/tree
rm -rf "$tree"
mkdir -p "$tree"
tree=$(realpath "$tree")
(cd "$source" && git ls-files --cached --others --exclude-standard -z | xargs -0 -I{} sh -c '[ ! -e "$1" ] || printf "%s\0" "$1"' sh {} |
    tar --null --files-from=- --create) | tar --extract --directory "$tree"

# add FILE TO
add() {
    cp "$more/$1" "$tree/$2"
    echo "    $2"
}
# line LIST TEXT
line() {
    echo "$2" >>"$tree/$1"
    echo "    $1: $2"
}
# model SET NAME STRUCT
model() {
    echo "$1 $2:"
    add "$2.h" "core/model/$1/$2.h"
    add "$2.glsl" "shaders/$1/$2.glsl"
    line core/model/kinds.cmake "nacre_kind($1 $2 $3)"
}
echo 'files and lines for each kind:'
model lobes dome DomeLobe
model fresnel tinted TintedFresnel
model masking halved HalvedMasking
model diffuse evenly EvenDiffuse
model multibounce flat FlatMultibounce
model coat varnish VarnishCoat
echo 'verb count:'
add count_verb.cpp app/cli/count_verb.cpp
line app/cli/verb_list.inc 'VERB(count)'
echo 'format constants:'
add constants.cpp core/formats/constants.cpp
line core/formats/format_list.inc 'FORMAT(constants)'

echo 'part of the paper figure-4:'
add figure_4.cpp core/study/paper/figure_4.cpp
line core/study/paper_list.inc 'PART(figure_4)'

echo 'environment halves:'
add halves.cpp core/light/environments/halves.cpp
line core/light/environment_list.inc 'ENVIRONMENT(halves)'

echo 'object ring:'
add ring.cpp app/preview/objects/ring.cpp
line app/preview/object_list.inc 'OBJECT(ring)'

echo 'command rename:'
add rename.cpp app/designer/commands/rename.cpp
line app/designer/command_list.inc 'COMMAND(rename)'

echo 'plot seen:'
add seen.cpp core/plot/kinds/seen.cpp
line core/plot/plot_list.inc 'PLOT(seen)'

echo 'tool half:'
add half.cpp core/paint/tools/half.cpp
line core/paint/tool_list.inc 'TOOL(half)'

echo 'tool diamond, which selects:'
add diamond.cpp core/paint/selections/diamond.cpp
line core/paint/select_list.inc 'SELECT(diamond)'

cd "$tree"
export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1
# Of core's tests only those that run below.
cmake --preset release -DNACRE_TESTS=ON -DNACRE_BENCH=OFF \
    "-DNACRE_TEST_FILES_core=/(design_file|hostile_design|brush|stamps)_test|/random_design" >/dev/null
cmake --build --preset release --target nacre-cli nacre-test-core nacre-test-ui nacre-test-gl

cat >design.nacre <<'D'
{
  "nacre": 2,
  "name": "More kinds",
  "distribution": {"layers": [
    {"lobe": "dome", "strength": 0.25},
    {"lobe": "ggx", "alpha_x": 0.1, "alpha_y": 0.3, "weight": 0.5}]},
  "shadowing": {"model": "halved"},
  "fresnel": {"model": "tinted", "tint": [0.9, 0.5, 0.1]},
  "diffuse": {"model": "evenly", "albedo": [0.1, 0.2, 0.9]},
  "multibounce": {"model": "flat"},
  "coat": {"model": "varnish", "ior": 1.3}
}
D
bin=build/release
has() { grep -q -- "$2" "$1" || { echo "no $2 in $1:"; cat "$1"; exit 1; }; }
refused() { ! $bin/nacre-cli info wrong.nacre 2>wrong.txt && has wrong.txt "$1"; }
sed 's/0.25/2/' design.nacre >wrong.nacre && refused 'strength: must be a number from 0 to 1'
sed 's/"strength"/"power"/' design.nacre >wrong.nacre && refused 'power'
$bin/nacre-cli info design.nacre >info.txt
for word in dome 'shadowing halved' 'fresnel tinted' 'diffuse evenly' 'multiple bounces flat' 'coat varnish'; do has info.txt "$word"; done
$bin/nacre-cli check design.nacre
$bin/nacre-cli bake design.nacre -o tables
for word in '"dome"' '1 - i + i z' '"tinted"' '"tint"' 'N/(G1 G2)/2' 'specular/2' 'bounce_even e1 e2 1' 'D = 1/pi'; do has tables/manifest.json "$word"; done
/usr/bin/python3 -B tests/docs/formulas.py $bin/nacre-cli . . design.nacre
$bin/nacre-cli export design.nacre --to glsl -o brdf.glsl
{ echo '#version 330 core'; cat brdf.glsl; echo 'out vec4 c; void main() { c = vec4(nacre_brdf(vec3(0, 0, 1), vec3(0, 0, 1)), 1); }'; } >brdf.frag
glslangValidator brdf.frag
$bin/nacre-cli export design.nacre --to constants -o constants.txt
has constants.txt '^N '
$bin/nacre-cli count design.nacre | grep -qx 2
$bin/nacre-cli paper -o paper --only figure-4
has paper/index.html '<td>1.000</td>'
$bin/nacre-cli render design.nacre -o picture.png --size 64x64
$bin/nacre-cli render design.nacre -o lit.png --size 64x64 --environment halves --object ring
$bin/nacre-cli plot design.nacre --what seen -o seen.csv
printf '%s\n' 'click "Plots"' 'click "Plot seen"' 'frames 5' >plot.events
$bin/nacre-cli screenshot design.nacre -o plot.png --script plot.events
printf '%s\n' 'click "Half"' 'drag "Canvas":@10,0 "Canvas":@40,90' 'key Ctrl+S' 'frames 5' >tool.events
cp design.nacre tool.nacre
$bin/nacre-cli screenshot tool.nacre -o tool.png --script tool.events
has tool.nacre painted
printf '%s\n' 'key J' 'drag "Canvas":0.3,0.3 "Canvas":0.7,0.7' 'key Shift+Backspace' 'key Ctrl+S' 'frames 5' >tool.events
cp design.nacre tool.nacre
$bin/nacre-cli screenshot tool.nacre -o tool.png --script tool.events
has tool.nacre painted
# In its menu, and by its key.
printf '%s\n' 'click "Edit"' 'click "Rename"' 'key Ctrl+S' 'frames 5' >menu.events
printf '%s\n' 'key F8' 'key Ctrl+S' 'frames 5' >key.events
for events in menu key; do
    cp design.nacre $events.nacre
    $bin/nacre-cli screenshot $events.nacre -o $events.png --script $events.events
    has $events.nacre '"name": "Renamed"'
done
# Each stands in the sweep of extreme designs by itself.
for case in 'dome 0' 'dome 1' 'fresnel tinted 0' 'fresnel tinted 1' 'halved' 'diffuse evenly 0' 'brushed, flat'; do
    $bin/nacre-cli check --extremes --case "$case" >extremes.txt
    has extremes.txt 'pass'
done
# What follows from the lists: random designs through the file, the panels, GLSL of every kind, preview against core.
# tests PROGRAM FILTER: a filter that matches nothing fails.
tests() {
    "$bin/nacre-test-$1" "$2" >tests.txt || { cat tests.txt; exit 1; }
    ! grep -qE 'test cases: +0 ' tests.txt || { echo "$1 $2: no test"; exit 1; }
}
tests core '-tc=design: random designs*,hostile design*,brush: *'
tests ui '-tc=material: *,lobes: *'
tests gl '-ts=parity,variants'
echo 'kinds: all work'
