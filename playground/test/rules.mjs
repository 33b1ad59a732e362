// Typed rules in the page: they run, mistakes keep the model, files come in and go out.

import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { asRust, isTypeName, nameOf, plainRules, withoutHead } from '../page/src/rust.js';
import { afterAnswer, openPage, paste } from './browser.mjs';
import { check, ensure, equal } from './checks.mjs';

const RULES = 'attr height = 12\nLot --> extrude(height) comp(f) { side : color("#a0b1c2") Wall | top : Roof. }\nWall --> color("#d9cdb8") Wall.\n';

/** 400 rules, which all run. */
const MANY = `Lot --> split(x) { ${Array.from({ length: 400 }, (_, at) => `~1 : R${at}`).join(' | ')} }\n${Array.from({ length: 399 }, (_, at) => `R${at} --> extrude(${2 + (at % 7)}) color("#a0b1c2") comp(f) { side : split(y) { ~1 : Wall. }* | top : Roof. }\n`).join('')}R399 --> extrude(1) Mass.\n`;

const text = (page, id) => page.$eval(id, (element) => element.textContent);
const parts = async (page) => /^[\d,]+ parts/.exec(await text(page, '#numbers'))?.[0];
const end = async (page) => {
  await page.focus('.cm-content');
  for (const [key, press] of [['Control', 'down'], ['End', 'press'], ['Control', 'up']]) await page.keyboard[press](key);
};

/** Types a rule, sees the model change, makes a mistake, sees the message and keeps the model. */
export async function typeAndErr(page) {
  await paste(page, RULES);
  equal(await text(page, '#error'), '', 'error');
  const before = await parts(page);
  equal(before, '5 parts');
  // The rule for the walls gets a split, key by key.
  await end(page);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('End');
  for (let back = 0; back < 'Wall.'.length; back++) await page.keyboard.press('Backspace');
  await afterAnswer(page, () => page.keyboard.type('split(x) { ~1 : Left. | ~1 : Right. }'));
  await page.waitForFunction(() => document.querySelector('#numbers').textContent.startsWith('9 parts'), { timeout: 60_000 });
  equal(await text(page, '#error'), '', 'error');
  await afterAnswer(page, () => page.keyboard.type(' Wal'));
  await page.waitForFunction(() => document.querySelector('#findings').textContent.includes('Wall`'), { timeout: 60_000 });
  for (let back = 0; back < ' Wal'.length; back++) await page.keyboard.press('Backspace');
  await page.waitForFunction(() => document.querySelector('#numbers').textContent.startsWith('9 parts') && document.querySelector('#view').dataset.busy === 'false', { timeout: 60_000 });
  await afterAnswer(page, () => page.keyboard.sendCharacter(' extrude(heigt)'));
  await page.waitForFunction(() => document.querySelector('#error').textContent.includes('heigt'), { timeout: 60_000 });
  const message = await text(page, '#error');
  ensure(/^Line 3: .*`heigt`.*height.*The last model stays\.$/.test(message), message);
  ensure((await parts(page)).startsWith('9 parts'), 'the model is gone');
  equal(await page.$$eval('.cm-line .finding.error', (marks) => marks.map((mark) => mark.textContent).join('')), 'heigt', 'underlined');
  return message;
}

