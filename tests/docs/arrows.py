"""arrows.py SOURCE: the arrows between core's rooms in docs/architecture.md are those of the includes, each way."""
import pathlib, re, sys
from agreement import fail

source = pathlib.Path(sys.argv[1])
drawn = {}
for room, others in re.findall(r"^ +core/(\w+) +-> (.*)$", (source / "docs/architecture.md").read_text(), re.MULTILINE):
    drawn[room] = set(re.findall(r"\w+", others)) - {"nothing"}
included = {folder.name: set() for folder in (source / "core").iterdir() if folder.is_dir()}
for room, others in included.items():
    for file in (source / "core" / room).rglob("*"):
        if file.suffix in (".h", ".cpp", ".inl"):
            includes = re.findall(r'# *include "(?:core/(\w+)/|(shaders)/)', file.read_text())
            others.update(core or shaders for core, shaders in includes if core != room)
if drawn != included:
    fail(f"docs/architecture.md draws {drawn}, the includes are {included}")
