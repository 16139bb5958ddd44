"""call_glsl.py NACRE_CLI SOURCE FOLDER: examples/call_glsl.py has at most 40 lines, and the exported function gives the BRDF that
`nacre-cli eval` gives, of isotropic, anisotropic and painted presets and under a prefix of one's own."""
import pathlib, subprocess, sys
from agreement import fail, pairs_above_the_horizon, require_close, rows_of

cli, source, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
reader = source / "examples/call_glsl.py"
if (count := len(reader.read_text().splitlines())) > 40:
    fail(f"{reader}: {count} lines, at most 40 are promised")
folder.mkdir(parents=True, exist_ok=True)
pairs = pairs_above_the_horizon(100) + ["0 0 1 0.5 0.5 -0.5"]
for name in ("ggx-steel", "brushed-gold", "satin", "smiley"):
    design, exported = source / f"presets/{name}.nacre", folder / f"{name}.glsl"
    subprocess.run([cli, "export", design, "--to", "glsl", "--prefix", "my_metal", "-o", exported], check=True)
    got, expected = rows_of([sys.executable, reader, exported], pairs), rows_of([cli, "eval", design], pairs)
    if not any(value > 0.1 for row in expected for value in row) or any(expected[-1]):
        fail(f"{name}: the directions show nothing")
    require_close(f"{name}: BRDF in float", got, expected, 1e-4)
