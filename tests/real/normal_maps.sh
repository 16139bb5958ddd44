#!/bin/bash
# normal_maps.sh PROGRAM DOWNLOADS: reads the normal maps of @pmndrs/assets, which pictures.sh has unpacked into
# DOWNLOADS, with PROGRAM, nacre-real-normals.
set -euo pipefail
maps=("$2"/pictures/normals/*.webp)
if [ "${#maps[@]}" -ne 29 ]; then
    echo "normal_maps: there must be 29 maps in $2/pictures/normals" >&2
    exit 1
fi
"$1" "${maps[@]}"
