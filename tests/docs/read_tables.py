"""read_tables.py NACRE_CLI SOURCE FOLDER: examples/read_tables.py has at most 40 lines and evaluates baked tables as nacre-cli does;
of presets g and R1 are within the errors that the manifest states of what adaptive integration gives."""
import json, pathlib, subprocess, sys
from agreement import fail, pairs_above_the_horizon, require_close, rows_of

cli, source, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
reader = source / "examples/read_tables.py"
if (count := len(reader.read_text().splitlines())) > 40:
    fail(f"{reader}: {count} lines, at most 40 are promised")
folder.mkdir(parents=True, exist_ok=True)
ggx = {"lobe": "ggx", "alpha_x": 0.3, "alpha_y": 0.5}
leaning = {
    "half": [{**ggx, "tilt": 20}],
    "none": [{**ggx, "rotation": 20}, {"lobe": "beckmann", "alpha_x": 0.3, "alpha_y": 0.3, "tilt": 20, "azimuth": 100}],
}
for name, layers in leaning.items():
    design = {"nacre": 1, "distribution": {"layers": layers}, "diffuse": {"model": "coupled"}}
    (folder / f"{name}.nacre").write_text(json.dumps(design))
presets = [folder / f"{name}.nacre" for name in ("ggx-steel", "brushed-gold", "satin")]
for preset in presets:  # with the paper's metal term where they have bounces, which the reader does not know
    design = json.loads((source / "presets" / preset.name).read_text())
    if design.pop("multibounce", None):
        design["diffuse"] = {"model": "metal"}
    preset.write_text(json.dumps(design))
tinted = {
    "two-tints": [{**ggx, "tilt": 20, "tint": [0.9, 0.1, 0.2]}, {**ggx, "tilt": 30, "azimuth": 180, "tint": [0.1, 0.2, 0.8]}],
    "one-tint": [{**ggx, "tint": [0.9, 0.1, 0.2]}],
}
for name, layers in tinted.items():
    design = {"nacre": 2, "distribution": {"layers": layers}, "specular": {"intensity": 1.5},
              "diffuse": {"model": "metal" if name == "one-tint" else "coupled"}}
    (folder / f"{name}.nacre").write_text(json.dumps(design))
pairs = pairs_above_the_horizon(100)
first = [" ".join(line.split()[:3]) for line in pairs]
symmetries = set()
for design in [*presets, *(folder / f"{name}.nacre" for name in [*leaning, *tinted])]:
    tables = folder / design.stem
    subprocess.run([cli, "bake", design, "-o", tables], check=True, stdout=subprocess.DEVNULL)
    manifest = json.loads((tables / "manifest.json").read_text())
    symmetries.add(manifest["symmetry"])
    got = rows_of([sys.executable, reader, tables], pairs)
    colours = 3 if design.stem == "two-tints" else 1
    g_p_r1 = [row[:2] + row[2 + colours:] for row in rows_of([cli, "tables", design], first)]
    require_close(f"{design.stem}: g, P and R1 of the tables", [row[:2 + colours] for row in got], g_p_r1, 1e-6)
    require_close(f"{design.stem}: BRDF of the tables", [row[2 + colours:] for row in got], rows_of([cli, "eval", design], pairs), 1e-5)
    if design not in presets:
        continue
    # The claim is of G = max(g, N z), in parts of it.
    N, claims = manifest["constants"]["N"], manifest["error"]["by_the_bake"]
    exact = rows_of([cli, "tables", design, "--exact"], first[:10])
    floors = [N * float(line.split()[2]) for line in first]
    errors = [[max(row[0], floor) / max(truth[0], floor) - 1] for row, truth, floor in zip(got, exact, floors)]
    require_close(f"{design.stem}: g against adaptive integration", errors, [[0]] * 10, claims["g"]["worst"])
    require_close(f"{design.stem}: R1 against adaptive integration", [row[2:3] for row in got[:10]], [row[3:4] for row in exact], claims["R"]["worst"])
if symmetries != {"isotropic", "quarter", "half", "none"}:
    fail(f"not every symmetry was read: {symmetries}")
