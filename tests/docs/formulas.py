"""formulas.py NACRE_CLI SOURCE FOLDER [DESIGN...]: the formulas of manifest.json, evaluated as they are written there, give the BRDF of
`nacre-cli eval`: of every kind of core/model/kinds.cmake with its defaults, isotropic, anisotropic, leaning, modulated, painted, tinted, retro-reflective and coated; or of these designs alone."""
import json, pathlib, re, subprocess, sys
import numpy as np
from agreement import fail, pairs_above_the_horizon, require_close, rows_of
from stranger import Stranger

cli, source, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
kinds = {}
for kind_set, name in re.findall(r"^nacre_kind\((\w+) (\w+) ", (source / "core/model/kinds.cmake").read_text(), re.MULTILINE):
    kinds.setdefault(kind_set, []).append(name)


def picture(side):
    """Bright where x and y are, nowhere 0."""
    return {"width": side, "height": side, "values": [1 + column + 3 * (side - row) for row in range(side) for column in range(side)]}


needed = {"painted": {"image": picture(5)}}
wide = {"gaussian": {"sigma_x": 0.6, "sigma_y": 0.3}, "ggx": {"alpha_x": 0.2, "alpha_y": 0.5}, "beckmann": {"alpha_x": 0.5, "alpha_y": 0.3}}
haze = {"lobe": "uniform", "weight": 0.3}
materials = {"schlick": {"f0": [0.9, 0.5, 0.1]}}
diffuses = {"lambertian": {"kd": 0.6, "ks": 0.4, "albedo": [0.9, 0.5, 0.2]}, "coupled": {"albedo": [0.9, 0.5, 0.2]}, "facets": {"kd": 0.7, "ks": 0.3, "albedo": [0.9, 0.5, 0.2]}}
turned = [{}, {"rotation": 25}, {"tilt": 20, "azimuth": 50}, {"rotation": 30, "tilt": 25, "modulation": {"image": picture(4), "strength": 0.7}}]


def of(names, index):
    return names[index % len(names)]


def designs():
    """Each lobe in each place, the models in turn; then every two models of different sets."""
    for index, lobe in enumerate(kinds["lobes"]):
        for place, placed in enumerate(turned):
            layers = [{"lobe": lobe, **needed.get(lobe, {}), **(wide.get(lobe, {}) if place else {}), **placed}, haze]
            yield f"{lobe}-{place}", layers, of(kinds["masking"], index + place), of(kinds["fresnel"], index), of(kinds["diffuse"], index // 2 + place)
    layers = [{"lobe": "ggx", "alpha_x": 0.3, "alpha_y": 0.4}]
    for fresnel in kinds["fresnel"]:
        for diffuse in kinds["diffuse"]:
            yield f"{fresnel}-{diffuse}", layers, of(kinds["masking"], len(fresnel) + len(diffuse)), fresnel, diffuse
    for masking in kinds["masking"]:
        yield f"{masking}-no-clamp", [{**layers[0], "tilt": 30}], masking, "none", "none"
    yield "bright", layers, kinds["masking"][0], "schlick", "coupled"
    red, blue = {"tint": [0.9, 0.1, 0.2]}, {"tint": [0.1, 0.3, 0.8]}
    for index, fresnel in enumerate(kinds["fresnel"]):
        for diffuse in kinds["diffuse"]:
            yield f"tints-{fresnel}-{diffuse}", [{**layers[0], "tilt": 25, **red}, {**layers[0], "tilt": 30, "azimuth": 180, **blue}], of(kinds["masking"], index), fresnel, diffuse
            yield f"tint-{fresnel}-{diffuse}", [{**layers[0], **red}, {**haze, **red}], of(kinds["masking"], index), fresnel, diffuse
    for index, masking in enumerate(kinds["masking"]):
        yield f"retro-{masking}", [{**layers[0], "tilt": 25, "azimuth": 40}, haze], masking, of(kinds["fresnel"], index), of(kinds["diffuse"], index)
    yield "retro-bright", [{**layers[0], "tilt": 25, **red}, {**haze, **blue}], kinds["masking"][0], "schlick", "coupled"
    for index, fresnel in enumerate(kinds["fresnel"]):
        yield f"coat-{fresnel}", [{**layers[0], **turned[index % 3]}, haze], of(kinds["masking"], index), fresnel, of(kinds["diffuse"], index)
    yield "coat-leaning", [{**layers[0], "tilt": 25, **red}, {**haze, **blue}], kinds["masking"][0], "schlick", "coupled"
    yield "whole-sphere", [{"lobe": "uniform", "domain": "sphere"}, layers[0]], kinds["masking"][0], "none", "none"


folder = folder / "formulas"
folder.mkdir(parents=True, exist_ok=True)
# The last two: k1 at the normal, k2 as low as k1 on the other side.
pairs = pairs_above_the_horizon(40) + ["0 0 1 0.3 0.1 0.9", "0.96 0 0.28 -0.96 0 0.28"]
numbers = np.array([line.split() for line in pairs], float).reshape(-1, 2, 3)
numbers /= np.linalg.norm(numbers, axis=2, keepdims=True)


# What is fitted takes seconds: of every symmetry, and with one factor, three, none and tints.
fitted = {f"ggx-{place}" for place in range(4)} | {"gaussian-0", "measured-coupled", "none-none", "tints-schlick-coupled", "tint-conductor-none"}


def bounces_of(name, diffuse):
    """In turn where they are allowed."""
    if name.endswith("no-clamp") or diffuse == "metal":
        return "none"
    return "momentum" if name in fitted else of([kind for kind in kinds["multibounce"] if kind != "momentum"], sum(map(ord, name)))


def check(design):
    tables = folder / design.stem
    subprocess.run([cli, "bake", design, "-o", tables, "--tolerance", "0.01"], check=True, stdout=subprocess.DEVNULL)
    stranger, expected = Stranger(tables), rows_of([cli, "eval", design, "--tolerance", "0.01"], pairs)
    if not max(max(row) for row in expected) > 0.05:
        fail(f"{design}: the directions show nothing")
    require_close(design.stem, [stranger.brdf(*pair) for pair in numbers], expected, 1e-6)


if sys.argv[4:]:
    for design in sys.argv[4:]:
        check(pathlib.Path(design))
    sys.exit()
for name, layers, masking, fresnel, diffuse in designs():
    design = folder / f"{name}.nacre"
    specular = {"specular": {"intensity": 2.5}} if name.endswith("bright") else {}
    if name.startswith("retro"):
        specular["retro"] = {"weight": 0.4}
    if name.startswith("coat"):
        specular["coat"] = {"model": "clear", "roughness": 0.3, "ior": 1.4, "colour": [0.9, 0.6, 0.3]}
    design.write_text(json.dumps({"nacre": 2, "distribution": {"layers": layers}, **specular, "multibounce": {"model": bounces_of(name, diffuse)},
                                  "shadowing": {"model": masking, "clamp": not name.endswith("no-clamp")},
                                  "fresnel": {"model": fresnel, **materials.get(fresnel, {})}, "diffuse": {"model": diffuse, **diffuses.get(diffuse, {})}}))
    check(design)
