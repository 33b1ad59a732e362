// The playground: rules, their attributes and lots, a view.

import { showChain } from './chain.js';
import { copy } from './clipboard.js';
import { Controls, element } from './controls.js';
import { makeDivider } from './divider.js';
import { FILES } from './downloads.js';
import { Editor } from './editor.js';
import { Engine } from './engine.js';
import { takeFiles } from './files.js';
import { LotMenu, isLotName, lotOf } from './lots.js';
import { short, showReports } from './reports.js';
import { asRust, isTypeName, plainRules } from './rust.js';
import { decode, encode } from './state.js';
import { makeTabs } from './tabs.js';
import { NoView, View } from './view.js';

const get = (id) => document.getElementById(id);
/** `rules` is null for the rules of the catalog, `lot` the name of a lot or `file`, `name` null for the name of the catalog. */
const state = { grammar: null, rules: null, name: null, lot: null, start: null, seed: 0, values: {} };
const engine = new Engine();
/** The model on screen: `{ facts }`, the request that made it, and the state then. */
let current = null;
let shown = null;
let catalog = [];
/** The selection: `{ rule, leaf, triangles, chain }`. */
let picked = null;
/** The file that is the lot. */
let lotFile = null;
let view = null;

/** Shows a sentence for some seconds. */
let silence = 0;
const announce = (text) => {
  get('announce').textContent = text;
  clearTimeout(silence);
  silence = setTimeout(() => (get('announce').textContent = ''), 4000);
};
const controls = new Controls(get('attributes'), (name, value) => {
  if (value === null) delete state.values[name];
  else state.values[name] = value;
  update();
}, announce);
const editor = new Editor({
  parent: get('editor'), list: get('findings'), title: get('findings-title'), onType: typed, onLine: chooseLine,
});
const lots = new LotMenu({
  lot: get('lot'), sides: get('sides'), width: get('width'), depth: get('depth'), start: get('start'),
}, (choice) => {
  Object.assign(state, choice);
  update({ frames: 'lot' in choice });
});
// While a slider is dragged, no shadows are drawn.
get('attributes').addEventListener('pointerdown', ({ target }) => target.type === 'range' && view?.hold(true));
for (const type of ['pointerup', 'pointercancel']) window.addEventListener(type, () => view?.hold(false));
makeTabs(document.querySelector('[role=tablist]'), () => {});
makeDivider(get('divider'), document.querySelector('main'));

start().catch((error) => fail(`The page could not be loaded: ${error.message}`));

async function start() {
  try {
    view = new View(get('view'), { onPick: pick, onMove: later, onCancel: () => choose(null) });
  } catch {
    view = new NoView(get('view'));
  }
  catalog = await engine.load();
  performance.mark('loaded');
  get('grammar').replaceChildren(...catalog.map(({ name, title }) => new Option(title, name)));
  get('grammar').addEventListener('change', () => {
    write();
    history.pushState(null, '', `#grammar=${get('grammar').value}`);
    open({ ...decode(''), grammar: get('grammar').value });
  });
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
    if (current) view.frameView(frame(), current.facts);
    later();
  });
  get('restore').addEventListener('click', () => {
    state.rules = null;
    editor.value = entry().rules;
    update();
  });
  get('close-chain').addEventListener('click', () => choose(null));
  get('download').addEventListener('click', download);
  get('copy-link').addEventListener('click', async () => {
    const isWhole = write();
    const done = isWhole ? 'The link is copied.' : 'The link is copied without the rules: they are too long for a link.';
    await copy(location.href).then(() => announce(done), (error) => announce(error.message));
  });
  get('rust-name').addEventListener('change', () => {
    if (!isName()) return;
    state.name = get('rust-name').value === entry().grammar ? null : get('rust-name').value;
    update();
  });
  get('copy-rust').addEventListener('click', async () => {
    if (isName()) await copy(asRust(get('rust-name').value, editor.value)).then(() => announce('Copied as Rust.'), (error) => announce(error.message));
  });
  takeFiles({ button: get('choose-file'), input: get('file') }, { onLot, onRules, onAsset, announce });
  window.addEventListener('popstate', ({ state: kept }) => open({ ...decode(location.hash), ...kept }));
  await open({ ...decode(location.hash), ...history.state });
  performance.mark('first-model');
  requestAnimationFrame(() => setTimeout(() => {
    view.addSky();
    view.parent.dataset.sky = 'true';
    engine.prepare();
  }, 100));
}

function entry() {
  return catalog.find(({ name }) => name === state.grammar);
}

/** The view of the grammar. The region that a scene shows is a part of its own lots. */
function frame() {
  return state.lot ? { ...entry().view, region: null } : entry().view;
}

function isName() {
  const isRight = isTypeName(get('rust-name').value);
  if (!isRight) {
    get('rust-name').reportValidity();
    announce('The name of a grammar is a name of a Rust type, such as House.');
  }
  return isRight;
}

