#!/bin/bash
# library.sh PREFIX EXAMPLES SCRATCH: a program of another project finds nacre::core below PREFIX by CMake and by
# pkg-config, is built of it, and says what the installed nacre-cli says.
set -euo pipefail
prefix=$(realpath "$1") examples=$(realpath "$2") scratch=$3
fail() {
    echo "library.sh: $1" >&2
    exit 1
}
mkdir -p "$scratch"
cd "$scratch"
version=$("$prefix/bin/nacre" --version)

# What is installed of headers is what core/nacre.h includes, all of it and nothing else.
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name nacre.pc)")
export PKG_CONFIG_PATH
[ "$(pkg-config --modversion nacre)" = "$version" ] || fail "pkg-config knows another version than $version"
# shellcheck disable=SC2046
included=$(echo '#include "core/nacre.h"' | g++ -std=c++20 -x c++ $(pkg-config --cflags nacre) -M -MT all - |
    tr -s ' \\' '\n' | xargs realpath -s --quiet | grep "^$prefix/" | sort -u)
installed=$(find "$prefix/include" -type f | sort)
[ "$included" = "$installed" ] ||
    fail "core/headers.cmake and what core/nacre.h includes differ: $(diff <(echo "$included") <(echo "$installed"))"

# The same program both ways; a renderer's warnings are not ours to make.
cmake -S "$examples" -B cmake -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release >configure.log 2>&1 ||
    fail "find_package(nacre) fails: $(cat configure.log)"
cmake --build cmake >build.log 2>&1 || fail "examples/ do not build: $(cat build.log)"
# shellcheck disable=SC2046
g++ -std=c++20 -O2 -Wall -Wextra -Wpedantic -Werror "$examples/reflect.cpp" -o reflect $(pkg-config --cflags --libs nacre)

# close A B: the numbers of two lines differ by no more than 0.005 each.
close() {
    paste -d ' ' <(echo "$1") <(echo "$2") |
        awk 'NF != 6 { exit 1 } { for (i = 1; i <= 3; i++) if (($i - $(i + 3)) ^ 2 > 0.005 ^ 2) exit 1 }'
}
# agrees DESIGN: the BRDF to the last digit; and the samples' albedo is the tables'.
agrees() {
    local directions='0.48 0.36 0.8 -0.36 0.16 0.92' said
    said=$(echo "$directions" | "$prefix/bin/nacre-cli" eval "$1")
    [ "$said" != '0 0 0' ] || fail "nacre-cli eval says that $1 is black"
    for program in cmake/reflect ./reflect; do
        # shellcheck disable=SC2086
        $program "$1" $directions >said || fail "$program $1 fails"
        [ "$(head -n 1 said)" = "$said" ] || fail "of $1 $program says $(head -n 1 said), nacre-cli eval $said"
        close "$(sed -n 2p said)" "$(sed -n 3p said)" || fail "the samples of $1 and its albedo differ: $(cat said)"
    done
}
agrees "$prefix/share/nacre/presets/ggx-steel.nacre"
agrees "$prefix/share/nacre/presets/smiley.nacre"

# A design with a picture: the library that reads it is found from a program that lies anywhere.
"$prefix/bin/nacre-cli" render "$prefix/share/nacre/presets/ggx-steel.nacre" --size 64x64 -o disk.png
cat >pictured.nacre <<'D'
{"nacre": 1, "name": "Pictured", "distribution": {"layers": [{"lobe": "painted", "image": "disk.png"}]}}
D
agrees pictured.nacre

# refused WORDS: of the design with a picture both programs say one line with the words.
refused() {
    for program in cmake/reflect ./reflect; do
        if $program pictured.nacre 0 0 1 0 0 1 >said 2>&1; then fail "$program reads a picture, though: $1"; fi
        grep -q "$1" said && [ "$(wc -l <said)" = 1 ] || fail "$program says no line with '$1' but: $(cat said)"
    done
}
module=$prefix/lib/nacre/modules/libnacre-pictures.so
mv "$module" kept.so
refused 'libnacre-pictures.so, which reads and writes pictures, is missing'
sed "s/${version//./\\.}/9.9.9/g" kept.so >"$module"
refused "is of Nacre 9.9.9, this program of $version"
mv kept.so "$module"
