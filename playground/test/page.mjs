// The page in a headless browser, compared with the same grammars compiled for this machine.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serve } from '../serve.mjs';
import { decode, encode } from '../page/src/state.js';
import { afterRun, inPage, openPage, settle, startBrowser } from './browser.mjs';
import { check, ensure, equal, finish } from './checks.mjs';
import { checkFloor } from './floor.mjs';
import { checkRules } from './rules.mjs';

const ROOT = fileURLToPath(new URL('..', import.meta.url));
const OUT = join(ROOT, 'out');
const TARGET = process.env.CARGO_TARGET_DIR ?? join(ROOT, 'target');
mkdirSync(OUT, { recursive: true });

/** The bytes that all files of the page may have after compression. */
const SIZE = 1_760_000;
/** Milliseconds until the first model is shown, and from the move of a slider until its model is. */
const TIMES = { first: 2000, slider: 50 };
/** Times are bounds for a quiet machine; a busy one is allowed this factor. */
const SLACK = 5;

const hash = (bytes) => createHash('sha256').update(bytes).digest('hex').slice(0, 16);
const brotli = (file) => execFileSync('brotli', ['-q', '11', '-w', '24', '-c', join(ROOT, 'dist', file)], { maxBuffer: 1 << 28 }).length;
const median = (list) => list.toSorted((a, b) => a - b)[Math.floor(list.length / 2)];

/** The bytes of the file that the page has made. */
async function glbOf(page) {
  const folder = join(OUT, 'downloads');
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder);
  const client = await page.createCDPSession();
  await client.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: folder });
  await page.click('#download');
  const name = await page.evaluate(() => `${document.querySelector('#grammar').value}-${document.querySelector('#seed').value}.glb`);
  const path = join(folder, name);
  // The browser makes an empty file first.
  const isSaved = () => existsSync(path) && 0 < statSync(path).size;
  for (let tries = 0; tries < 100 && !isSaved(); tries++) await new Promise((resolve) => setTimeout(resolve, 100));
  ensure(isSaved(), `${name} was not saved`);
  return readFileSync(path);
}

/** The bytes of the same request without a browser. */
function nativeGlb(request) {
  execFileSync(join(TARGET, 'debug', 'glb'), [OUT], { input: `native.glb ${JSON.stringify(request)}\n` });
  return readFileSync(join(OUT, 'native.glb'));
}

/** Sets the value of a control as a person does. */
const set = (name, value) => {
  const row = document.querySelector(`[data-name="${name}"]`);
  const input = row.querySelector('input[type=range]') ?? row.querySelector('input, select');
  if (input.type === 'checkbox') input.click();
  else {
    input.value = value;
    input.dispatchEvent(new Event('input', { bubbles: true }));
    input.dispatchEvent(new Event('change', { bubbles: true }));
  }
};

const server = await serve(0);
const { browser, close } = await startBrowser();
const { page, said } = await openPage(browser, server.address);
const quiet = () => {
  equal(said, [], 'messages of the page');
};

const grammars = await page.$$eval('#grammar option', (options) => options.map(({ value, text }) => ({ name: value, title: text })));
await check('the page has grammars', () => {
  ensure(grammars.length >= 3 && new Set(grammars.map(({ name }) => name)).size === grammars.length, 'too few');
  return grammars.map(({ name }) => name).join(', ');
});

await check('the first model is shown soon', async () => {
  const times = [];
  const modules = [];
  for (let again = 0; again < 3; again++) {
    await page.reload();
    await page.waitForFunction(() => document.querySelector('#view').dataset.grammar);
    times.push(await page.evaluate(() => performance.getEntriesByName('first-model')[0].startTime));
    modules.push(await page.evaluate(() => performance.getEntriesByName('loaded')[0].startTime));
  }
  const figure = `${times.map((time) => time.toFixed(0)).join(', ')} ms, of which until the module is ready ${modules.map((time) => time.toFixed(0)).join(', ')} ms`;
  ensure(median(times) < TIMES.first * SLACK, figure);
  return figure;
});

