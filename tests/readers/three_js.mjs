// three_js.mjs NACRE_CLI PRESETS PLAYWRIGHT THREE FOLDER: see three_js.sh.
//
// A sphere under two directional lights and a point light, seen along z without perspective, into a target of floats: at 1,000 pixels
// the radiance is what `nacre-cli eval` gives, within 1 % of it or of a tenth of the brightest. Part of that is the mesh, whose
// points lie off the true sphere, and where the rasteriser puts its corners.
import {execFileSync} from "node:child_process";
import {readFileSync} from "node:fs";
import {join} from "node:path";
import {pathToFileURL} from "node:url";

const [cli, presets, playwright, three, folder] = process.argv.slice(2);
const {chromium} = await import(pathToFileURL(playwright));
const SIZE = 1024, PROBES = 1000;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((value) => value / Math.hypot(...a));

// In the space of the view. Irradiance of the first two; the point light's at a distance of 1.
const lights = [{toward: unit([-0.4, 0.6, 0.7]), colour: [3, 3, 3]}, {toward: unit([0.9, -0.2, 0.3]), colour: [0.5, 1, 2]}];
const point = {position: [1.5, 1.5, 2], colour: [4, 3, 2]};
const tilt = 0.6;  // of the object's axis toward the viewer, radians

// The object's axis in the view, as three.js turns it.
const axis = [0, Math.cos(tilt), Math.sin(tilt)];

// In the browser.
async function drawn({size, pixels, lights, point, tilt}) {
    const THREE = await import("three"), {material} = await import("material");
    const renderer = new THREE.WebGLRenderer(), scene = new THREE.Scene();
    const problems = [];
    renderer.debug.onShaderError = (gl, program, vertex, fragment) => problems.push(gl.getShaderInfoLog(fragment) + gl.getShaderInfoLog(vertex));
    const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 512, 256), material());
    mesh.rotation.x = tilt;
    scene.add(mesh);
    for (const {toward, colour} of lights) {
        const light = new THREE.DirectionalLight(new THREE.Color(...colour), 1);
        light.position.set(...toward);
        scene.add(light);
    }
    const lamp = new THREE.PointLight(new THREE.Color(...point.colour), 1, 0, 2);
    lamp.position.set(...point.position);
    scene.add(lamp);
    const camera = new THREE.OrthographicCamera(-1.1, 1.1, 1.1, -1.1, 0.1, 20);
    camera.position.z = 5;
    const target = new THREE.WebGLRenderTarget(size, size, {type: THREE.FloatType});
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const read = () => {
        const texels = new Float32Array(size * size * 4);
        renderer.readRenderTargetPixels(target, 0, 0, size, size, texels);
        return pixels.map((p) => Array.from(texels.subarray(4 * p, 4 * p + 3)));
    };
    const lit = read();
    for (const light of [...scene.children]) if (light.isLight) scene.remove(light);
    scene.add(new THREE.AmbientLight(new THREE.Color(1, 1, 1), Math.PI));
    renderer.render(scene, camera);
    return {lit, ambient: read(), problems};
}

function expected(design, places) {
    const lines = [], factors = [];
    for (const [x, y] of places) {
        const n = [x, y, Math.sqrt(1 - x * x - y * y)], t = unit(cross(axis, n)), frame = [t, cross(n, t), n];
        const way = point.position.map((value, i) => value - n[i]), distance = Math.hypot(...way);
        for (const {toward, colour} of [...lights, {toward: unit(way), colour: point.colour.map((c) => c / distance ** 2)}]) {
            const k1 = frame.map((v) => dot(toward, v));
            factors.push(colour.map((c) => c * Math.max(0, k1[2])));
            lines.push([...k1, ...frame.map((v) => v[2])].join(" "));
        }
    }
    const output = execFileSync(cli, ["eval", design], {input: lines.join("\n") + "\n", maxBuffer: 2 ** 26, encoding: "utf8"});
    const brdf = output.trim().split("\n").map((line) => line.split(" ").map(Number));
    return places.map((_, i) => [0, 1, 2].map((c) => [0, 1, 2].reduce((sum, k) => sum + brdf[3 * i + k][c] * factors[3 * i + k][c], 0)));
}

// On the sphere, but near its rim, where the normal turns within a pixel, and near its pole, where the tangent does.
const pixels = [], places = [];
for (let i = 0; pixels.length < PROBES; ++i) {
    const [x, y] = [Math.floor((i * 0.7548776662466927 % 1) * SIZE), Math.floor((i * 0.5698402909980532 % 1) * SIZE)];
    const place = [x, y].map((p) => ((p + 0.5) / SIZE * 2 - 1) * 1.1);
    const r = Math.hypot(...place), pole = [axis[0], axis[1]];
    if (r > 0.95 || Math.hypot(place[0] - pole[0], place[1] - pole[1]) < 0.1) continue;
    pixels.push(y * SIZE + x);
    places.push(place);
}

const browser = await chromium.launch({executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]});
try {
    for (const [name, prefix] of [["satin", "nacre"], ["brushed-gold", "my_gold"]]) {
        const design = join(presets, name + ".nacre"), file = join(folder, name + ".js");
        execFileSync(cli, ["export", design, "--to", "three", "--prefix", prefix, "-o", file], {stdio: "ignore"});
        const page = await browser.newPage();
        const files = {"/": `<script type="importmap">{"imports": {"three": "/build/three.module.js", "material": "/material.js"}}</script>`,
                       "/material.js": readFileSync(file)};
        await page.route("http://nacre.test/**", (route) => {
            const path = new URL(route.request().url()).pathname;
            route.fulfill({contentType: path === "/" ? "text/html" : "text/javascript", body: files[path] ?? readFileSync(join(three, path))});
        });
        await page.goto("http://nacre.test/");
        const {lit, ambient, problems} = await page.evaluate(drawn, {size: SIZE, pixels, lights, point, tilt});
        if (problems.length) throw new Error(`${name}: ${problems.join("\n")}`);
        const values = expected(design, places), brightest = Math.max(...values.flat());
        let worst = 0;
        values.forEach((value, i) => value.forEach((v, c) => {
            worst = Math.max(worst, Math.abs(lit[i][c] - v) / Math.max(v, brightest / 10));
        }));
        const shade = ambient.map((value) => value[0]);
        console.log(`${name}: ${PROBES} pixels differ by at most ${(100 * worst).toFixed(2)} %; ambient light ${Math.min(...shade).toFixed(3)} to ${Math.max(...shade).toFixed(3)}`);
        if (!(worst <= 0.01)) throw new Error(name);
        if (!(Math.min(...shade) > 0.1 && Math.max(...shade) <= 1.001)) throw new Error(`${name}: ambient light`);
        await page.close();
    }
} finally {
    await browser.close();
}