/** Shows a grammar with the values of a link, or with its own. */
async function open({ grammar, seed, values, camera, rules, lot, start: rule, name }) {
  const found = catalog.find((one) => one.name === grammar) ?? catalog[0];
  const notes = [];
  if (grammar && grammar !== found.name) notes.push(`this page has no grammar “${grammar}”`);
  if (lot === 'file' ? !lotFile : lot && !isLotName(lot)) {
    notes.push('the lot of this link is not known; drop its file on the page');
    lot = null;
  }
  Object.assign(state, {
    grammar: found.name, rules, name: isTypeName(name ?? '') ? name : null, lot, start: rule, seed: seed ?? (lot ? 0 : found.seed), values: { ...values },
  });
  get('grammar').value = found.name;
  const pieces = found.sentence.split('`');
  get('sentence').replaceChildren(...pieces.map((piece, at) => (at % 2 ? element('code', {}, piece) : piece)));
  editor.value = rules ?? found.rules;
  showName();
  choose(null);
  await update({ notes, camera, frames: true, opens: true });
}

function showName() {
  get('rust-name').value = state.name ?? entry().grammar;
  get('restore').hidden = state.rules === null;
}

/** A person has changed the text. */
function typed() {
  const text = editor.value;
  state.rules = text === entry().rules ? null : text;
  if (editor.name && isTypeName(editor.name)) state.name = editor.name;
  showName();
  update();
}

/** The request of the state. */
function request() {
  const { grammar, rules, name, lot, start: rule, seed, values } = state;
  return {
    grammar, name, seed, values: { ...values }, start: rule,
    rules: rules === null ? null : plainRules(rules),
    lot: lot === 'file' ? lotFile.lot : lotOf(lot),
  };
}

/**
 * Runs the grammar of the state and shows the model. The last call counts, and does the tasks of the calls that it supersedes, too.
 * `notes` are shown, `frames` sets the camera, to `camera` if there is one, and `opens` says that another grammar is opened.
 */
let pending = {};
async function update(todo = {}) {
  pending = { ...pending, ...todo };
  get('view').dataset.busy = 'true';
  const [asked, wanted] = [{ ...state, values: { ...state.values } }, request()];
  const answer = await engine.run(wanted);
  if (!answer) return;
  const { notes = [], camera, frames, opens } = pending;
  // Rules with a mistake have no model yet: their first one is framed.
  pending = answer.facts ? {} : { camera, frames };
  get('view').dataset.busy = 'false';
  editor.show(answer.findings);
  const refused = Object.entries(answer.refused);
  for (const [name] of refused) delete state.values[name];
  const problems = [...notes, ...refused.map(([, why]) => why)];
  const mistake = answer.findings.find(({ level }) => level === 'error');
  if (answer.facts) {
    await inOrder(() => put(answer, asked, { frames, camera, opens }));
  } else if (mistake) {
    problems.push(`Line ${mistake.line}: ${mistake.message}. ${mistake.help[0] ? `${sentence(mistake.help[0])} ` : ''}${current ? 'The last model stays.' : ''}`);
  } else {
    problems.push(answer.error);
    restoreValues(asked, opens);
  }
  if (opens) view.parent.dataset.grammar = asked.grammar;
  get('view').dataset.answers = String(Number(get('view').dataset.answers ?? 0) + 1);
  // A refused value was among those of the model before.
  if (refused.length && !opens && shown && JSON.stringify(asked.rules) === JSON.stringify(shown.rules)) restoreValues(asked, false);
  fail(problems.filter(Boolean).join('; '));
  later();
}

const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1) + (/[.?!]$/.test(text) ? '' : '.');

/** Takes back a value that the rules cannot run with. It must not refuse the next change too. */
function restoreValues(asked, opens) {
  if (!shown || opens || asked.grammar !== shown.grammar || asked.rules !== shown.rules) return;
  const { seed, values, lot, start: rule } = shown;
  Object.assign(state, { seed, values: { ...values }, lot, start: rule });
  get('seed').value = state.seed;
  controls.show(current.facts.attributes, current.facts.used);
  lots.show(state.lot, state.start, current.facts.starts);
}

/** Work on the view, one piece after the other: a model that takes longer to load must not replace a later one. */
let queue = Promise.resolve();
function inOrder(work) {
  const done = queue.then(work);
  queue = done.catch(() => {});
  return done;
}

/** Shows a run. */
async function put({ facts, glb, took }, asked, { frames, camera, opens }) {
  const begin = performance.now();
  current = { facts };
  shown = asked;
  get('seed').value = asked.seed;
  controls.update(facts.attributes, facts.used, opens);
  lots.file = lotFile;
  lots.show(asked.lot, asked.start, facts.starts);
  await view.show(glb, facts);
  if (frames) {
    view.frameView(frame(), facts);
    if (camera) view.cameraNumbers = camera;
  }
  const loaded = performance.now() - begin;
  get('numbers').textContent = `${short(facts.report.leaves)} parts, ${short(facts.triangles)} triangles, made in ${took.toFixed(1)} ms, loaded in ${loaded.toFixed(1)} ms`;
  get('view').dataset.made = String(Number(get('view').dataset.made ?? 0) + 1);
  get('view').dataset.took = String(took + loaded);
  // Leaves of the new model have other numbers.
  const rule = facts.rules.some(({ name }) => name === picked?.rule) ? picked.rule : null;
  await choose(rule, null, false);
}

