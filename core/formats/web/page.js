// What the pointer, the keys and the fields do to the view.
const light_theta_max = 164;    // from the viewer: beyond it the light is all but behind
const degrees_per_pixel = 0.4;  // of a drag that moves the light
const degrees_per_key = 3;
const ev_max = 6;

function fitted(width, height) {
    const largest = gl.getParameter(gl.MAX_RENDERBUFFER_SIZE) || 4096;
    const part = Math.min(1, largest / Math.max(width, height, 1));
    const [w, h] = [Math.max(1, Math.round(width * part)), Math.max(1, Math.round(height * part))];
    if (canvas.width === w && canvas.height === h) return;
    canvas.width = w;
    canvas.height = h;
    changed();
}

function show_numbers() {
    at("exposure").value = view.exposure;
    at("ev").textContent = `${view.exposure > 0 ? "+" : ""}${+view.exposure.toFixed(2)} EV`;
    at("scene").value = view.scene;
}
function set_exposure(ev) {
    view.exposure = Math.min(ev_max, Math.max(-ev_max, Math.round(ev * 20) / 20));
    show_numbers();
    changed();
}

// The light's place is a point in the plane, its distance from the middle the angle from the viewer: up is up for any light.
// An environment turns about the vertical.
function move_light(x, y) {
    if (view.scene >= scenes.length) {
        view.rotation = (view.rotation + x) % 360;
        return changed();
    }
    let px = view.theta * Math.cos(view.phi * radians) + x, py = view.theta * Math.sin(view.phi * radians) + y;
    const size = Math.hypot(px, py);
    if (size > light_theta_max) [px, py] = [px * light_theta_max / size, py * light_theta_max / size];
    view.theta = Math.hypot(px, py);
    if (view.theta > 0) view.phi = Math.atan2(py, px) / radians;
    changed();
}

// The point of the sphere under a place of the window; from its rim on, the rim.
function under(event) {
    const box = canvas.getBoundingClientRect(), unit = sphere_part * Math.min(box.width, box.height);
    let x = (event.clientX - box.left - box.width / 2) / unit, y = -(event.clientY - box.top - box.height / 2) / unit;
    const r = Math.hypot(x, y);
    if (r > 1) [x, y] = [x / r, y / r];
    return {point: [x, y, Math.sqrt(Math.max(0, 1 - x * x - y * y))], beside: r > 1};
}

// The object turned by the shortest way that takes one unit vector to another.
function turn(from, to) {
    const [a, b, c] = [from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2], from[0] * to[1] - from[1] * to[0]];
    const cosine = from[0] * to[0] + from[1] * to[1] + from[2] * to[2];
    if (cosine < -0.99) return;
    const k = 1 / (1 + cosine);
    const rows = [[a * a * k + cosine, a * b * k - c, a * c * k + b], [b * a * k + c, b * b * k + cosine, b * c * k - a],
                  [c * a * k - b, c * b * k + a, c * c * k + cosine]];
    const old = view.turn, columns = [];
    for (const j of [0, 3, 6]) columns.push(rows.map((row) => row[0] * old[j] + row[1] * old[j + 1] + row[2] * old[j + 2]));
    view.turn = orthonormal(columns).flat();
    changed();
}
// Many small turns would add up their rounding.
function orthonormal([x, y]) {
    const scaled = (v) => v.map((value) => value / Math.hypot(...v));
    y = scaled(y);
    const along = x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
    x = scaled(x.map((value, i) => value - along * y[i]));
    return [x, y, [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]]];
}

const fingers = new Map();
let moves_light = false;
function set_mode(on) {
    moves_light = on;
    at("mode").setAttribute("aria-pressed", on);
}
canvas.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "mouse" && event.button > 2) return;
    event.preventDefault();
    canvas.focus({preventScroll: true});
    canvas.setPointerCapture(event.pointerId);
    const {point, beside} = under(event);
    const light = moves_light || beside || event.shiftKey || event.button === 2;
    fingers.set(event.pointerId, {x: event.clientX, y: event.clientY, point, light});
    if (fingers.size > 1) for (const finger of fingers.values()) finger.light = true;
});
canvas.addEventListener("pointermove", (event) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) return canvas.classList.toggle("beside", moves_light || event.shiftKey || under(event).beside);
    const {point} = under(event), [x, y] = [event.clientX - finger.x, event.clientY - finger.y];
    // Each of several fingers moves the light by its share.
    if (finger.light) move_light(x * degrees_per_pixel / fingers.size, -y * degrees_per_pixel / fingers.size);
    else turn(finger.point, point);
    Object.assign(finger, {x: event.clientX, y: event.clientY, point});
});
for (const end of ["pointerup", "pointercancel"])
    canvas.addEventListener(end, (event) => fingers.delete(event.pointerId));
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? event.deltaY * 33 : event.deltaY;
    set_exposure(view.exposure - lines / 400);
}, {passive: false});
const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) {
        const sine = Math.sin(degrees_per_key * radians);
        turn([0, 0, 1], [arrow[0] * sine, arrow[1] * sine, Math.sqrt(1 - sine * sine)]);
    } else if (arrow) move_light(arrow[0] * degrees_per_key, arrow[1] * degrees_per_key);
    else if (event.key === "+" || event.key === "=") set_exposure(view.exposure + 0.25);
    else if (event.key === "-") set_exposure(view.exposure - 0.25);
    else return;
    event.preventDefault();
});

scenes.forEach((scene, i) => {
    if (scene.ambient && !data.albedo) return;
    at("scene").add(new Option(scene.name, i));
});
at("scene").addEventListener("change", () => { view.scene = +at("scene").value; changed(); });
at("exposure").addEventListener("input", () => set_exposure(+at("exposure").value));
at("mode").addEventListener("click", () => set_mode(!moves_light));
at("reset").addEventListener("click", () => { view = usual(); set_mode(false); show_numbers(); changed(); });
at("controls").addEventListener("submit", (event) => event.preventDefault());
canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
canvas.addEventListener("webglcontextrestored", () => { set_up(); changed(); });

open_picture().then((opened) => {
    if (!opened) return;
    // Its light is summed up in floats, which not every telephone adds.
    if (sums) data.environments.forEach((environment, i) => at("scene").add(new Option(environment.name, scenes.length + i)));
    show_numbers();
    new ResizeObserver(([entry]) => {
        const box = entry.devicePixelContentBoxSize?.[0], ratio = window.devicePixelRatio || 1;
        const width = entry.contentRect.width * ratio, height = entry.contentRect.height * ratio;
        // Chromium's own is in other units where a device is emulated.
        if (box && Math.abs(box.inlineSize - width) < 2) fitted(box.inlineSize, box.blockSize);
        else fitted(Math.round(width), Math.round(height));
    }).observe(canvas);
});
