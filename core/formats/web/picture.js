"use strict";
// The picture: what is drawn of the view, and when. Names here are those of page.js too.
const at = (id) => document.getElementById(id);
const canvas = at("picture"), data = JSON.parse(at("data").textContent);
const radians = Math.PI / 180;

function fail(text) {
    document.body.classList.add("failed");
    at("message").textContent = text;
    canvas.dataset.state = "failed";
    return false;
}

// The scenes of `nacre-cli render --scene`. Angles in degrees in view space: x right, y up, z toward the viewer.
const main = {theta: 42, phi: 125, irradiance: [4.5, 4.5, 4.5]};
const second = {theta: 75, phi: -25, irradiance: [0.9, 1.0, 1.2]};
const scenes = [
    {name: "One lamp", lights: [], ambient: false},
    {name: "Two lamps", lights: [second], ambient: false},
    {name: "One lamp in a bright room", lights: [], ambient: true},
    {name: "Two lamps in a bright room", lights: [second], ambient: true}];
const ambient_radiance = [0.12, 0.12, 0.12], wall = [0.045, 0.047, 0.052];
const sphere_part = 0.39;        // its radius, of the picture's shorter side
const texels_max = 1.2e6;        // drawn while something moves; more would lag behind the hand
const light_texels_max = 4.5e6;  // of an environment's light, 16 bytes each
const light_samples = 256;       // of it, a pixel
const batch_max = 16;            // samples a frame
const quick = 25, slow = 60;     // milliseconds a frame

// The view. `turn` is the rotation from the object to view space, column by column.
const usual = () => ({turn: [1, 0, 0, 0, 1, 0, 0, 0, 1], theta: main.theta, phi: main.phi, rotation: 0, exposure: 0,
                       scene: 0});
let view = usual();

async function inflated(text) {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Response(stream).arrayBuffer();
}

let gl = null, tables = null;
// Whether there is WebGL 2; else the page has said so.
async function open_picture() {
    gl = canvas.getContext("webgl2", {alpha: false, antialias: false, depth: false, stencil: false,
                                      preserveDrawingBuffer: true, powerPreference: "high-performance"});
    if (!gl) return fail("This picture needs WebGL 2, which this browser does not have or has switched off.");
    if (typeof DecompressionStream === "undefined") return fail("This picture needs a newer browser.");
    tables = await inflated(data.tables);
    set_up();
    return true;
}

// A texture at this unit, read at its texels.
function texture(unit, format, width, height, layout, type, texels) {
    gl.activeTexture(gl.TEXTURE0 + unit);
    const made = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, layout, type, texels);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
        gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
        gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    return made;
}

// Units of textures.
const TABLES = 0, SUM = 1, PICTURE = 2, FACETS = 3, DIRECTIONS = 4;
let programs = new Map(), sums = false, sum = null, lit_by = null;
function set_up() {
    programs = new Map();
    sum = lit_by = null;
    sums = Boolean(gl.getExtension("EXT_color_buffer_float") && gl.getExtension("EXT_float_blend"));
    if (data.half) texture(TABLES, gl.R16F, 1024, data.rows, gl.RED, gl.HALF_FLOAT, new Uint16Array(tables));
    else texture(TABLES, gl.R32F, 1024, data.rows, gl.RED, gl.FLOAT, new Float32Array(tables));
}

function shader(program, kind, text) {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    gl.attachShader(program, made);
    return made;
}

// The program of this fragment shader, with the places of its uniforms.
function program_of(text) {
    if (programs.has(text)) return programs.get(text);
    const program = gl.createProgram();
    shader(program, gl.VERTEX_SHADER, data.vertex);
    const fragment = shader(program, gl.FRAGMENT_SHADER, text);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
        throw new Error(gl.getShaderInfoLog(fragment) || gl.getProgramInfoLog(program));
    const places = new Map();
    const made = {program, place: (name) => {
        if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
        return places.get(name);
    }};
    programs.set(text, made);
    return made;
}
const picture_program = (lights, ambient) => program_of(
    data.fragment.replace("#define LIGHTS 1", "#define LIGHTS " + lights)
                 .replace("#define AMBIENT_LIGHT 0", "#define AMBIENT_LIGHT " + (ambient ? 1 : 0)));

function toward(light) {
    const sine = Math.sin(light.theta * radians);
    return [sine * Math.cos(light.phi * radians), sine * Math.sin(light.phi * radians), Math.cos(light.theta * radians)];
}

function set_geometry(place, supersample) {
    const width = canvas.width * supersample, height = canvas.height * supersample;
    gl.uniform1i(place("surface_data"), TABLES);
    gl.uniformMatrix3fv(place("object_to_view"), false, view.turn);
    gl.uniform2f(place("target_size"), width, height);
    gl.uniform1f(place("texels_per_unit"), sphere_part * Math.min(width, height));
}

