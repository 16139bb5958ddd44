#!/bin/bash
# web_page.sh NACRE_CLI PRESETS DOWNLOADS FOLDER: the exported web page in Debian's Chromium against Nacre's own pictures.
# playwright-core is fetched once, by npm, into DOWNLOADS, and stays there. FOLDER gets the pages and pictures of them.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
cli=$(realpath "$1") presets=$(realpath "$2")
mkdir -p "$3" "$4"
downloads=$(realpath "$3") folder=$(realpath "$4")

package=playwright-core-1.65.1
if [ ! -d "$downloads/$package" ]; then
    (cd "$downloads" && npm pack --silent playwright-core@1.65.1 >/dev/null) ||
        { echo 'web page: playwright-core cannot be fetched by npm' >&2; exit 1; }
    rm -rf "$downloads/$package.part"
    mkdir "$downloads/$package.part"
    tar -xzf "$downloads/$package.tgz" -C "$downloads/$package.part" --strip-components 1
    mv "$downloads/$package.part" "$downloads/$package"
fi
command -v chromium >/dev/null || { echo 'web page: there is no chromium' >&2; exit 1; }

exec node "$here/web_page.mjs" "$cli" "$presets" "$downloads/$package/index.mjs" "$folder"
