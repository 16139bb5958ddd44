#!/bin/bash
# pictures.sh PROGRAM DOWNLOADS: reads the environments and normal maps of @pmndrs/assets and of Blender with
# PROGRAM, nacre-real-pictures. They are fetched once, into the folder DOWNLOADS, and stay there.
set -euo pipefail
program=$(realpath "$1")
mkdir -p "$2"
cd "$2"

fail() {
    echo "pictures: $1" >&2
    exit 1
}

package=pmndrs-assets-1.7.0.tgz
if [ ! -s $package ]; then
    npm pack --silent @pmndrs/assets@1.7.0 || fail 'the package cannot be fetched by npm'
fi
if ! ls blender-data_*_all.deb >/dev/null 2>&1; then
    apt-get -o APT::Sandbox::User=root download blender-data || fail 'blender-data cannot be fetched by apt-get'
fi

rm -rf pictures
mkdir -p pictures/environments pictures/normals pictures/npm pictures/blender
tar -xzf $package -C pictures/npm
dpkg-deb -x blender-data_*_all.deb pictures/blender
# unpack FOLDER ENDING: the files that stand in the package's modules in base 64.
unpack() {
    local module
    for module in pictures/npm/package/"$1"/*."$2".js; do
        sed -n 's/.*base64,\([A-Za-z0-9+\/=]*\).*/\1/p' "$module" | base64 -d >"pictures/$3/$(basename "$module" .js)"
    done
}
unpack hdri exr environments
unpack normals webp normals
for file in pictures/blender/usr/share/blender/datafiles/studiolights/world/*.exr; do
    cp "$file" "pictures/environments/blender-$(basename "$file")"
done

[ "$(find pictures/environments -type f | wc -l)" -eq 26 ] || fail 'there must be 26 environments'
[ "$(find pictures/normals -type f | wc -l)" -eq 29 ] || fail 'there must be 29 normal maps'
"$program" environments pictures/environments/*
"$program" normals pictures/normals/*
