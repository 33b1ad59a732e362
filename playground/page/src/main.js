// The playground: a grammar, its attributes, a view, its rules.

import { copy } from './clipboard.js';
import { Controls, element } from './controls.js';
import { Editor } from './editor.js';
import { load, run } from './engine.js';
import { short, showReports } from './reports.js';
import { RuleText } from './rules.js';
import { decode, encode } from './state.js';
import { makeTabs } from './tabs.js';
import { View } from './view.js';

const get = (id) => document.getElementById(id);
const state = { grammar: null, seed: 0, values: {} };
/** The run on screen, and the seed and the values that it has. */
let current = null;
let shown = null;
let catalog = [];
/** What is selected: `{ rule, leaf }`. */
let picked = null;

/** Shows a sentence for some seconds. */
let silence = 0;
const announce = (text) => {
  get('announce').textContent = text;
  clearTimeout(silence);
  silence = setTimeout(() => (get('announce').textContent = ''), 4000);
};
let view = null;
const controls = new Controls(get('attributes'), (name, value) => {
  if (value === null) delete state.values[name];
  else state.values[name] = value;
  update();
}, announce);
const rules = new RuleText(get('rules'), (rule) => choose(rule));
const editor = new Editor({
  text: get('text'), marks: get('marks'), findings: get('findings'), title: get('findings-title'),
  name: get('rust-name'), copy: get('copy-rust'), announce, onType: () => later(),
});
const openTab = makeTabs(document.querySelector('[role=tablist]'), (panel) => {
  if (panel === 'check') editor.open().catch((error) => fail(`The checker could not be loaded: ${error.message}`));
  if (panel === 'rules') mark();
});

start().catch((error) => fail(`The page could not be loaded: ${error.message}`));

async function start() {
  view = new View(get('view'), { onPick: pick, onMove: () => later(), onCancel: () => choose(null) });
  catalog = await load();
  performance.mark('loaded');
  get('grammar').replaceChildren(...catalog.map(({ name, title }) => new Option(title, name)));
  get('grammar').addEventListener('change', () => change({ grammar: get('grammar').value }));
  get('seed').addEventListener('change', () => {
    if (get('seed').validity.valid) return setSeed(get('seed').valueAsNumber);
    get('seed').value = state.seed;
    announce('The seed is a whole number from 0.');
  });
  get('next-seed').addEventListener('click', () => setSeed((state.seed + 1) % Number.MAX_SAFE_INTEGER));
  get('reset-all').addEventListener('click', () => {
    state.values = {};
    update();
  });
  get('reset-view').addEventListener('click', () => {
    view.frameView(entry().view, current.facts);
    later();
  });
  get('download').addEventListener('click', download);
  get('copy-link').addEventListener('click', async () => {
    const isWhole = write();
    const done = isWhole ? 'The link is copied.' : 'The link is copied without the rules: they are too long for a link.';
    await copy(location.href).then(() => announce(done), (error) => announce(error.message));
  });
  window.addEventListener('hashchange', () => location.hash !== written && change(decode(location.hash)));
  await inOrder(() => open(decode(location.hash)));
  performance.mark('first-model');
  requestAnimationFrame(() => setTimeout(() => {
    view.addSky();
    view.parent.dataset.sky = 'true';
  }, 100));
}

function entry() {
  return catalog.find(({ name }) => name === state.grammar);
}

/** Work on the model, one piece after the other: a model that takes longer to load must not replace a later one. */
let queue = Promise.resolve();
function inOrder(work) {
  const done = queue.then(work);
  queue = done.catch(() => {});
  return done;
}

/** Opens a grammar, unless another one is chosen before its turn. */
let choices = 0;
function change(link) {
  const choice = ++choices;
  inOrder(() => choice === choices && open(link)).catch((error) => fail(error.message));
}

/** Shows a grammar with the values of a link, or with its own. */
async function open({ grammar, seed = null, values = {}, camera = null, rules: text = null }) {
  const found = catalog.find(({ name }) => name === grammar) ?? catalog[0];
  const notes = [];
  if (grammar && grammar !== found.name) notes.push(`this page has no grammar “${grammar}”`);
  Object.assign(state, { grammar: found.name, seed: seed ?? found.seed, values: {} });
  get('grammar').value = found.name;
  const pieces = found.sentence.split('`');
  get('sentence').replaceChildren(...pieces.map((piece, at) => (at % 2 ? element('code', {}, piece) : piece)));
  rules.build(found.rules);
  picked = null;
  let made = make();
  // One value of a link that is refused must not lose the others.
  for (const [name, value] of Object.entries(values)) {
    const before = { ...state.values };
    state.values[name] = value;
    try {
      made = make();
    } catch (error) {
      notes.push(error.message);
      state.values = before;
    }
  }
  controls.build(made.facts.attributes);
  await put(made);
  view.frameView(found.view, current.facts);
  if (camera) view.cameraNumbers = camera;
  // A link without rules leaves a text that a person has typed.
  if (text !== null) {
    editor.value = text;
    openTab('check');
  }
  view.parent.dataset.grammar = found.name;
  fail(notes.join('; '));
}

