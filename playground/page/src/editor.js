// The checker: a text with underlined findings. Its wasm module is loaded when the tab is opened first.

import { copy as copyText } from './clipboard.js';
import { element } from './controls.js';
import { asRust, isTypeName, withoutHead } from './rust.js';

/** The limits on listed and on underlined findings, because each takes the browser time. */
const LISTED = 200;
const UNDERLINED = 1000;

/** Milliseconds. A text that takes longer is checked after a pause of the same length. */
const QUICK = 30;

const EXAMPLE = `# A house: misspell a rule to see a finding.
@Range(min = 3, max = 30)
attr height = 9

Lot    --> extrude(height) comp(f) { side : Facade | top : Roof }
Facade --> split(y) { { ~3 : Floor }* }
Floor  --> split(x) { { ~1 : Wall. | 1.2 : Window | ~1 : Wall. }* }
Window --> t(0, 0, -0.2) color("#5d7f92") Glass.
Roof   --> color("#8c4a3a") roofHip(30, 0.5) Roof.
`;

export class Editor {
  constructor({ text, marks, findings, title, name, copy, announce, onType }) {
    Object.assign(this, { text, marks, findings, title, name });
    text.value = EXAMPLE;
    text.addEventListener('input', () => {
      this.typed();
      onType();
    });
    text.addEventListener('scroll', () => this.follow());
    new ResizeObserver(() => this.follow()).observe(text);
    copy.addEventListener('click', async () => {
      if (!isTypeName(name.value)) {
        name.reportValidity();
        announce('The name of a grammar is a name of a Rust type, such as House.');
        return;
      }
      await copyText(asRust(name.value, text.value)).then(() => announce('Copied as Rust.'), (error) => announce(error.message));
    });
  }

  /** Loads the checker. */
  async open() {
    this.loading ??= this.start().catch((error) => {
      this.loading = null;
      this.title.textContent = 'The checker is not loaded';
      throw error;
    });
    await this.loading;
    this.update();
  }

  async start() {
    this.title.textContent = 'Loading the checker …';
    const checker = await import('../../pkg/checker.js');
    await checker.default({ module_or_path: new URL('checker_bg.wasm', document.baseURI) });
    this.check = checker.check;
  }

  /** Another text: `value` null is the example. */
  set value(value) {
    this.text.value = value ?? EXAMPLE;
    this.update();
  }

  /** The text, or null for the example. */
  get value() {
    return this.text.value === EXAMPLE ? null : this.text.value;
  }

  typed() {
    clearTimeout(this.timer);
    if (!(this.took > QUICK)) return this.update();
    // The old marks would stand beside other words.
    this.underline([]);
    this.title.textContent = 'Checking …';
    this.timer = setTimeout(() => this.update(), this.took);
  }

  update() {
    if (!this.check) return;
    let list;
    try {
      const start = performance.now();
      list = JSON.parse(this.check(withoutHead(this.text.value)));
      this.took = performance.now() - start;
    } catch (error) {
      // The module cannot be used after it stopped.
      this.check = null;
      this.title.textContent = 'The checker stopped at this text. Reload the page to use it again.';
      console.warn(error);
      return;
    }
    const errors = list.filter(({ level }) => level === 'error').length;
    const count = (number, word) => `${number} ${word}${number === 1 ? '' : 's'}`;
    this.title.textContent = list.length ? `${count(errors, 'error')}, ${count(list.length - errors, 'warning')}` : 'No findings';
    this.underline(list.slice(0, UNDERLINED));
    this.findings.replaceChildren(...list.slice(0, LISTED).map((finding) => this.item(finding)));
  }

  underline(list) {
    const { value } = this.text;
    const pieces = [];
    let end = 0;
    for (const { start, end: stop, level } of list) {
      if (start < end) continue;
      // The end of the text has no character to underline.
      const to = Math.max(stop, start + 1);
      pieces.push(value.slice(end, start), element('mark', { className: level }, value.slice(start, to) || ' '));
      end = to;
    }
    // A newline at the end of a `pre` has no height.
    this.marks.replaceChildren(...pieces, value.slice(end), '\n ');
    this.follow();
  }

  follow() {
    this.marks.scrollTop = this.text.scrollTop;
    this.marks.scrollLeft = this.text.scrollLeft;
  }

  item({ level, code, message, line, column, start, end, notes, help }) {
    const button = element('button', { type: 'button' }, `${line}:${column} `, element('span', { className: `level ${level}` }, level), ` ${message}`);
    button.title = code;
    button.addEventListener('click', () => {
      this.text.focus();
      this.text.setSelectionRange(start, end);
    });
    const hints = [...notes.map((text) => `note: ${text}`), ...help.map((text) => `help: ${text}`)];
    return element('li', {}, button, ...hints.map((text) => element('div', { className: 'hint' }, text)));
  }
}
