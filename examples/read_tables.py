"""read_tables.py FOLDER: evaluates what `nacre-cli bake` wrote there. Reads lines k1 k2; prints g, P and R1 of k1, then the BRDF (docs/tables.md)."""
import json, sys, numpy as np, OpenImageIO as oiio
folder, m = sys.argv[1] + "/", json.load(open(sys.argv[1] + "/manifest.json"))
c, material, symmetry, f0 = m["constants"], m["material"], m["symmetry"], np.array(m["material"].get("f0", 0))
table = {t["quantity"]: oiio.ImageBuf(folder + t["file"]).get_pixels(oiio.FLOAT) for t in m["tables"]}
lobes = {"gaussian": lambda x, y, z: np.exp(-(x * x + y * y) / z**2), "ggx": lambda x, y, z: (x * x + y * y + z * z) ** -2,
         "beckmann": lambda x, y, z: np.exp(-(x * x + y * y) / z**2) / z**4, "hemisphere": lambda x, y, z: 1}
if material["fresnel"] != "schlick" or material["shadowing"] == "correlated" or material["diffuse"] == "lambertian" or {"retro", "multibounce", "coat"} & material.keys():
    sys.exit("read_tables.py: knows Schlick's Fresnel, masking without azimuth, the diffuse models none, coupled and metal, no bounces, no retro-reflection and no coat")
def turns(a, b):  # azimuth of (a, b) in quarter turns
    t = (abs(b) - abs(a)) / (abs(a) + abs(b) or 1) - (not a and not b)
    u = 1 - np.copysign(0.5 - t * (6 - t * t) / 10, a)
    return 4 - u if b < 0 else u
def look_up(quantity, at, azimuth):  # bilinear
    t, (rows, columns, _) = table[quantity], table[quantity].shape
    y = azimuth * {"isotropic": 0, "quarter": rows - 1, "half": (rows - 1) / 2, "none": rows / 4}[symmetry]
    x, j = min(at, 1) * (columns - 1), min(int(y), rows - 1)
    i, j2 = min(int(x), columns - 2), (j + 1) % rows if symmetry == "none" else min(j + 1, rows - 1)
    a, b = (t[row, i] * (1 - x + i) + t[row, i + 1] * (x - i) for row in (j, j2))
    return a * (1 - y + j) + b * (y - j)
def direction(k):  # g, G, P, R1 and R of k
    s, lean, a, b, y = np.hypot(k[0], k[1]), c["lean"], *c["stretch"], c["axis"][0] * k[1] - c["axis"][1] * k[0]
    x, y = (abs if symmetry == "quarter" else float)(np.dot(c["axis"], k[:2])), abs(y) if symmetry in ("quarter", "half") else y
    psi, q = turns(a * (x + lean * s), b * y * np.sqrt(1 - lean**2)), np.hypot(a * x, b * y)
    w, nz = 2 * q / (k[2] * c["g_normal"] + 2 * q), c["N"] * k[2]
    g = max(0, np.dot(c["moment"], k[:2]) + (k[2] * c["g_normal"] + 2 * q) * look_up("A", w, psi)[0])
    v, rho, G = (w + s / (k[2] + s)) / 2, (psi + turns(x, y)) / 2, max(g, nz) if material["clamp"] else g
    r1 = np.maximum(look_up("albedo", v, rho), 0)
    r = f0 * r1 + (1 - f0) * np.maximum((1 - k[2]) ** 5 * r1 + look_up("residual", v, rho), 0)
    return g, G, nz / G, r1 * g / G, np.array(material.get("tint", 1)) * r * g / G
def density(layer, h):  # one layer's part of p, times its tint
    x, y, z = (np.dot(layer["axis_" + axis], h) for axis in "xyz")
    return layer["scale"] * lobes[layer["kind"]](*layer["inverse_width"] * np.array([x, y]), z) * np.array(layer.get("tint", material.get("tint", 1))) if z > 0 else 0
for line in sys.stdin:
    k1, k2 = (k / np.linalg.norm(k) for k in np.array(line.split(), float).reshape(2, 3))
    (g, G1, P, R1, Ra), (_, G2, P2, _, Rb), cosine = direction(k1), direction(k2), np.linalg.norm(k1 + k2) / 2
    fresnel, albedo = f0 + (1 - f0) * (1 - cosine) ** 5, np.array(material.get("diffuse_albedo", 0))
    one, q = albedo if material["diffuse"] == "metal" else 1, sum(density(a, (k1 + k2) / (2 * cosine)) for a in m["distribution"]["layers"])
    diffuse, facets = material["coupling"] * albedo * np.maximum(one - Ra, 0) * np.maximum(one - Rb, 0), material.get("specular_intensity", 1) * q * fresnel
    print(g, P, *R1, *facets * c["N"] / (4 * G1 * G2 * (1 - max(1 - P, 0) * max(1 - P2, 0) if material["shadowing"] == "smith_correlated" else 1)) + diffuse)
