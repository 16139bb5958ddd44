"""rooms.py SOURCE BUILD: what the compiler read for core is of the room itself or of one that it needs, and the designer's
programs read nothing of the study."""
import pathlib, re, subprocess, sys

source, build = map(pathlib.Path, sys.argv[1:3])
needs = {}
for room, words in re.findall(r"^nacre_room\((\w+)(.*)\)$", (source / "core/CMakeLists.txt").read_text(), re.MULTILINE):
    direct = re.sub(r"LIBRARIES.*", "", words).replace("NEEDS", "").split()
    needs[room] = {room}.union(*(needs.get(other, {other}) for other in direct))
needs["pictures"] = {"base", "image", "pictures"}
unlinked = {"study", "pictures"}
library = set(needs) - unlinked
allowed = {f"core/CMakeFiles/nacre_{room}.dir/": others for room, others in needs.items()}
allowed |= {folder: library for folder in ("ui/", "app/preview/", "app/designer/", "app/headless/", "app/desktop/")}

wrong, read = [], 0
dependencies = subprocess.run(["ninja", "-t", "deps"], cwd=build, check=True, capture_output=True, text=True).stdout
for block in dependencies.split("\n\n"):
    object_file = block.split(":", 1)[0]
    rooms = next((others for start, others in allowed.items() if object_file.startswith(start)), None)
    if rooms is None:
        continue
    read += 1
    for file in block.splitlines()[1:]:
        found = re.search(r"\bcore/(\w+)/.*\.(h|cpp|inl|inc)$", file)
        if found and "generated/" not in file and found[1] not in rooms:
            wrong.append(f"{object_file} reads {file.strip()}")
if read < len(allowed):
    sys.exit(f"ninja knows of {read} objects: is {build} built by Ninja?")
if wrong:
    sys.exit("\n".join(sorted(set(wrong))))