/** Runs the grammar of the state. */
function make() {
  const begin = performance.now();
  const made = run({ grammar: state.grammar, values: state.values, seed: state.seed });
  return { ...made, took: performance.now() - begin };
}

/** Runs the grammar again. Changes during a run are in the next one. */
let isChanged = false;
function update() {
  if (isChanged) return;
  isChanged = true;
  inOrder(again);
}

async function again() {
  isChanged = false;
  try {
    await put(make());
    fail('');
  } catch (error) {
    fail(error.message);
    if (!shown) return;
    // A refused value must not refuse the next change too.
    Object.assign(state, { seed: shown.seed, values: { ...shown.values } });
    get('seed').value = state.seed;
    controls.show(current.facts.attributes, current.facts.used);
  }
}

/** Shows a run. */
async function put(made) {
  const begin = performance.now();
  current?.free();
  current = made;
  shown = { seed: state.seed, values: { ...state.values } };
  const { facts, glb } = made;
  get('seed').value = state.seed;
  controls.show(facts.attributes, facts.used);
  await view.show(glb, facts);
  const triangles = view.renderer ? countTriangles(view.model) : 0;
  const loaded = performance.now() - begin;
  get('numbers').textContent = `${short(facts.report.leaves)} parts, ${short(triangles)} triangles, made in ${made.took.toFixed(1)} ms, loaded in ${loaded.toFixed(1)} ms`;
  get('view').dataset.made = String(Number(get('view').dataset.made ?? 0) + 1);
  get('view').dataset.took = String(made.took + loaded);
  rules.offer(facts.rules);
  if (picked && !facts.rules.some(({ name }) => name === picked.rule)) picked = null;
  // Leaves of the new model have other numbers.
  if (picked) picked = { rule: picked.rule };
  mark();
  later();
}

function countTriangles(model) {
  let count = 0;
  model.traverse(({ geometry }) => (count += geometry ? geometry.index.count / 3 : 0));
  return count;
}

function pick(origin, direction) {
  const hit = current?.pick(origin, direction);
  choose(hit?.rule ?? null, hit?.leaf);
}

/** Selects a leaf, or all leaves of a rule; null selects nothing. */
function choose(rule, leaf) {
  picked = rule === null ? null : { rule, leaf };
  mark();
}

/** Shows the selection in the view, in the rules and in the table. */
function mark() {
  if (!current) return;
  const { facts } = current;
  const found = facts.rules.find(({ name }) => name === picked?.rule);
  rules.mark(found?.lines ?? []);
  const triangles = found && (picked.leaf === undefined ? current.ruleTriangles(picked.rule) : current.leafTriangles(picked.leaf));
  view.highlight(triangles ?? null);
  const lines = found ? `line${found.lines.length === 1 ? '' : 's'} ${found.lines.join(', ')}` : '';
  get('picked').textContent = found
    ? `${picked.leaf === undefined ? `All ${short(found.leaves)} leaves` : 'One leaf'} of ${found.name}: ${lines}`
    : 'Click a part to find its rule.';
  showReports(get('reports'), facts, picked?.rule ?? null, (rule) => choose(rule === picked?.rule ? null : rule));
}

function setSeed(seed) {
  state.seed = seed;
  update();
}

function download() {
  const url = URL.createObjectURL(new Blob([current.glb], { type: 'model/gltf-binary' }));
  const link = Object.assign(document.createElement('a'), { href: url, download: `${state.grammar}-${state.seed}.glb` });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
  announce(`Saved ${link.download}.`);
}

/** Longer links are cut by some programs. In characters of the rules. */
const LONGEST = 8000;

/** Puts the state into the address. False if the rules of the checker are too long for it. */
let written = '';
function write() {
  const text = editor.value;
  const isWhole = (text ?? '').length <= LONGEST;
  written = encode({ ...state, camera: view.cameraNumbers, rules: isWhole ? text : null });
  history.replaceState(null, '', written);
  return isWhole;
}

/** Browsers limit changes of the address, and a drag makes many. */
let timer = 0;
function later() {
  if (!current) return;
  clearTimeout(timer);
  timer = setTimeout(write, 250);
}

function fail(text) {
  get('error').textContent = text;
  get('error').hidden = !text;
}
