#!/bin/bash
# three_js.sh NACRE_CLI PRESETS DOWNLOADS FOLDER: the exported three.js module, drawn by three.js in Debian's Chromium, against the
# BRDF. playwright-core and three are fetched once, by npm, into DOWNLOADS, and stay there.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
cli=$(realpath "$1") presets=$(realpath "$2")
mkdir -p "$3" "$4"
downloads=$(realpath "$3") folder=$(realpath "$4")

for package in playwright-core-1.65.1 three-0.170.0; do
    [ -d "$downloads/$package" ] && continue
    (cd "$downloads" && npm pack --silent "${package%-*}@${package##*-}" >/dev/null) ||
        { echo "three.js: $package cannot be fetched by npm" >&2; exit 1; }
    rm -rf "$downloads/$package.part"
    mkdir "$downloads/$package.part"
    tar -xzf "$downloads/$package.tgz" -C "$downloads/$package.part" --strip-components 1
    mv "$downloads/$package.part" "$downloads/$package"
done
command -v chromium >/dev/null || { echo 'three.js: there is no chromium' >&2; exit 1; }

exec node "$here/three_js.mjs" "$cli" "$presets" "$downloads/playwright-core-1.65.1/index.mjs" "$downloads/three-0.170.0" "$folder"