await check('the page is within its size', () => {
  const sizes = readdirSync(join(ROOT, 'dist')).map((file) => [file, brotli(file)]);
  const sum = sizes.reduce((sum, [, size]) => sum + size, 0);
  const figure = `${sum} of ${SIZE} bytes: ${sizes.map((size) => size.join(' ')).join(', ')}`;
  ensure(sum <= SIZE, figure);
  return figure;
});

for (const { name } of grammars) {
  await check(`${name}: the file equals the file of this machine`, async () => {
    if (name !== (await page.$eval('#grammar', (menu) => menu.value))) await page.select('#grammar', name);
    await page.waitForFunction((name) => document.querySelector('#view').dataset.grammar === name, {}, name);
    await page.waitForFunction(() => document.querySelector('#view').dataset.sky);
    await settle(page);
    equal(await page.$eval('#error', (error) => error.textContent), '', 'error');
    await page.screenshot({ path: join(OUT, `${name}.png`) });
    const seed = await page.$eval('#seed', (input) => input.valueAsNumber);
    const own = await glbOf(page);
    const native = nativeGlb({ grammar: name, seed });
    equal(hash(own), hash(native), 'hash');
    equal(hash(nativeGlb({ grammar: name })), hash(native), 'hash without a seed');
    const changed = nativeGlb({ grammar: name, seed: seed + 1 });
    await afterRun(page, () => document.querySelector('#next-seed').click());
    equal(hash(await glbOf(page)), hash(changed), 'hash of the next seed');
    return `${own.length} bytes, ${hash(own)}, ${await page.$eval('#numbers', (numbers) => numbers.textContent)}`;
  });
}

/** Opens a grammar and returns its first slider. */
async function openSlider(name) {
  await page.select('#grammar', name);
  await page.waitForFunction((name) => document.querySelector('#view').dataset.grammar === name, {}, name);
  return page.$eval('#attributes input[type=range]', (input) => ({
    name: input.closest('[data-name]').dataset.name, min: Number(input.min), max: Number(input.max), step: Number(input.step), value: Number(input.value),
  }));
}

/** Moves a slider in the page and returns the times. */
async function moveSlider(afterRun, name, values) {
  const input = document.querySelector(`[data-name="${name}"] input[type=range]`);
  const times = [];
  for (const value of values) {
    await afterRun(() => {
      input.value = value;
      input.dispatchEvent(new Event('input', { bubbles: true }));
    });
    times.push(Number(document.querySelector('#view').dataset.took));
  }
  return times;
}

// The tower is the last: the checks below go on with it.
let slider;
for (const name of ['office_tower', 'pavilion', 'town_house', 'skyline', 'tower']) {
  slider = await openSlider(name);
  await check(`${name}: a slider changes the model`, async () => {
    // Around the default: at the lower end, a model has fewer parts.
    const values = Array.from({ length: 24 }, (_, at) => slider.value + slider.step * ((at % 5) - 2));
    const times = await inPage(page, moveSlider, slider.name, values);
    const late = times.slice(4);
    const figure = `run and load ${Math.min(...late).toFixed(1)} ms at least, ${median(late).toFixed(1)} ms median, ${Math.max(...late).toFixed(1)} ms at most`;
    // The quickest step: other programs on the machine slow down the rest.
    ensure(Math.min(...late) < TIMES.slider * SLACK, figure);
    return figure;
  });
}

await check('a changed attribute gives the file of this machine', async () => {
  const value = Math.round(slider.min + (slider.max - slider.min) * 0.7);
  await afterRun(page, set, slider.name, value);
  const seed = await page.$eval('#seed', (input) => input.valueAsNumber);
  const shown = await page.$eval(`[data-name="${slider.name}"] input[type=number]`, (input) => input.valueAsNumber);
  const own = await glbOf(page);
  equal(hash(own), hash(nativeGlb({ grammar: 'tower', seed, values: { [slider.name]: shown } })), 'hash');
  ensure(hash(own) !== hash(nativeGlb({ grammar: 'tower', seed })), 'the tower did not change');
});

