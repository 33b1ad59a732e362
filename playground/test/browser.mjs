// A headless browser with an empty profile, and what a page said.

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';

// Without these, the browser looks for its maker's hosts at every start.
const QUIET = ['--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

export async function startBrowser() {
  const profile = mkdtempSync(join(tmpdir(), 'cga-playground-'));
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    userDataDir: profile,
    args: ['--no-sandbox', '--enable-unsafe-swiftshader', ...QUIET],
    protocolTimeout: 240_000,
  });
  return {
    browser,
    async close() {
      await browser.close();
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

/** Opens a page that records errors and warnings in `said`. */
export async function openPage(browser, address, { width = 1280, height = 800, scheme = 'light', hasWebGL = true } = {}) {
  const page = await browser.newPage();
  const said = [];
  page.on('console', (message) => {
    // Software rendering warns that it is slow to read pixels.
    const isSlow = /GPU stall|GL Driver Message/.test(message.text());
    if (['error', 'warn'].includes(message.type()) && !isSlow) said.push(message.text());
  });
  page.on('pageerror', (error) => said.push(String(error)));
  page.on('requestfailed', (request) => said.push(`not loaded: ${request.url()}`));
  if (!hasWebGL) {
    await page.evaluateOnNewDocument(() => {
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith('webgl') ? null : getContext.call(this, kind, ...rest);
      };
    });
  }
  await page.setViewport({ width, height });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
  await page.goto(address);
  await page.waitForFunction(() => document.querySelector('#view').dataset.grammar, { timeout: 60_000 });
  return { page, said };
}

/** Waits until two frames were drawn. */
export const settle = (page) => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));

/**
 * Runs a function in the page. Its first argument is a function that makes a change and waits for the model of it. No picture is
 * drawn between such changes, which would take seconds without a graphics processor.
 */
export function inPage(page, run, ...values) {
  const afterRun = async (change) => {
    let observer;
    let timer;
    const made = new Promise((resolve, reject) => {
      observer = new MutationObserver(resolve);
      observer.observe(document.querySelector('#view'), { attributeFilter: ['data-made'] });
      timer = setTimeout(() => reject(new Error('no model was made')), 30_000);
    });
    change();
    await made.finally(() => {
      observer.disconnect();
      clearTimeout(timer);
    });
  };
  const texts = values.map((value) => (typeof value === 'function' ? String(value) : JSON.stringify(value)));
  return page.evaluate(`(${run})(${[afterRun, ...texts].join(', ')})`);
}

/** Runs a function in the page and waits until the engine has answered a request that was made after it, with or without a model. */
export async function afterAnswer(page, change) {
  const count = () => page.$eval('#view', (view) => Number(view.dataset.answers ?? 0));
  const before = await count();
  await change();
  await page.waitForFunction((before) => before < Number(document.querySelector('#view').dataset.answers ?? 0) && document.querySelector('#view').dataset.busy === 'false', { timeout: 60_000 }, before);
}

/** Puts a text into the editor in place of its own, as a person pastes it. */
export async function paste(page, text) {
  await page.focus('.cm-content');
  for (const [key, press] of [['Control', 'down'], ['a', 'press'], ['Control', 'up']]) await page.keyboard[press](key);
  await afterAnswer(page, () => page.keyboard.sendCharacter(text));
}

/** Runs a function in the page and waits until a model made after it is shown. */
export function afterRun(page, change, ...values) {
  return inPage(page, (afterRun, change, values) => afterRun(() => change(...values)), change, values);
}
