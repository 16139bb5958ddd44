"""measured_materials.py NACRE_CLI PRESETS FOLDER: measured materials that Nacre exports, in Mitsuba 3's own `measured` plug-in: values and
densities of 2,000 pairs, its chi-square test of sampling, and a sphere beside Nacre's own picture."""
import math, pathlib, subprocess, sys
import numpy as np
import mitsuba as mi

cli, presets, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
PAIRS = 2000
# The most that an isotropic, an anisotropic and a painted preset may show: median, 95th percentile, misplaced light, bytes.
LIMITS = {
    "ggx-steel": (0.003, 0.04, 0.01, 1e6),
    "brushed-gold": (0.003, 0.06, 0.015, 24e6),
    "star": (0.01, 0.06, 0.015, 24e6),
}
SLACK = 1.2  # of a spectral file: it has six wavelengths where the other has three colours, in as many bytes


def fail(problem):
    sys.exit(f"failed: {problem}")


def nacre(*arguments, **more):
    done = subprocess.run([cli, *arguments], capture_output=True, text=True, **more)
    if done.returncode != 0:
        fail(f"{arguments}: {done.stderr}")
    return done.stdout


def export(name, to, ending):
    file = folder / f"{name}{ending}"
    nacre("export", presets / f"{name}.nacre", "--to", to, "--error", "0.005", "-o", file)
    return file


def exact(name, rows):
    text = nacre("eval", presets / f"{name}.nacre", input="\n".join(" ".join(f"{x:.9g}" for x in row) for row in rows) + "\n")
    return np.array([[float(x) for x in line.split()] for line in text.splitlines()])[:, :3]


def incident(random):
    sine, phi = math.sqrt(random.random()), 2 * math.pi * random.random()
    return [sine * math.cos(phi), sine * math.sin(phi), math.sqrt(1 - sine * sine)]


def drawn(bsdf, wavelengths):
    """Pairs that Mitsuba draws itself, with its values and densities."""
    random, context, at = np.random.default_rng(3), mi.BSDFContext(), mi.SurfaceInteraction3f()
    if wavelengths:
        at.wavelengths = wavelengths
    pairs, values, densities = [], [], []
    while len(pairs) < PAIRS:
        at.wi = incident(random)
        sample, _ = bsdf.sample(context, at, random.random(), [random.random(), random.random()])
        wo = np.array(sample.wo).ravel()
        if sample.pdf <= 0 or wo[2] <= 0:
            continue
        density = float(bsdf.pdf(context, at, sample.wo))
        if abs(density - sample.pdf) > 1e-3 * sample.pdf:
            fail(f"density {sample.pdf} where it was drawn, {density} when asked")
        pairs.append([*np.array(at.wi).ravel(), *(wo / np.linalg.norm(wo))])
        values.append(np.array(bsdf.eval(context, at, sample.wo)).ravel())
        densities.append(density)
    return np.array(pairs), np.array(values), np.array(densities)


def compare(what, values, wanted, densities, limits):
    error, weight = np.abs(values - wanted), 1 / densities
    relative = error / np.maximum(wanted, 1e-12)
    got = np.median(relative), np.quantile(relative, 0.95), (error * weight).sum() / (wanted * weight).sum()
    print(f"{what}: median {got[0]:.4f}, 95th percentile {got[1]:.4f}, misplaced {got[2]:.4f}, largest weight {(wanted * weight).max():.2f}")
    if not all(value <= limit for value, limit in zip(got, limits)):
        fail(f"{what}: at most {limits}")


def rgb_files():
    mi.set_variant("scalar_rgb")
    for name, (*limits, most) in LIMITS.items():
        file = export(name, "rgl-rgb", "_rgb.bsdf")
        if file.stat().st_size > most:
            fail(f"{file}: {file.stat().st_size} bytes")
        pairs, values, densities = drawn(mi.load_dict({"type": "measured", "filename": str(file)}), None)
        wanted = exact(name, pairs) * pairs[:, 5:6]
        compare(file.name, values[:, 1], wanted[:, 1], densities, limits)