await check('one attribute is reset', async () => {
  await afterRun(page, (name) => document.querySelector(`[data-name="${name}"] .undo`).click(), slider.name);
  equal(await page.$eval(`[data-name="${slider.name}"] input[type=range]`, (input) => Number(input.value)), slider.value);
  ensure(await page.$eval(`[data-name="${slider.name}"] .undo`, (button) => button.hidden), 'the button is still there');
});

await check('a click finds the leaf and the line of its rule', async () => {
  const box = await page.$eval('#view', (view) => {
    const { left, top, width, height } = view.getBoundingClientRect();
    return { left, top, width, height };
  });
  await page.mouse.click(box.left + box.width * 0.5, box.top + box.height * 0.5);
  await page.waitForFunction(() => document.querySelector('#picked').textContent.includes(' of '));
  const text = await page.$eval('#picked', (picked) => picked.textContent);
  const [, rule] = /^One leaf of (\w+): lines? \d+/.exec(text) ?? [];
  ensure(rule, text);
  const marked = await page.$$eval('.cm-line.marked', (lines) => lines.map((line) => line.textContent));
  ensure(marked.length && marked.every((line) => line.includes(rule)), marked.join('\n'));
  await page.waitForFunction(() => !document.querySelector('#chain').hidden);
  const steps = await page.$$eval('#steps button', (steps) => steps.map((step) => step.textContent));
  ensure(steps[0] === 'Lot' && steps.at(-1) === `${rule}.`, steps.join(', '));
  ensure(steps.some((step) => step.includes('(')), `no arguments in ${steps.join(', ')}`);
  await page.screenshot({ path: join(OUT, 'picked.png') });
  return `${text}: ${steps.join(' > ')}`;
});

await check('Escape ends the selection', async () => {
  await page.focus('#view');
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => !document.querySelector('.cm-line.marked') && document.querySelector('#chain').hidden);
});

await check('the table of parts selects all leaves of a rule by keyboard', async () => {
  await page.focus('#tab-rules');
  await page.keyboard.press('ArrowRight');
  ensure(await page.$eval('#reports', (panel) => !panel.hidden), 'the tab did not open');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('#picked').textContent.startsWith('All'));
  const text = await page.$eval('#picked', (picked) => picked.textContent);
  ensure(/^All [\d,]+ leaves of \w+/.test(text), text);
  ensure(await page.evaluate(() => document.activeElement.getAttribute('aria-pressed') === 'true'), 'the focus was lost');
  await page.screenshot({ path: join(OUT, 'reports.png') });
  await page.keyboard.press('Enter');
  return text;
});

await check('arrow keys turn the view', async () => {
  await page.focus('#view');
  const before = await page.screenshot({ clip: { x: 320, y: 120, width: 400, height: 500 } });
  for (let again = 0; again < 5; again++) await page.keyboard.press('ArrowLeft');
  await settle(page);
  const after = await page.screenshot({ clip: { x: 320, y: 120, width: 400, height: 500 } });
  ensure(Buffer.compare(Buffer.from(before), Buffer.from(after)) !== 0, 'the picture did not change');
});

