"""links.py SOURCE: every relative link of a Markdown file in the repository, and every file of the tree that one names in
backquotes, exists."""
import pathlib, re, sys
from agreement import fail

source = pathlib.Path(sys.argv[1])
files = [source / "README.md", source / "CONTRIBUTING.md", *sorted((source / "docs").glob("*.md"))]
wrong, seen = [], 0
folders = "core|ui|app|shaders|docs|tests|scripts|examples|packaging|presets|cmake"
for file in files:
    text = file.read_text()
    for target in re.findall(r"\]\(([^)#\s]+)(?:#[^)]*)?\)", text):
        if "://" in target:
            continue
        seen += 1
        if not (file.parent / target).exists():
            wrong.append(f"{file.relative_to(source)}: no {target}")
    for name in re.findall(rf"`((?:{folders})/[\w./-]+)`", text):
        seen += 1
        if re.search(r"NAME|SET|FOLDER", name):
            continue
        if not list(source.glob(name)) and not list(source.glob(name + ".*")):
            wrong.append(f"{file.relative_to(source)}: no {name}")
if seen < 100:
    fail(f"only {seen} links were found")
if wrong:
    fail("\n".join(wrong))