export async function checkRules({ browser, server, page: drawn, root, out, target }) {
  await drawn.goto(`${server.address}#grammar=house`);
  await drawn.waitForFunction(() => document.querySelector('#view').dataset.grammar === 'house');
  // Without pictures, which take long without a graphics processor.
  const { page: plain, said } = await openPage(browser, `${server.address}#grammar=house`, { hasWebGL: false });
  const page = plain;

  await check('typed rules run, and a mistake keeps the model', async () => {
    const page = drawn;
    await page.bringToFront();
    const message = await typeAndErr(page);
    await page.screenshot({ path: join(out, 'mistake.png') });
    await page.click('#findings button');
    equal(await page.evaluate(() => String(getSelection())), 'heigt', 'selected');
    return message;
  });

  await check('sliders come from the typed attributes', async () => {
    await paste(page, `@Range(min = 1, max = 40)\n${RULES}`);
    const slider = '[data-name=height] input[type=range]';
    equal(await page.$eval(slider, ({ min, max, value }) => [min, max, value]), ['1', '40', '12'], 'slider');
    await afterAnswer(page, () => page.$eval(slider, (input) => {
      input.value = 30;
      input.dispatchEvent(new Event('input', { bubbles: true }));
    }));
    // Another text keeps the value by its name.
    await paste(page, `@Range(min = 1, max = 40)\n${RULES}# more\n`);
    equal(await page.$eval(slider, ({ value }) => value), '30', 'value');
    await page.waitForFunction(() => decodeURIComponent(location.hash).includes('# more') || location.hash.includes('more'));
  });

  await check('a lot and a start rule are chosen', async () => {
    await paste(page, `${RULES}@StartRule\nShed --> extrude(2) Shed.\n`);
    await afterAnswer(page, () => page.select('#start', 'Shed'));
    equal(await parts(page), '1 parts', 'parts');
    await afterAnswer(page, () => page.select('#lot', 'l'));
    await afterAnswer(page, () => page.select('#start', ''));
    await paste(page, RULES);
    equal(await parts(page), '7 parts', 'an L has six sides and a roof');
    await afterAnswer(page, () => page.select('#lot', 'rectangle'));
    equal(await page.$eval('#sides', (sides) => sides.hidden), false, 'sides');
    equal(await parts(page), '5 parts');
  });

  await check('a GeoJSON file and an OBJ file are lots', async () => {
    await paste(page, RULES);
    const square = (x) => ({ type: 'Feature', properties: { height: 5 + x }, geometry: { type: 'Polygon', coordinates: [[[x * 0.001, 50], [x * 0.001 + 0.0003, 50], [x * 0.001 + 0.0003, 50.0002], [x * 0.001, 50]]] } });
    writeFileSync(join(out, 'lots.geojson'), JSON.stringify({ type: 'FeatureCollection', features: [square(0), square(1), square(2)] }));
    writeFileSync(join(out, 'lot.obj'), 'v 0 0 0\nv 9 0 0\nv 9 0 -9\nf 1 2 3\n');
    const input = await page.$('#file');
    await afterAnswer(page, () => input.uploadFile(join(out, 'lots.geojson')));
    equal(await parts(page), '12 parts', 'three lots with three sides and a roof');
    equal(await page.$eval('#lot', (menu) => menu.selectedOptions[0].text), 'lots.geojson');
    await afterAnswer(page, () => input.uploadFile(join(out, 'lot.obj')));
    equal(await parts(page), '4 parts', 'a triangle');
    await page.screenshot({ path: join(out, 'lots.png') });
    await afterAnswer(page, () => page.select('#lot', ''));
  });

  await check('hostile texts end with a message', async () => {
    const took = [];
    for (const text of ['(', 'A --> '.repeat(2000), `A --> ${'('.repeat(5000)}`, `A --> ${'[ '.repeat(5000)}`, 'Lot --> split(x) { 0.00001 : A. }*', 'Lot --> extrude(1) Lot', 'A --> x(1 + '.repeat(300), `A --> ${'case 1 : '.repeat(2000)}`]) {
      const begin = Date.now();
      await paste(page, text);
      took.push(Date.now() - begin);
    }
    await paste(page, RULES);
    equal(await text(page, '#error'), '', 'error');
    return `${took.join(', ')} ms`;
  });

  await check('a run that is superseded is stopped', async () => {
    const slow = 'attr n = 9\nf(a, b) = case a < 1 : b else : f(a - 1, b) + f(a - 1, b + 1)\nLot --> extrude(3 + 0 * f(24, n)) Mass.\n';
    await page.focus('.cm-content');
    for (const [key, press] of [['Control', 'down'], ['a', 'press'], ['Control', 'up']]) await page.keyboard[press](key);
    await page.keyboard.sendCharacter(slow);
    await new Promise((resolve) => setTimeout(resolve, 400));
    const begin = Date.now();
    await paste(page, RULES);
    equal(await parts(page), '5 parts');
    return `${Date.now() - begin} ms`;
  });

  for (const [kind, page] of [['with a picture', drawn], ['without a picture', plain]]) await check(`400 rules are typed into, ${kind}`, async () => {
    await page.bringToFront();
    await paste(page, MANY);
    equal(await text(page, '#error'), '', 'error');
    const before = await parts(page);
    await end(page);
    await page.evaluate(() => {
      window.gaps = [];
      let last = performance.now();
      const channel = new MessageChannel();
      channel.port1.onmessage = () => {
        const now = performance.now();
        window.gaps.push(now - last);
        last = now;
        if (window.gaps) channel.port2.postMessage(null);
      };
      channel.port2.postMessage(null);
    });
    await afterAnswer(page, () => page.keyboard.type('New --> extrude(3) split(x) { ~1 : A. }*', { delay: 40 }));
    const longest = await page.evaluate(() => {
      const { gaps } = window;
      window.gaps = null;
      return gaps.toSorted((a, b) => b - a).slice(0, 3).map((gap) => gap.toFixed(0)).join(', ');
    });
    ensure(before !== '5 parts', before);
    return `${MANY.length} characters, ${before}; the longest blocks are ${longest} ms`;
  });

  await check('a link holds typed rules, and Back returns to them', async () => {
    await paste(page, RULES);
    await new Promise((resolve) => setTimeout(resolve, 500));
    const second = await openPage(browser, page.url());
    equal(await second.page.$$eval('.cm-line', (lines) => `${lines.map((line) => line.textContent).join('\n')}`), RULES, 'rules');
    equal(await parts(second.page), '5 parts');
    await second.page.select('#grammar', 'temple');
    await second.page.waitForFunction(() => document.querySelector('#view').dataset.grammar === 'temple');
    await second.page.goBack();
    await second.page.waitForFunction(() => document.querySelector('#numbers').textContent.startsWith('5 parts'));
    equal(await second.page.$eval('#grammar', (menu) => menu.value), 'house', 'grammar');
    await paste(second.page, '# '.repeat(20_000));
    await new Promise((resolve) => setTimeout(resolve, 500));
    ensure(second.page.url().length < 1000, `an address of ${second.page.url().length} characters`);
    equal(second.said, [], 'messages');
    await second.page.close();
  });

  await check('the copied Rust compiles, and can be pasted back', async () => {
    await browser.defaultBrowserContext().overridePermissions(new URL(server.address).origin, ['clipboard-read', 'clipboard-write', 'clipboard-sanitized-write']);
    await page.bringToFront();
    await paste(page, RULES);
    await page.$eval('#rust-name', (input) => {
      input.value = 'Copied';
      input.dispatchEvent(new Event('change'));
    });
    await page.click('#copy-rust');
    await page.waitForFunction(() => document.querySelector('#announce').textContent === 'Copied as Rust.');
    const code = await page.evaluate(() => navigator.clipboard.readText());
    ensure(code.startsWith('cga! {\n    pub grammar Copied = r##"\n'), code);
    await paste(page, code);
    equal([await text(page, '#error'), await parts(page)], ['', '5 parts'], 'pasted back');
    equal(await page.$eval('#rust-name', (input) => input.value), 'Copied', 'name');
    await paste(page, `use cga::cga;\n\ncga! {\n    /// A mass.\n    pub grammar Inline;\n\n    Lot --> s(^0.5, 3, ^0.5) Mass.\n}\n`);
    equal([await text(page, '#error'), await parts(page)], ['', '1 parts'], 'an inline macro');
    equal([isTypeName('house'), isTypeName('Self'), isTypeName('House2'), isTypeName('A B'), isTypeName('')], [false, false, true, false, false]);
    ensure(asRust('A', 'x "### y').includes('= r####"\n'), 'the marks around the text are too short');
    equal(withoutHead('// A.\n@Allow(missing_asset)\npub grammar A;\nLot --> NIL'), `// A.\n${' '.repeat(21)}\n${' '.repeat(14)}\nLot --> NIL`);
    equal(withoutHead('Lot --> NIL // grammar A;'), 'Lot --> NIL // grammar A;');
    equal(plainRules(asRust('A', 'Lot --> "#"\n')).trim(), 'Lot --> "#"');
    equal([nameOf('cga! { grammar B = r#""#; }'), nameOf('pub grammar C;'), nameOf('Lot --> NIL')], ['B', 'C', null]);
    const folder = join(out, 'copied');
    mkdirSync(join(folder, 'src'), { recursive: true });
    writeFileSync(join(folder, 'Cargo.toml'), `[package]\nname = "copied"\nversion = "0.0.0"\nedition = "2024"\n\n[dependencies]\ncga = { path = "../../..", default-features = false, features = ["gltf", "serde"] }\n\n[workspace]\n`);
    writeFileSync(join(folder, 'Cargo.lock'), readFileSync(join(root, 'Cargo.lock')));
    writeFileSync(join(folder, 'src', 'main.rs'), `use cga::{Shape, cga};\n\n${code}\nfn main() {\n    let model = Copied::default().generate(&Shape::rectangle(4.0, 5.0)).expect("a model");\n    println!("{} {} {}", model.count("Wall"), model.count("Roof"), model.faults().len());\n}\n`);
    const made = execFileSync('cargo', ['run', '--quiet', '--manifest-path', join(folder, 'Cargo.toml'), '--target-dir', target], { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
    equal(made, '4 1 0\n', 'leaves');
  });
  equal(said.filter((text) => !/WebGL/.test(text)), [], 'messages');
  await plain.close();
}