await check('every control changes its attribute', async () => {
  const seen = {};
  for (const { name } of grammars) {
    await page.select('#grammar', name);
    await page.waitForFunction((name) => document.querySelector('#view').dataset.grammar === name, {}, name);
    const rows = await page.$$eval('#attributes [data-name]', (rows) => rows.map((row) => {
      const input = row.querySelector('input[type=range]') ?? row.querySelector('input, select');
      ensureLabel(row);
      return { name: row.dataset.name, type: input.type, min: input.min, max: input.max, value: input.value, options: [...(input.options ?? [])].map(({ text }) => text) };
      function ensureLabel(row) {
        for (const input of row.querySelectorAll('input, select')) {
          if (!input.labels.length && !input.getAttribute('aria-label')) throw new Error(`${row.dataset.name} has no label`);
        }
      }
    }));
    const changes = rows.map((row) => ({ ...row, value: {
      range: String(Number(row.value) === Number(row.max) ? row.min : row.max), color: '#123456',
      'select-one': row.options.find((text) => text !== row.value),
    }[row.type] })).filter(({ type, value }) => type === 'checkbox' || value !== undefined);
    const wrong = await inPage(page, async (afterRun, set, changes) => {
      const wrong = [];
      const error = document.querySelector('#error');
      for (const { name, value } of changes) {
        await afterRun(() => set(name, value));
        const undo = document.querySelector(`[data-name="${name}"] .undo`);
        if (error.textContent || undo.hidden) wrong.push(`${name} did not change: ${error.textContent}`);
        await afterRun(() => undo.click());
        if (error.textContent || !undo.hidden) wrong.push(`${name} was not reset: ${error.textContent}`);
      }
      return wrong;
    }, set, changes);
    equal(wrong, [], name);
    for (const { type } of changes) seen[type] = (seen[type] ?? 0) + 1;
  }
  return JSON.stringify(seen);
});

await check('values are refused with a sentence', async () => {
  // A page of its own: the page rewrites the address.
  const other = await openPage(browser, `${server.address}#grammar=tower&.${slider.name}=1e9&.nothing=1&seed=3`);
  await settle(other.page);
  const text = await other.page.$eval('#error', (error) => error.textContent);
  ensure(text.includes('outside of') && text.includes('unknown attribute `nothing`'), text);
  equal(await other.page.$eval('#seed', (input) => input.value), '3', 'seed');
  await other.page.close();
  return text;
});

await check('a number outside its range is refused with a sentence', async () => {
  const row = `[data-name="${slider.name}"]`;
  await page.select('#grammar', 'tower');
  await page.waitForFunction(() => document.querySelector('#view').dataset.grammar === 'tower');
  const before = await page.$eval(`${row} input[type=number]`, (input) => input.value);
  await page.click(`${row} input[type=number]`, { clickCount: 3 });
  await page.keyboard.type('1e7');
  await page.keyboard.press('Enter');
  const text = await page.$eval('#announce', (announce) => announce.textContent);
  ensure(/: takes \S+ to \S+\.$/.test(text), text);
  equal(await page.$eval(`${row} input[type=number]`, (input) => input.value), before, 'value');
  return text;
});

await check('a reset by keyboard keeps the focus at its attribute', async () => {
  const row = `[data-name="${slider.name}"]`;
  await afterRun(page, set, slider.name, slider.max);
  await page.focus(`${row} .undo`);
  await afterRun(page, (row) => document.querySelector(`${row} .undo`).click(), row);
  equal(await page.evaluate((row) => document.activeElement.closest(row) !== null, row), true, 'the focus');
});

await check('a refused value does not refuse the next change', async () => {
  await page.select('#grammar', 'brick_tower');
  await page.waitForFunction(() => document.querySelector('#view').dataset.grammar === 'brick_tower');
  await page.evaluate(set, 'height', 100000);
  await page.waitForFunction(() => document.querySelector('#error').textContent);
  await afterRun(page, set, 'storey', 4);
  equal(await page.$eval('#error', (error) => error.textContent), '', 'error');
});

await check('of grammars that are chosen at once the last is shown', async () => {
  const file = nativeGlb({ grammar: 'massing' });
  await page.evaluate(() => {
    const menu = document.querySelector('#grammar');
    for (const name of ['marked_streets', 'brick_tower', 'massing']) {
      menu.value = name;
      menu.dispatchEvent(new Event('change', { bubbles: true }));
    }
  });
  await page.waitForFunction(() => document.querySelector('#view').dataset.grammar === 'massing');
  await new Promise((resolve) => setTimeout(resolve, 2000));
  equal(await page.$eval('#view', (view) => view.dataset.grammar), 'massing');
  equal(hash(await glbOf(page)), hash(file), 'hash');
});

