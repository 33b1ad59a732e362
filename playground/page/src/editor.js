// The editor of the rules: their text with colours, underlined findings and the marked rule.

import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { Compartment, EditorState, StateEffect, StateField } from '@codemirror/state';
import {
  Decoration, drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers, MatchDecorator, ViewPlugin,
} from '@codemirror/view';
import { element } from './controls.js';
import { nameOf } from './rust.js';

/** The limits on listed and on underlined findings, because each takes the browser time. */
const LISTED = 200;
const UNDERLINED = 1000;

const TOKENS = /(\/\/.*|\/\*.*?\*\/|#.*)|("(?:[^"\\\n]|\\.)*")|\b(attr|const|case|else|grammar|pub|version|import|style|extends|with|NIL)\b|(@\w+)|(\b\d[\d.]*)/g;
const CLASSES = ['comment', 'text', 'word', 'word', 'number'];
const COLOURS = CLASSES.map((name) => Decoration.mark({ class: name }));

/** Colours of the lines in view. */
const colours = (() => {
  const finder = new MatchDecorator({ regexp: TOKENS, decoration: (found) => COLOURS[found.slice(1).findIndex((group) => group !== undefined)] });
  return ViewPlugin.define((view) => ({
    decorations: finder.createDeco(view),
    update(update) { this.decorations = finder.updateDeco(update, this.decorations); },
  }), { decorations: (plugin) => plugin.decorations });
})();

/** Decorations that an effect sets and that move with the text. */
function decorations() {
  const set = StateEffect.define();
  const field = StateField.define({
    create: () => Decoration.none,
    update(list, transaction) {
      const effect = transaction.effects.find((effect) => effect.is(set));
      return effect ? effect.value : list.map(transaction.changes);
    },
    provide: (field) => EditorView.decorations.from(field),
  });
  return { set, field };
}
const findings = decorations();
const marks = decorations();
const UNDERLINES = Object.fromEntries(['error', 'warning'].map((level) => [level, Decoration.mark({ class: `finding ${level}` })]));
const MARKED = Decoration.line({ class: 'marked' });

export class Editor {
  /** `onType()` is called when a person changes the text, `onLine(line)` when a person clicks into a line, counted from 1. */
  constructor({ parent, list, title, onType, onLine }) {
    Object.assign(this, { list, title, onType });
    this.isSet = new Compartment();
    this.view = new EditorView({ parent, state: this.state('') });
    this.view.contentDOM.setAttribute('aria-label', 'CGA rules');
    this.view.contentDOM.setAttribute('aria-describedby', title.id);
    this.view.contentDOM.addEventListener('click', () => {
      const { main } = this.view.state.selection;
      if (main.empty) onLine(this.view.state.doc.lineAt(main.head).number);
    });
  }

  state(doc) {
    return EditorState.create({
      doc,
      extensions: [
        lineNumbers(), history(), drawSelection(), highlightActiveLine(), EditorView.lineWrapping, colours, findings.field, marks.field,
        EditorState.tabSize.of(4), keymap.of([...defaultKeymap, ...historyKeymap, { key: 'Escape', run: ({ contentDOM }) => (contentDOM.blur(), true) }, indentWithTab]),
        EditorView.updateListener.of((update) => update.docChanged && this.onType()),
      ],
    });
  }

  /** Another text, which a person has not typed. */
  set value(text) {
    if (text !== this.value) this.view.setState(this.state(text));
    this.show([]);
  }

  get value() {
    return this.view.state.doc.toString();
  }

  /** The name of the grammar, if the text is a macro or has a head. */
  get name() {
    return nameOf(this.value);
  }

  /** Shows the findings of a text: they may be older than the text that is typed. */
  show(list) {
    const count = (level, word) => {
      const number = list.filter((finding) => finding.level === level).length;
      return `${number} ${word}${number === 1 ? '' : 's'}`;
    };
    const { length } = this.view.state.doc;
    const ranges = [];
    for (const { start, end, level } of list.slice(0, UNDERLINED)) {
      // The end of the text has no character to underline.
      const from = Math.min(start, length - 1);
      if (0 <= from) ranges.push(UNDERLINES[level].range(from, Math.max(from + 1, Math.min(end, length))));
    }
    this.view.dispatch({ effects: findings.set.of(Decoration.set(ranges, true)) });
    this.title.textContent = list.length ? `${count('error', 'error')}, ${count('warning', 'warning')}` : 'No findings';
    this.title.dataset.errors = String(list.some(({ level }) => level === 'error'));
    this.list.replaceChildren(...list.slice(0, LISTED).map((finding) => this.item(finding)));
  }

  item({ level, code, message, line, column, start, end, notes, help }) {
    const button = element('button', { type: 'button' }, `${line}:${column} `, element('span', { className: `level ${level}` }, level), ` ${message}`);
    button.title = code;
    button.addEventListener('click', () => {
      const { length } = this.view.state.doc;
      this.view.focus();
      this.view.dispatch({ selection: { anchor: Math.min(start, length), head: Math.min(end, length) }, scrollIntoView: true });
    });
    const hints = [...notes.map((text) => `note: ${text}`), ...help.map((text) => `help: ${text}`)];
    return element('li', {}, button, ...hints.map((text) => element('div', { className: 'hint' }, text)));
  }

  /** Marks lines, counted from 1. Shows the first, if `reveals`. */
  mark(lines, reveals) {
    const { doc } = this.view.state;
    const starts = lines.filter((line) => 1 <= line && line <= doc.lines).map((line) => doc.line(line).from);
    const effects = [marks.set.of(Decoration.set(starts.map((start) => MARKED.range(start)), true))];
    if (reveals && starts.length) effects.push(EditorView.scrollIntoView(starts[0], { y: 'center' }));
    this.view.dispatch({ effects });
  }
}