/** Selects the part that a ray hits. */
async function pick(origin, direction) {
  const asked = current;
  const hit = await engine.query('pick', origin, direction).catch(() => null);
  if (asked !== current) return;
  if (!hit) return choose(null);
  await choose(hit.rule, hit);
  const chain = await engine.query('chain', hit.leaf).catch((error) => announce(error.message));
  if (!chain || picked?.leaf !== hit.leaf) return;
  picked.chain = chain;
  showChain(get('steps'), chain, (step) => editor.mark(step.lines, true));
  get('chain').hidden = false;
  // The list takes room from the editor.
  if (!isNarrow()) editor.mark(current.facts.rules.find(({ name }) => name === hit.rule)?.lines ?? [], true);
}

/** Selects the leaves of the rule of a line. */
function chooseLine(line) {
  const rule = current?.facts.rules.find(({ lines }) => lines.includes(line));
  if (rule && rule.name !== picked?.rule) choose(rule.name, null, false);
}

/** Selects a leaf, or all leaves of a rule; null selects nothing. Shows the line of the rule, if `reveals`. */
async function choose(rule, hit = null, reveals = true) {
  picked = rule === null ? null : { rule, leaf: hit?.leaf };
  const mine = picked;
  get('chain').hidden = true;
  const triangles = hit?.triangles ?? (rule === null ? null : await engine.query('ruleTriangles', rule).catch(() => null));
  if (mine !== picked) return;
  view.highlight(triangles);
  if (!current) return;
  const { facts } = current;
  const found = facts.rules.find(({ name }) => name === rule);
  editor.mark(found?.lines ?? [], reveals && Boolean(found));
  if (reveals && found) showLine();
  const lines = found?.lines.length ? `: line${found.lines.length === 1 ? '' : 's'} ${found.lines.join(', ')}` : '';
  get('picked').textContent = found
    ? `${hit ? 'One leaf' : `All ${short(found.leaves)} leaves`} of ${found.name}${lines}`
    : 'Click a part to find its rule.';
  showReports(get('reports'), facts, rule, (name) => choose(name === picked?.rule ? null : name));
}

const isNarrow = () => matchMedia('(max-width: 1000px)').matches;

/** On a narrow page, the marked line comes into sight below the view. */
function showLine() {
  if (!isNarrow() || get('rules').hidden) return;
  requestAnimationFrame(() => {
    const line = document.querySelector('.cm-line.marked');
    if (!line) return;
    const below = get('stage').getBoundingClientRect().height;
    window.scrollBy({ top: line.getBoundingClientRect().top - below - 60 });
  });
}

function setSeed(seed) {
  state.seed = seed;
  update();
}

function onLot(file, lot) {
  lotFile = { name: file.name, lot };
  lots.file = lotFile;
  Object.assign(state, { lot: 'file', seed: 0 });
  return update({ frames: true });
}

function onRules(file, text) {
  editor.value = text;
  const stem = file.name.replace(/\.cga$/i, '');
  const name = stem.charAt(0).toUpperCase() + stem.slice(1).replace(/[^A-Za-z0-9]/g, '');
  state.rules = text;
  state.name = isTypeName(name) ? name : null;
  showName();
  return update({ frames: true });
}

function onAsset(name, bytes) {
  engine.addFile(name, bytes);
  announce(`Rules can use ${name} now.`);
  return update();
}

async function download() {
  if (!current) return;
  const { facts } = current;
  const stem = `${state.grammar}-${shown.seed}`;
  try {
    const names = await FILES[get('format').value]({ stem, engine, name: get('rust-name').value, text: editor.value, report: facts.report });
    announce(`Saved ${names.join(' and ')}.`);
  } catch (error) {
    announce(error.message);
  }
}

/** Longer links are cut by some programs. In characters of the rules. */
const LONGEST = 8000;

/** Puts the state into the address. False if the rules are too long for it. */
function write() {
  const isWhole = (state.rules ?? '').length <= LONGEST;
  // A model of other rules may still be in the view.
  const camera = pending.frames || shown?.grammar !== state.grammar ? pending.camera : view.cameraNumbers;
  const link = encode({ ...state, camera, rules: isWhole ? state.rules : null });
  history.replaceState(isWhole ? null : { rules: state.rules }, '', link);
  return isWhole;
}

/** Browsers limit changes of the address, and a drag makes many. */
let timer = 0;
function later() {
  if (!state.grammar) return;
  clearTimeout(timer);
  timer = setTimeout(write, 250);
}

function fail(text) {
  get('error').textContent = text;
  get('error').hidden = !text;
}