await check('a link restores grammar, attributes, seed and camera', async () => {
  const other = grammars.find(({ name }) => name !== 'tower').name;
  await page.goto(`${server.address}#grammar=${other}`);
  await page.reload();
  await page.waitForFunction((name) => document.querySelector('#view').dataset.grammar === name, {}, other);
  await page.select('#grammar', 'tower');
  await page.waitForFunction(() => document.querySelector('#view').dataset.grammar === 'tower');
  await afterRun(page, set, slider.name, slider.max);
  await afterRun(page, () => document.querySelector('#next-seed').click());
  await page.focus('#view');
  for (const key of ['ArrowLeft', 'ArrowLeft', '+']) await page.keyboard.press(key);
  await new Promise((resolve) => setTimeout(resolve, 500));
  const link = page.url();
  const view = await page.$eval('#numbers', (numbers) => numbers.textContent.split(', made')[0]);
  const second = await openPage(browser, link);
  await settle(second.page);
  const values = await second.page.evaluate((name) => [
    document.querySelector('#grammar').value, document.querySelector('#seed').value,
    document.querySelector(`[data-name="${name}"] input[type=range]`).value,
    document.querySelector('#numbers').textContent.split(', made')[0],
  ], slider.name);
  const seed = await page.$eval('#seed', (input) => input.value);
  equal(values, ['tower', seed, String(slider.max), view]);
  await new Promise((resolve) => setTimeout(resolve, 500));
  equal(decode(new URL(second.page.url()).hash), decode(new URL(link).hash), 'state');
  equal(second.said, [], 'messages');
  await second.page.close();
  return link.slice(link.indexOf('#'));
});

await check('broken links open the page', async () => {
  for (const hash of ['#grammar=nothing', '#seed=-1&camera=1,2', '#.height={', '#%', '#camera=NaN,1,2,3,4,5', '#camera=1e308,1e308,1,2,3,4', '#rules=(', '#lot=file', '#lot=0x0&start=Nothing', '#grammar=tower&seed=99999999999999999999']) {
    const other = await openPage(browser, server.address + hash);
    equal(other.said, [], `messages with ${hash}`);
    await other.page.close();
  }
  equal(decode(encode({ grammar: 'a', seed: 7, values: { b: [1, 'x&=#'], c: null }, camera: [1, 2, 3, 4, 5, 6], rules: 'A -->\n%#&"', lot: '4x5', start: null, name: null })), {
    grammar: 'a', seed: 7, values: { b: [1, 'x&=#'], c: null }, camera: [1, 2, 3, 4, 5, 6], rules: 'A -->\n%#&"', lot: '4x5', start: null, name: null,
  });
});

await checkRules({ browser, server, page, root: ROOT, out: OUT, target: TARGET });
await checkFloor({ browser, server, out: OUT });

await check('the page said nothing', quiet);

await check('narrow and dark pages fit', async () => {
  for (const [file, options] of [
    ['narrow', { width: 390, height: 844 }],
    ['dark', { scheme: 'dark' }],
  ]) {
    const other = await openPage(browser, `${server.address}#grammar=tower`, options);
    await other.page.waitForFunction(() => document.querySelector('#view').dataset.sky);
    await settle(other.page);
    const wide = await other.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    await other.page.screenshot({ path: join(OUT, `${file}.png`), fullPage: file === 'narrow' });
    equal(wide, 0, `pixels beyond the ${file} page`);
    equal(other.said, [], 'messages');
    await other.page.close();
  }
});

await check('a part of the town houses is marked', async () => {
  const other = await openPage(browser, `${server.address}#grammar=town_house`);
  await other.page.waitForFunction(() => document.querySelector('#view').dataset.sky);
  await other.page.mouse.click(652, 520);
  await settle(other.page);
  await other.page.waitForFunction(() => document.querySelector('.cm-line.marked') && !document.querySelector('#chain').hidden);
  await settle(other.page);
  await other.page.screenshot({ path: join(OUT, 'guide.png') });
  await other.page.close();
});

await close();
server.close();
finish();