function draw(supersample) {
    const environment = view.scene >= scenes.length;
    const scene = environment ? {lights: [], ambient: false} : scenes[view.scene];
    const lights = environment ? [] : [{...main, theta: view.theta, phi: view.phi}, ...scene.lights];
    const {program, place} = picture_program(lights.length, scene.ambient);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.useProgram(program);
    set_geometry(place, supersample);
    lights.forEach((light, i) => {
        gl.uniform3fv(place(`light_direction[${i}]`), toward(light));
        gl.uniform3fv(place(`light_irradiance[${i}]`), light.irradiance);
    });
    gl.uniform3fv(place("ambient_radiance"), ambient_radiance);
    gl.uniform3fv(place("background"), wall);
    gl.uniform1f(place("falloff"), 1);
    gl.uniform1i(place("supersample"), supersample);
    gl.uniform1f(place("exposure"), 2 ** view.exposure);
    gl.uniform1i(place("has_environment"), environment ? 1 : 0);
    gl.uniform1i(place("accumulated"), environment ? SUM : TABLES);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    canvas.dataset.view = JSON.stringify({...view, supersample});
}

// The textures of the environment that shines, unpacked when it is first chosen.
const unpacked = new Map();
const words = async (text) => {
    if (!unpacked.has(text)) unpacked.set(text, new Uint16Array(await inflated(text)));
    return unpacked.get(text);
};
async function light_by(environment) {
    const [facets, order, picture] = await Promise.all([data.facets, environment.order, environment.picture].map(words));
    if (data.environments[view.scene - scenes.length] !== environment || gl.isContextLost()) return;
    const rows = (texels) => texels.length / 1024;
    texture(FACETS, gl.RGBA16F, 256, rows(facets), gl.RGBA, gl.HALF_FLOAT, facets);
    texture(DIRECTIONS, gl.RGBA16F, 256, rows(order), gl.RGBA, gl.HALF_FLOAT, order);
    texture(PICTURE, gl.RGB16F, environment.width, environment.height, gl.RGB, gl.HALF_FLOAT, picture);
    lit_by = environment;
    changed();
}

// The sum of the light's samples so far, which begins anew when the view changes.
function empty_sum(supersample) {
    const width = canvas.width * supersample, height = canvas.height * supersample;
    if (!sum || sum.width !== width || sum.height !== height) {
        if (sum) gl.deleteTexture(sum.texture);
        sum = {width, height, framebuffer: sum ? sum.framebuffer : gl.createFramebuffer(),
               texture: texture(SUM, gl.RGBA32F, width, height, gl.RGBA, gl.FLOAT, null)};
        gl.bindFramebuffer(gl.FRAMEBUFFER, sum.framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, sum.texture, 0);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, sum.framebuffer);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    sum.done = 0;
}

function add_light(supersample, samples) {
    const {program, place} = program_of(data.light);
    const angle = view.rotation * radians, c = Math.cos(angle), s = Math.sin(angle);
    gl.bindFramebuffer(gl.FRAMEBUFFER, sum.framebuffer);
    gl.viewport(0, 0, sum.width, sum.height);
    gl.useProgram(program);
    set_geometry(place, supersample);
    gl.uniform1i(place("environment_picture"), PICTURE);
    gl.uniform1i(place("facet_order"), FACETS);
    gl.uniform1i(place("light_order"), DIRECTIONS);
    gl.uniformMatrix3fv(place("view_to_environment"), false, [c, 0, -s, 0, 1, 0, s, 0, c]);
    gl.uniform1f(place("light_scale"), 1 / (3 * lit_by.brightness));
    gl.uniform1f(place("environment_brightness"), 1);
    gl.uniform1i(place("first_sample"), sum.done);
    gl.uniform1i(place("samples"), samples);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
    sum.done += samples;
}

// Nothing is drawn unless something has changed: at once and coarsely where there are many pixels, and then well.
let frame = 0, settle = 0, batch = 1, began = 0, anew = true;
function drawn(supersample, settled) {
    draw(supersample);
    at("message").textContent = "";
    canvas.dataset.state = settled ? "settled" : "moving";
}
function draw_lights() {
    if (canvas.width * canvas.height * 4 <= texels_max) return drawn(2, true);
    drawn(1, false);
    settle = setTimeout(() => guarded(() => drawn(2, true)), 150);
}
// A few samples more, until there are enough.
function draw_environment(now) {
    const environment = data.environments[view.scene - scenes.length];
    if (lit_by !== environment) return void light_by(environment);
    const supersample = canvas.width * canvas.height * 4 <= light_texels_max ? 2 : 1;
    const goal = light_samples / (supersample * supersample);
    if (anew || !sum) empty_sum(supersample);
    else if (now - began < quick) batch = Math.min(2 * batch, batch_max);
    else if (now - began > slow) batch = Math.max(batch >> 1, 1);
    anew = false;
    began = now;
    add_light(supersample, Math.min(batch, goal - sum.done));
    drawn(supersample, sum.done >= goal);
    if (sum.done < goal) next_frame();
}
function guarded(work) {
    if (!tables || gl.isContextLost()) return;
    try {
        work();
    } catch (error) {
        fail("This browser's WebGL 2 cannot draw this picture: " + error.message.split("\n")[0]);
    }
}
function next_frame() {
    if (!frame) frame = requestAnimationFrame((now) => {
        frame = 0;
        clearTimeout(settle);
        guarded(() => view.scene < scenes.length ? draw_lights() : draw_environment(now));
    });
}
function changed() {
    canvas.dataset.state = "moving";
    anew = true;
    next_frame();
}
