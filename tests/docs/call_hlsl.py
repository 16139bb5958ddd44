"""call_hlsl.py NACRE_CLI SOURCE FOLDER: the exported HLSL compiles to SPIR-V, and translated from there to GLSL it gives the BRDF that
`nacre-cli eval` gives, and samples as dense as it says, whose mean is the albedo."""
import pathlib, re, subprocess, sys
import moderngl
import numpy as np
from agreement import fail, pairs_above_the_horizon, rows_of

WIDTH = 1024  # of the texture that holds the tables
PRESETS = ("brushed-gold", "satin", "smiley", "scarlet-car-paint", "matt-ceramic", "shot-velvet")
MAIN = """
struct Out {{ float3 rho : RHO; float density : DENSITY; float4 drawn : DRAWN; float3 weight : WEIGHT; float3 albedo : ALBEDO;
              float4 place : SV_Position; }};
Out main(float3 k1 : K1, float3 k2 : K2, float3 u : U) {{
    Out result;
    result.rho = mine_brdf(k1, k2);
    result.drawn = mine_sample(k2, u);
    result.density = mine_pdf(result.drawn.xyz, k2);
    result.weight = (float3)0.0;
    if (result.drawn.w > 0.0) result.weight = mine_brdf(result.drawn.xyz, k2) * (result.drawn.z / result.drawn.w);
    result.albedo = {albedo};
    result.place = (float4)0.0;
    return result;
}}
"""

cli, source, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
folder.mkdir(parents=True, exist_ok=True)
context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
context.simple_framebuffer((1, 1)).use()


def glsl_of(hlsl, name):
    """The program as GLSL, and the tables that it reads from a texture."""
    array = re.search(r"static const float mine_data\[\d+\] = \{(.*?)\};", hlsl, re.DOTALL)
    hlsl = hlsl.replace(array[0], "Texture2D<float> tables : register(t0);")
    hlsl = hlsl.replace("return mine_data[index];", f"return tables.Load(int3(index % {WIDTH}, index / {WIDTH}, 0));")
    albedo = "mine_albedo(k2)" if "mine_albedo(" in hlsl else "(float3)0.0"
    text, spirv, glsl = folder / f"{name}.vert.hlsl", folder / f"{name}.spv", folder / f"{name}.vert"
    text.write_text(hlsl + MAIN.format(albedo=albedo))
    subprocess.run(["glslangValidator", "-D", "-V", "-S", "vert", "-e", "main", text, "-o", spirv], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["spirv-cross", "--version", "330", "--no-es", spirv, "--output", glsl], check=True)
    return glsl.read_text(), np.array(array[1].split(","), "f4")


def outputs_of(glsl, tables, pairs, numbers):
    """What main() gives for each pair: rho, density, drawn, weight and albedo, side by side."""
    inputs = [re.search(rf"in vec3 (\w*{name}\w*);", glsl)[1] for name in ("k1", "k2", "u")]
    names = [re.search(rf"out \w+ (\w*{name}\w*);", glsl)[1] for name in ("rho", "density", "drawn", "weight", "albedo")]
    program = context.program(vertex_shader=glsl, varyings=names)
    tables = np.append(tables, np.zeros(-len(tables) % WIDTH, "f4"))
    context.texture((WIDTH, len(tables) // WIDTH), 1, tables.tobytes(), dtype="f4").use(0)
    data = np.hstack([pairs, numbers]).astype("f4")
    vertices = context.vertex_array(program, [(context.buffer(data.tobytes()), "3f 3f 3f", *inputs)])
    result = context.buffer(reserve=4 * 14 * len(data))
    vertices.transform(result, moderngl.POINTS)
    return np.frombuffer(result.read(), "f4").reshape(-1, 14).astype("f8")


def check(name):
    design, exported = source / f"presets/{name}.nacre", folder / f"{name}.hlsl"
    subprocess.run([cli, "export", design, "--to", "hlsl", "--prefix", "mine", "-o", exported], check=True)
    hlsl = exported.read_text()
    glsl, tables = glsl_of(hlsl, name)
    lines = pairs_above_the_horizon(10000)
    pairs = np.loadtxt(lines).reshape(-1, 2, 3)
    pairs = (pairs / np.linalg.norm(pairs, axis=2, keepdims=True)).reshape(-1, 6).astype("f4")
    lines = [" ".join(map(repr, map(float, pair))) for pair in pairs]
    found = outputs_of(glsl, tables, pairs, np.random.default_rng(1).random(pairs.shape)[:, :3] * 0.9999999)
    expected = np.array(rows_of([cli, "eval", design], lines))
    error = np.abs(found[:, :3] - expected) / np.maximum(expected, 1e-3 * expected.max())
    # Float knows the exponent of the density of a coat's narrow facets to 2e-4 only.
    if expected.max() < 0.1 or not error.max() <= (1e-3 if name == "scarlet-car-paint" else 2e-4):
        fail(f"{name}: the BRDF differs by {error.max()}")
    kept = found[:, 7] > 0
    if kept.mean() < 0.3 or not np.array_equal(found[:, 3], np.where(kept, found[:, 7], 0)):
        fail(f"{name}: a sample's density is not that of the direction")
    albedo, weight = found[:, 11:], found[:, 8:11]
    noise = 5 * (weight - albedo).std(axis=0) / np.sqrt(len(weight))
    if "mine_albedo(" in hlsl and not np.all(np.abs((weight - albedo).mean(axis=0)) < noise + 2e-3):
        fail(f"{name}: samples bring {weight.mean(axis=0)}, the albedo is {albedo.mean(axis=0)}")
    return f"{name}: BRDF within {error.max():.1e}, samples {weight.mean(axis=0)}, albedo {albedo.mean(axis=0)}"


for preset in PRESETS:
    print(check(preset))