def spectral_files():
    """At 507 nm, a wavelength of the file, where the three primaries have these reflectances."""
    mi.set_variant("scalar_spectral")
    for name, (*limits, most) in LIMITS.items():
        file = export(name, "rgl-spectral", "_spec.bsdf")
        if file.stat().st_size > most:
            fail(f"{file}: {file.stat().st_size} bytes")
        pairs, values, densities = drawn(mi.load_dict({"type": "measured", "filename": str(file)}), [507] * 4)
        wanted = exact(name, pairs) * pairs[:, 5:6] @ np.array([0, 0.9361564454, 0.0638435546])
        compare(file.name, values[:, 0], wanted, densities, [limit * SLACK for limit in limits])


def sampling():
    """Mitsuba's chi-square test of what it draws, from general directions, on and beside the seam of the azimuth. At normal
    incidence it fails by the reader's own density, which is singular where the half vector meets the normal."""
    mi.set_variant("llvm_ad_rgb")
    from mitsuba.chi2 import BSDFAdapter, ChiSquareTest, SphericalDomain

    for name in LIMITS:
        plugin = f'<string name="filename" value="{folder / name}_rgb.bsdf"/>'
        for theta, phi in ((20, 30), (35, 140), (50, -70), (60, 100), (70, -160), (40, 200), (45, 180)):
            t, p = math.radians(theta), math.radians(phi)
            wi = [math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)]
            sample, density = BSDFAdapter("measured", plugin, wi=wi)
            test = ChiSquareTest(SphericalDomain(), sample, density, sample_dim=3, sample_count=500000, res=101, ires=16)
            if not test.run(0.01, 21, quiet=True):
                fail(f"{name}, theta {theta}, phi {phi}: {test.messages}")
            print(f"{name}: chi-square from theta {theta}, phi {phi}: p {test.p_value:.3f}")


def sphere():
    """A sphere beside Nacre's own picture, away from its edge, where the two filter differently."""
    mi.set_variant("scalar_rgb")
    size, theta, phi, radius = 128, 42, 125, 0.39
    picture = folder / "steel.exr"
    nacre("render", presets / "ggx-steel.nacre", "--size", f"{size}x{size}", "--light", f"{theta},{phi}", "-o", picture)
    ours = np.array(mi.Bitmap(str(picture)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False))
    t, p = math.radians(theta), math.radians(phi)
    toward = [math.sin(t) * math.cos(p), math.sin(t) * math.sin(p), math.cos(t)]
    view = mi.ScalarTransform4f().look_at(origin=[0, 0, 4], target=[0, 0, 0], up=[0, 1, 0])
    theirs = np.array(mi.render(mi.load_dict({
        "type": "scene",
        "integrator": {"type": "direct"},
        "sensor": {"type": "orthographic", "to_world": view @ mi.ScalarTransform4f().scale([0.5 / radius, 0.5 / radius, 1]),
                   "film": {"type": "hdrfilm", "width": size, "height": size, "rfilter": {"type": "box"}},
                   "sampler": {"type": "multijitter", "sample_count": 64}},
        "emitter": {"type": "directional", "direction": [-x for x in toward], "irradiance": {"type": "rgb", "value": 4.5}},
        "shape": {"type": "sphere", "bsdf": {"type": "measured", "filename": str(folder / "ggx-steel_rgb.bsdf")}},
    })))[:, :, :3]
    across = (np.arange(size) + 0.5) / size - 0.5
    inside = np.hypot(*np.meshgrid(across, across)) < 0.95 * radius
    difference = np.abs(theirs - ours)[inside].sum() / ours[inside].sum()
    print(f"sphere: {difference:.4f} of the light differs")
    if not difference < 0.01:
        fail("sphere: at most 0.01 may differ")
    mi.Bitmap(theirs).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.UInt8, True).write(str(folder / "steel-mitsuba.png"))


folder.mkdir(parents=True, exist_ok=True)
rgb_files()
spectral_files()
sampling()
sphere()
