#!/bin/bash
# measured_materials.sh NACRE_CLI PRESETS DOWNLOADS FOLDER: exported measured materials in Mitsuba 3. PyPI's wheel is installed once into
# DOWNLOADS, and stays there. FOLDER gets the files and pictures.
set -euo pipefail
here=$(dirname "$(realpath "$0")")
cli=$(realpath "$1") presets=$(realpath "$2")
mkdir -p "$3" "$4"
downloads=$(realpath "$3") folder=$(realpath "$4")

packages=(mitsuba==3.9.1 numpy==2.4.6)
place=$downloads/${packages[0]}
if [ ! -d "$place" ]; then
    rm -rf "$place.part"
    /usr/bin/python3 -m pip install --quiet --no-input --disable-pip-version-check --target "$place.part" "${packages[@]}" ||
        { echo 'mitsuba: the wheel cannot be fetched by pip' >&2; exit 1; }
    mv "$place.part" "$place"
fi

# Its variants that test sampling need LLVM.
DRJIT_LIBLLVM_PATH=$(ls /usr/lib/*/libLLVM.so.19.1 | head -n 1)
export DRJIT_LIBLLVM_PATH
PYTHONPATH=$place exec /usr/bin/python3 -B "$here/measured_materials.py" "$cli" "$presets" "$folder"
