// The floor of the page: no WebGL, a lost context, a growing model, a phone, a drag.

import { join } from 'node:path';
import { afterAnswer, openPage, settle } from './browser.mjs';
import { check, ensure, equal } from './checks.mjs';
import { typeAndErr } from './rules.mjs';

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const slide = (name, value) => {
  const input = document.querySelector(`[data-name=${name}] input[type=range]`);
  input.value = value;
  input.dispatchEvent(new Event('input', { bubbles: true }));
};

export async function checkFloor({ browser, server, out }) {
  await check('without WebGL typed rules run', async () => {
    const { page, said } = await openPage(browser, `${server.address}#grammar=house`, { hasWebGL: false });
    ensure(await page.$eval('#no-view', (note) => note.textContent.includes('WebGL')), 'no note');
    await typeAndErr(page);
    await page.screenshot({ path: join(out, 'no-webgl.png') });
    equal(said.filter((text) => !/WebGL/.test(text)), [], 'messages');
    await page.close();
  });

  await check('on a phone typed rules run, and the view stays in sight', async () => {
    const { page, said } = await openPage(browser, `${server.address}#grammar=house`, { width: 390, height: 844 });
    await typeAndErr(page);
    const isSeen = () => page.$eval('#view', (view) => view.getBoundingClientRect().top < 100 && 0 <= view.getBoundingClientRect().bottom);
    await page.evaluate(() => window.scrollTo(0, document.body.scrollHeight));
    await settle(page);
    ensure(await isSeen(), 'the view is out of sight');
    await page.screenshot({ path: join(out, 'phone-scrolled.png') });
    await page.evaluate(() => window.scrollTo(0, 0));
    const box = await page.$eval('#view', (view) => view.getBoundingClientRect().toJSON());
    await page.mouse.click(box.left + box.width * 0.5, box.top + box.height * 0.6);
    await page.waitForFunction(() => document.querySelector('.cm-line.marked'));
    await pause(300);
    const [line, stage] = await page.evaluate(() => ['.cm-line.marked', '#stage'].map((name) => document.querySelector(name).getBoundingClientRect().toJSON()));
    ensure(stage.bottom <= line.top && line.bottom <= 844, `the line is from ${line.top} to ${line.bottom}, the view ends at ${stage.bottom}`);
    await page.screenshot({ path: join(out, 'phone-picked.png') });
    equal(said, [], 'messages');
    await page.close();
  });

  await check('a model that grows is fitted into the view', async () => {
    const { page } = await openPage(browser, `${server.address}#grammar=tower`);
    const camera = () => page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get('camera'));
    const isOther = (before) => page.waitForFunction((before) => (new URLSearchParams(location.hash.slice(1)).get('camera') ?? before) !== before, { timeout: 60_000 }, before);
    await isOther(null);
    const before = await camera();
    await afterAnswer(page, () => page.evaluate(slide, 'storeys', 80));
    await isOther(before);
    const after = await camera();
    const distance = (camera) => {
      const numbers = camera.split(',').map(Number);
      return Math.hypot(...[0, 1, 2].map((axis) => numbers[axis] - numbers[axis + 3]));
    };
    await page.screenshot({ path: join(out, 'grown.png') });
    ensure(1.5 * distance(before) < distance(after), `${before} ${after}`);
    await afterAnswer(page, () => page.evaluate(slide, 'storeys', 8));
    await pause(1500);
    equal(await camera(), after, 'a smaller model moves nothing');
    await page.close();
  });

  await check('while a slider is dragged no shadows are drawn', async () => {
    const { page } = await openPage(browser, `${server.address}#grammar=house`);
    await page.waitForFunction(() => document.querySelector('#view').dataset.sky);
    const shadows = () => page.$eval('#view', (view) => Number(view.dataset.shadows));
    await pause(600);
    const before = await shadows();
    const box = await page.$eval('[data-name=height] input[type=range]', (input) => input.getBoundingClientRect().toJSON());
    await page.mouse.move(box.left + box.width * 0.25, box.top + box.height / 2);
    await page.mouse.down();
    for (const at of [0.3, 0.4, 0.5, 0.6]) {
      await afterAnswer(page, () => page.mouse.move(box.left + box.width * at, box.top + box.height / 2));
      await pause(300);
    }
    equal(await shadows(), before, 'shadows during the drag');
    await page.mouse.up();
    await page.waitForFunction((before) => Number(document.querySelector('#view').dataset.shadows) === before + 1, {}, before);
    await page.close();
  });

  await check('a lost context comes back with its light', async () => {
    const { page, said } = await openPage(browser, `${server.address}#grammar=house`);
    await page.waitForFunction(() => document.querySelector('#view').dataset.sky);
    await pause(800);
    const before = await page.screenshot({ clip: { x: 320, y: 120, width: 500, height: 560 } });
    const first = await colourOf(page, before);
    await page.evaluate(() => {
      const canvas = document.querySelector('#view canvas');
      window.lost = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
      window.lost.loseContext();
    });
    await pause(500);
    await page.evaluate(() => window.lost.restoreContext());
    await pause(1500);
    const second = await colourOf(page, await page.screenshot({ clip: { x: 320, y: 120, width: 500, height: 560 } }));
    await page.screenshot({ path: join(out, 'restored.png') });
    const difference = Math.max(...first.map((value, at) => Math.abs(value - second[at])));
    ensure(difference <= 2, `${first} was ${second} afterwards`);
    equal(said.filter((text) => !/context/i.test(text)), [], 'messages');
    await page.close();
    return `${first} and ${second}`;
  });
}

/** The mean colour of a picture. */
function colourOf(page, picture) {
  return page.evaluate(async (data) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const small = new OffscreenCanvas(50, 50).getContext('2d');
    small.drawImage(image, 0, 0, 50, 50);
    const sums = [0, 0, 0];
    small.getImageData(0, 0, 50, 50).data.forEach((value, at) => at % 4 < 3 && (sums[at % 4] += value));
    return sums.map((sum) => Math.round(sum / 2500));
  }, Buffer.from(picture).toString('base64'));
}
