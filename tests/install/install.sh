#!/bin/bash
# install.sh BUILD_FOLDER SCRATCH EXAMPLES: what `cmake --install` puts into a folder works from there, after the folder
# was moved, and holds nothing that a desktop would refuse.
set -euo pipefail
script=$(realpath "$0")
build=$(realpath "$1") scratch=$2 examples=$(realpath "$3")
fail() {
    echo "install.sh: $1" >&2
    exit 1
}
# quiet COMMAND...: no word on either stream.
quiet() {
    local words
    words=$("$@" 2>&1) || fail "$* failed: $words"
    [ -z "$words" ] || fail "$* says: $words"
}

rm -rf "$scratch"
mkdir -p "$scratch"
cmake --install "$build" --prefix "$scratch/before" >/dev/null
mv "$scratch/before" "$scratch/prefix"
cd "$scratch/prefix"
share=$PWD/share

# The command line: its own library of pictures; and the designer's presets, which only this prefix has.
bin/nacre-cli render share/nacre/presets/ggx-steel.nacre --size 32x32 -o ../steel.png
[ -s ../steel.png ] || fail 'the installed nacre-cli writes no picture'
printf 'click "Presets"\nclick "Preset Brushed gold"\n' >../steps
bin/nacre-cli screenshot --size 800x600 --script ../steps -o ../window.png || fail 'the installed designer has no presets'
bin/nacre --version | grep -q '^[0-9]' || fail 'the installed nacre does not start'

"$(dirname "$script")/library.sh" . "$examples" ../library

# Every verb and option has a place in the manual.
zcat share/man/man1/nacre-cli.1.gz | sed 's/\\-/-/g' >../nacre-cli.1
verbs=$(bin/nacre-cli --help | sed '1,/^Subcommands:/d; /^$/,$d' | awk '{ print $1 }')
[ -n "$verbs" ] || fail 'nacre-cli --help names no verb'
options=$(for verb in $verbs; do bin/nacre-cli "$verb" --help; done | grep -oE '^ +(-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u)
for word in $verbs $options; do
    grep -qE -- "(^|[^-a-z])$word([^-a-z]|$)" ../nacre-cli.1 || fail "the manual, packaging/nacre-cli.1, says nothing of $word"
done

if command -v man >/dev/null; then
    for page in share/man/man1/*.gz; do
        words=$(MANWIDTH=80 man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
        [ -z "$words" ] || fail "man says of $page: $words"
    done
fi
if command -v desktop-file-validate >/dev/null; then quiet desktop-file-validate share/applications/nacre.desktop; fi
if command -v appstreamcli >/dev/null; then appstreamcli validate --no-net share/metainfo/*.xml; fi
if command -v update-mime-database >/dev/null; then
    quiet env XDG_DATA_DIRS="$share" update-mime-database share/mime
    grep -q ':application/x-nacre:\*\.nacre' share/mime/globs2 || fail '*.nacre is no MIME type'
fi
