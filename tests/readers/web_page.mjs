// web_page.mjs NACRE_CLI PRESETS PLAYWRIGHT FOLDER: see web_page.sh.
//
// A page and a picture of `nacre-cli render` are both rounded to 8 bits, so that values that are 1/255 apart may stand two
// steps apart. At 1,000 pixels of each view none may, and of pixels whose value is known without rounding, from `nacre-cli eval`,
// none may be further than 1/255 and the half step of its own rounding away.
import {execFileSync} from "node:child_process";
import {existsSync, readFileSync, statSync} from "node:fs";
import {join} from "node:path";
import {pathToFileURL} from "node:url";
import {evaluated} from "./sphere_pixels.mjs";

const [cli, presets, playwright, folder] = process.argv.slice(2);
const {chromium} = await import(pathToFileURL(playwright));
const PROBES = 1000, STEPS = 2;
const page_max = 1.5 * 2 ** 20;
const WIDE = 120, HIGH = 80;  // under an environment, whose 256 samples a pixel take long

function require(holds, what) {
    if (!holds) throw new Error(what);
}

// Numbers in [0, 1), the same in every run (Numerical Recipes' generator).
function random_numbers(seed) {
    return () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

// Pixels of the picture, four of five on the sphere and off its rim.
function probes(width, height, count, only_inside) {
    const next = random_numbers(7), found = [], unit = 0.39 * Math.min(width, height);
    while (found.length < count) {
        const inside = only_inside || found.length % 5 < 4;
        const x = Math.floor(width / 2 + (inside ? 2 * next() - 1 : (2 * next() - 1) * 0.5 * width / unit) * unit);
        const y = Math.floor(height / 2 + (inside ? 2 * next() - 1 : (2 * next() - 1) * 0.5 * height / unit) * unit);
        const r = Math.hypot(x + 0.5 - width / 2, y + 0.5 - height / 2) / unit;
        if (x >= 0 && y >= 0 && x < width && y < height && (!only_inside || r < 0.97)) found.push([x, y]);
    }
    return found;
}

// The picture as numbers, rows from the top.
async function pixels_of(blank, url) {
    const {width, height, text} = await blank.evaluate(async (source) => {
        const blob = await (await fetch(source)).blob();
        const bitmap = await createImageBitmap(blob, {colorSpaceConversion: "none", premultiplyAlpha: "none"});
        const canvas = new OffscreenCanvas(bitmap.width, bitmap.height), context = canvas.getContext("2d");
        context.drawImage(bitmap, 0, 0);
        const bytes = context.getImageData(0, 0, bitmap.width, bitmap.height).data;
        let packed = "";
        for (let i = 0; i < bytes.length; i += 32768) packed += String.fromCharCode(...bytes.subarray(i, i + 32768));
        return {width: bitmap.width, height: bitmap.height, text: btoa(packed)};
    }, url);
    const bytes = Buffer.from(text, "base64");
    return {width, height, at: (x, y) => [0, 1, 2].map((c) => bytes[4 * (y * width + x) + c])};
}

const settled = (page) => page.waitForSelector('#picture[data-state="settled"]', {timeout: 300000});
const view_of = (page) => page.$eval("#picture", (canvas) => JSON.parse(canvas.dataset.view));
async function shown(page, blank) {
    await settled(page);
    return pixels_of(blank, await page.$eval("#picture", (canvas) => canvas.toDataURL("image/png")));
}

function worst_of(picture, value_at, places) {
    let worst = 0;
    for (const [index, [x, y]] of places.entries())
        picture.at(x, y).forEach((value, c) => { worst = Math.max(worst, Math.abs(value - value_at(index, x, y)[c])); });
    return worst;
}
function changed_pixels(before, after, places) {
    return places.filter(([x, y]) => after.at(x, y).some((value, c) => Math.abs(value - before.at(x, y)[c]) > 3)).length;
}

// Against the picture that Nacre draws of the same view, where the object is as it was.
async function like_nacre(what, design, page, blank, more = []) {
    const picture = await shown(page, blank), view = await view_of(page);
    require(view.supersample === 2, `${what}: not drawn well`);
    const png = execFileSync(cli, ["render", design, "--size", `${picture.width}x${picture.height}`, "--light", `${view.theta},${view.phi}`,
        "--exposure", String(view.exposure), ...more, "--format", "png", "-o", "-"], {maxBuffer: 2 ** 28, stdio: ["ignore", "pipe", "ignore"]});
    const drawn = await pixels_of(blank, "data:image/png;base64," + png.toString("base64"));
    const places = probes(picture.width, picture.height, PROBES);
    const worst = worst_of(picture, (_, x, y) => drawn.at(x, y), places);
    require(places.some(([x, y]) => Math.max(...picture.at(x, y)) > 100), `${what}: the picture is dark`);
    console.log(`${what}: ${PROBES} pixels of ${picture.width} x ${picture.height}, at most ${worst} steps from render's`);
    require(worst < STEPS, what);
    return picture;
}

// Against the BRDF itself, of any view under one lamp.
async function like_eval(what, design, page, blank) {
    const picture = await shown(page, blank), view = await view_of(page);
    const places = probes(picture.width, picture.height, PROBES, true);
    const expected = evaluated(cli, design, view, picture, places);
    const worst = worst_of(picture, (index) => expected[index], places);
    console.log(`${what}: ${PROBES} pixels, at most ${worst.toFixed(3)} steps from eval's`);
    require(worst <= 1.5, what);
    return picture;
}

// Moves of one finger or several, from and to places of the window.
async function touch(page, moves) {
    const session = await page.context().newCDPSession(page), parts = 5;
    const at = (part) => moves.map(([from, to], id) => ({id, x: from[0] + (to[0] - from[0]) * part, y: from[1] + (to[1] - from[1]) * part}));
    await session.send("Input.dispatchTouchEvent", {type: "touchStart", touchPoints: at(0)});
    for (let i = 1; i <= parts; ++i) await session.send("Input.dispatchTouchEvent", {type: "touchMove", touchPoints: at(i / parts)});
    await session.send("Input.dispatchTouchEvent", {type: "touchEnd", touchPoints: []});
    await session.detach();
}
async function drag(page, from, to, by_touch) {
    if (by_touch) return touch(page, [[from, to]]);
    await page.mouse.move(...from);
    await page.mouse.down();
    await page.mouse.move(...to, {steps: 5});
    await page.mouse.up();
}

async function check_views(browser, name, device) {
    const what = `${name}, ${device.name}`, design = join(presets, name + ".nacre"), file = join(folder, name + ".html");
    const context = await browser.newContext({viewport: device.viewport, deviceScaleFactor: device.scale, hasTouch: device.touch,
                                              isMobile: device.touch, offline: true});
    const page = await context.newPage(), blank = await context.newPage(), problems = [];
    page.on("pageerror", (error) => problems.push(error.message));
    page.on("console", (message) => { if (message.type() === "error") problems.push(message.text()); });
    page.on("request", (request) => { if (!request.url().startsWith("file:")) problems.push("asked for " + request.url()); });
    await page.addInitScript(() => {
        window.drawings = 0;
        const draw = WebGL2RenderingContext.prototype.drawArrays;
        WebGL2RenderingContext.prototype.drawArrays = function (...values) {
            ++window.drawings;
            draw.apply(this, values);
        };
    });
    await page.goto(pathToFileURL(file).href);
    const first = await like_nacre(`${what}, as it opens`, design, page, blank);
    await page.screenshot({path: join(folder, `${name}-${device.name}.png`)});

    const box = await page.$eval("#picture", (canvas) => { const b = canvas.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; });
    const unit = 0.39 * Math.min(box[2], box[3]);
    const place = (x, y) => [box[0] + box[2] / 2 + x * unit, box[1] + box[3] / 2 - y * unit];
    const places = probes(first.width, first.height, PROBES);
    await drag(page, place(-0.9, 0.9), place(-0.7, 1.1), device.touch);
    const lit = await like_nacre(`${what}, light dragged`, design, page, blank);
    require(changed_pixels(first, lit, places) > 100, `${what}: dragging the light does nothing`);
    await drag(page, place(0.1, 0.2), place(0.35, -0.35), device.touch);
    const turned = await like_eval(`${what}, object dragged`, design, page, blank);
    require(changed_pixels(lit, turned, places) > 100, `${what}: dragging the object does nothing`);
    if (device.touch) await touch(page, [[place(-0.2, 0), place(-0.4, -0.2)], [place(0.2, 0), place(0, -0.2)]]);
    else {
        await page.mouse.move(...place(0, 0));
        await page.mouse.wheel(0, -200);
    }
    const last = await like_eval(`${what}, ${device.touch ? "light dragged by two fingers" : "exposed by the wheel"}`, design, page, blank);
    require(changed_pixels(turned, last, places) > 100, `${what}: the last gesture does nothing`);
    await check_rest(what, page, blank, first, places);
    require(problems.length === 0, `${what}: ${problems.join("; ")}`);
    await context.close();
}

// Keys do what the page says, the button undoes all of it, and a page that is left alone draws nothing.
async function check_rest(what, page, blank, first, places) {
    const before = await view_of(page);
    await page.focus("#picture");
    for (const key of ["ArrowLeft", "Shift+ArrowUp", "-"]) await page.keyboard.press(key);
    await settled(page);
    const after = await view_of(page);
    require(Math.abs(after.exposure - before.exposure + 0.25) < 1e-9, `${what}: the minus key`);
    require(after.theta !== before.theta || after.phi !== before.phi, `${what}: an arrow key`);
    require(after.turn.some((value, i) => Math.abs(value - before.turn[i]) > 0.01), `${what}: an arrow key with Shift`);
    await page.click("#reset");
    require(worst_of(await shown(page, blank), (_, x, y) => first.at(x, y), places) === 0, `${what}: reset`);
    const count = await page.evaluate(() => window.drawings);
    require(count > 0, `${what}: no drawing was counted`);
    await page.waitForTimeout(700);
    require(await page.evaluate(() => window.drawings) === count, `${what}: it draws though nothing changes`);
}

// An environment's light is noise around the same picture: the means of squares of 10 x 10 pixels.
async function check_environment(browser, name) {
    const design = join(presets, name + ".nacre"), side = 10;
    const context = await browser.newContext({viewport: {width: WIDE, height: HIGH}, offline: true});
    const page = await context.newPage(), blank = await context.newPage();
    await page.goto(pathToFileURL(join(folder, name + ".html")).href);
    const plain = await shown(page, blank);
    for (const [label, environment] of [["Soft boxes", "studio"], ["Sky and sun", "sky"]]) {
        await page.selectOption("#scene", {label});
        await page.waitForSelector('#picture[data-state="moving"]');
        const picture = await shown(page, blank);
        const png = execFileSync(cli, ["render", design, "--size", `${WIDE}x${HIGH}`, "--environment", environment, "--format", "png", "-o", "-"],
                                 {maxBuffer: 2 ** 26, stdio: ["ignore", "pipe", "ignore"]});
        const drawn = await pixels_of(blank, "data:image/png;base64," + png.toString("base64"));
        let worst = 0, apart = 0;
        for (let y = 0; y + side <= HIGH; y += side) for (let x = 0; x + side <= WIDE; x += side) for (let c = 0; c < 3; ++c) {
            let difference = 0, other = 0;
            for (let j = 0; j < side; ++j) for (let i = 0; i < side; ++i) {
                difference += (picture.at(x + i, y + j)[c] - drawn.at(x + i, y + j)[c]) / side ** 2;
                other += (picture.at(x + i, y + j)[c] - plain.at(x + i, y + j)[c]) / side ** 2;
            }
            worst = Math.max(worst, Math.abs(difference));
            apart = Math.max(apart, Math.abs(other));
        }
        console.log(`${name}, ${label}: squares of ${side} x ${side} pixels differ by at most ${worst.toFixed(2)} steps from render's`);
        require(apart > 40, `${name}, ${label}: no other light than the lamp's`);
        require(worst <= 4, `${name}, ${label}`);
    }
    await context.close();
}

// Without WebGL 2 the page says so.
async function check_message(name) {
    const browser = await chromium.launch({executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu", "--disable-3d-apis"]});
    const page = await browser.newPage();
    await page.goto(pathToFileURL(join(folder, name + ".html")).href);
    await page.waitForSelector('#picture[data-state="failed"]');
    require((await page.textContent("#message")).includes("WebGL 2"), "no message without WebGL 2");
    await browser.close();
}

const names = ["satin", "smiley"];
for (const name of names) {
    const file = join(folder, name + ".html");
    execFileSync(cli, ["export", join(presets, name + ".nacre"), "--to", "web", "-o", file], {stdio: "ignore"});
    require(existsSync(file) && statSync(file).size <= page_max, `${name}: more than 1.5 MiB`);
    require(!/https?:\/\//.test(readFileSync(file, "utf8").replace(/<p id="note">.*?<\/p>/s, "")), `${name}: names another place`);
}
const browser = await chromium.launch({executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--force-color-profile=srgb"]});
const devices = [{name: "mouse", viewport: {width: 800, height: 600}, scale: 1, touch: false},
                 {name: "touch", viewport: {width: 320, height: 568}, scale: 2, touch: true}];
try {
    for (const [name, device] of [["satin", 0], ["smiley", 1]])
        await check_views(browser, name, devices[device]);
    await check_environment(browser, "satin");
    await check_message("satin");
} finally {
    await browser.close();
}
