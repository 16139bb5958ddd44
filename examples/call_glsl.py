"""call_glsl.py FILE: calls the function of an exported GLSL file (docs/glsl.md). Reads pairs of directions k1 k2, six numbers a line; prints
the BRDF in red, green and blue. Needs no display: EGL, with a GPU or without."""
import re
import sys

import moderngl
import numpy as np

WIDTH = 1024  # of the texture that holds the tables

text = open(sys.argv[1]).read()
prefix = re.search(r"vec3 (\w+)_brdf\(", text)[1]

# The tables as a texture in place of constants: the shader compiles at once, whatever their size.
array = re.search(rf"const float {prefix}_data\[\d+\] = float\[\d+\]\((.*?)\);", text, re.DOTALL)
tables = np.array(array[1].split(","), "f4")
text = text.replace(array[0], "uniform sampler2D tables;")
fetch = f"texelFetch(tables, ivec2(index % {WIDTH}, index / {WIDTH}), 0).r"
text = text.replace(f"return {prefix}_data[index];", f"return {fetch};")

main = f"""
in vec3 k1, k2;
out vec3 rho;
void main() {{ rho = {prefix}_brdf(normalize(k1), normalize(k2)); }}
"""
context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
context.simple_framebuffer((1, 1)).use()
program = context.program(vertex_shader="#version 330\n" + text + main, varyings=["rho"])
tables.resize(-(-len(tables) // WIDTH) * WIDTH)
context.texture((WIDTH, len(tables) // WIDTH), 1, tables.tobytes(), dtype="f4").use(0)

pairs = np.loadtxt(sys.stdin, dtype="f4", ndmin=2)
vertices = context.vertex_array(program, [(context.buffer(pairs.tobytes()), "3f 3f", "k1", "k2")])
result = context.buffer(reserve=12 * len(pairs))
vertices.transform(result, moderngl.POINTS)
for row in np.frombuffer(result.read(), "f4").reshape(-1, 3):
    print(*row)
