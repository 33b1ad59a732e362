// node test.mjs COMMAND DIR [IMAGES]: flies through a city in a headless Chromium. The last line says what was seen.
import { spawn } from "node:child_process";
import { once } from "node:events";
import puppeteer from "puppeteer-core";

const [command, folder, expectedImages = "0"] = process.argv.slice(2);
const server = spawn(command, ["view", folder, "--port", "0"], { stdio: ["ignore", "inherit", "pipe"] });
const [line] = await once(server.stderr, "data");
const address = String(line).split(" ")[0];
const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
});
const check = (condition, text) => {
    if (!condition) throw new Error(text);
};
try {
    const page = await browser.newPage();
    const images = new Set();
    const lost = [];
    page.on("response", (response) => {
        const address = response.url();
        if (address.includes("/city/images/")) images.add(address);
        if (400 <= response.status() && !address.endsWith("/favicon.ico")) lost.push(`${response.status()} ${address}`);
    });
    page.on("pageerror", (error) => console.log(`page: ${error}`));
    await page.setViewport({ width: 800, height: 600 });
    await page.goto(address);
    const numbers = () => page.evaluate(() => window.city?.numbers());
    // Quiet for half a second: all tiles of the view are there.
    const settle = async () => {
        let quiet = 0;
        for (let turn = 0; turn < 600 && quiet < 5; turn += 1) {
            await new Promise((done) => setTimeout(done, 100));
            const now = await numbers();
            quiet = now?.isPlaced && now.waiting === 0 && 0 < now.visible ? quiet + 1 : 0;
        }
        check(quiet === 5, `the tiles do not arrive: ${JSON.stringify(await numbers())}`);
        return numbers();
    };
    const seen = [];
    for (const metres of [20000, 5000, 1500, 500, 150]) {
        await page.evaluate((metres) => window.city.lookFrom(metres), metres);
        const { failed, visible, errors } = await settle();
        check(failed === 0 && errors.length === 0, `tiles are missing: ${errors.join("\n")}`);
        seen.push(visible);
    }
    let building = null;
    for (const [dx, dy] of [[0, 0], [40, 0], [-40, 0], [0, 40], [0, -40], [80, 40], [-80, -40], [120, 0], [0, 90]]) {
        building ??= await page.evaluate((x, y) => window.city.show(x, y), 400 + dx, 300 + dy);
    }
    check(building && 0 < Number(building.name) && 4 <= building.height && building.height <= 22, `no building: ${JSON.stringify(building)}`);
    const card = await page.$eval("#card", (card) => card.textContent);
    check(card.includes(building.name), `the card is ${card}`);
    check(lost.length === 0, `requests fail: ${lost.join("\n")}`);
    check(images.size === Number(expectedImages), `${images.size} images, not ${expectedImages}`);
    console.log(`visible tiles from far to near: ${seen.join(", ")}; a click shows id ${building.name}, height ${building.height}; 0 missing; ${images.size} images`);
} finally {
    await browser.close();
    server.kill();
}
