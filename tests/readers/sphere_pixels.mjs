// The values of a picture's pixels on the sphere, from the BRDF that `nacre-cli eval` gives: what shaders/sphere.frag, surface.frag
// and develop.frag make of it, written anew.
import {execFileSync} from "node:child_process";

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((value) => value / Math.hypot(...a));

const lamp = 4.5;  // irradiance
const curve = (x) => (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3;
const filmic = (x) => Math.min(1, Math.max(0, curve(2 * x) / curve(11.2)));
const srgb = (x) => x > 0.0031308 ? 1.055 * x ** (1 / 2.4) - 0.055 : 12.92 * x;

// Of a pixel counted from the bottom left.
function noise(x, y, channel) {
    let n = (Math.imul(x, 1664525) + Math.imul(y, 22695477) + Math.imul(channel, 2891336453) + 1013904223) >>> 0;
    n = Math.imul(n ^ (n >>> 16), 2246822519) >>> 0;
    n = Math.imul(n ^ (n >>> 13), 3266489917) >>> 0;
    return ((n ^ (n >>> 16)) >>> 8) / 16777216;
}

// Red, green and blue of 0 to 255, not rounded, of pixels (from the top left) well inside the sphere's outline.
export function evaluated(cli, design, view, {width, height}, places) {
    const [theta, phi] = [view.theta, view.phi].map((angle) => angle * Math.PI / 180);
    const light = [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
    const axis = view.turn.slice(3, 6), scale = 0.39 * Math.min(width, height), lines = [], cosines = [];
    for (const [x, y] of places)
        for (const [i, j] of [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]]) {
            const [a, b] = [(x + i - width / 2) / scale, (height - y - j - height / 2) / scale];
            const n = [a, b, Math.sqrt(1 - a * a - b * b)], t = unit(cross(axis, n)), frame = [t, cross(n, t), n];
            cosines.push(Math.max(0, dot(light, n)));
            lines.push([...frame.map((v) => dot(light, v)), ...frame.map((v) => v[2])].join(" "));
        }
    const output = execFileSync(cli, ["eval", design], {input: lines.join("\n") + "\n", maxBuffer: 2 ** 26, encoding: "utf8"});
    const brdf = output.trim().split("\n").map((line) => line.split(" ").map(Number));
    if (brdf.length !== lines.length) throw new Error(`eval: ${brdf.length} lines for ${lines.length}`);
    return places.map(([x, y], index) => [0, 1, 2].map((c) => {
        let sum = 0;
        for (let k = 4 * index; k < 4 * index + 4; ++k) sum += filmic(brdf[k][c] * lamp * cosines[k] * 2 ** view.exposure) / 4;
        const dither = 0.5 * (noise(x, height - 1 - y, c) - noise(x, height - 1 - y, c + 3));
        return Math.min(255, Math.max(0, 255 * srgb(sum) + dither));
    }));
}
