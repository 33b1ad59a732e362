// The rule text with marked lines.

import { element } from './controls.js';

const TOKENS = /(\/\/.*|\/\*[\s\S]*?\*\/)|("(?:[^"\\\n]|\\.)*")|\b(attr|const|case|else|grammar|pub|version|import|style|extends|with|NIL)\b|(\b\d[\d.]*)/g;
const CLASSES = ['comment', 'text', 'word', 'number'];

export class RuleText {
  /** `onChoose(line)` gets the line of a rule that a person clicks. */
  constructor(panel, onChoose) {
    this.panel = panel;
    this.onChoose = onChoose;
    this.lines = [];
  }

  build(text) {
    this.lines = text.split('\n').map(() => element('li'));
    let line = 0;
    const put = (piece, className) => {
      piece.split('\n').forEach((part, at) => {
        if (at) line++;
        if (part) this.lines[line].append(className ? element('span', { className }, part) : part);
      });
    };
    let end = 0;
    for (const found of text.matchAll(TOKENS)) {
      put(text.slice(end, found.index));
      put(found[0], CLASSES[found.slice(1).findIndex((group) => group !== undefined)]);
      end = found.index + found[0].length;
    }
    put(text.slice(end));
    this.panel.replaceChildren(element('ol', { className: 'code' }, ...this.lines));
    this.panel.scrollTop = 0;
  }

  /** Offers the lines of rules that made leaves. */
  offer(rules) {
    const names = new Map();
    for (const { name, lines } of rules) for (const line of lines) names.set(line, [...(names.get(line) ?? []), name]);
    this.lines.forEach((item, at) => {
      const here = names.get(at + 1);
      if (here) item.dataset.rules = here.join(' ');
      else delete item.dataset.rules;
      item.onclick = here ? () => this.onChoose(here[0]) : null;
    });
  }

  /** Marks lines, counted from 1, and shows the first. */
  mark(lines) {
    this.lines.forEach((item, at) => {
      const isMarked = lines.includes(at + 1);
      item.classList.toggle('marked', isMarked);
      if (isMarked) item.setAttribute('aria-current', 'true');
      else item.removeAttribute('aria-current');
    });
    const first = this.lines[lines[0] - 1];
    if (first && this.panel.clientHeight) {
      this.panel.scrollTop = first.offsetTop - this.panel.offsetTop - this.panel.clientHeight / 3;
    }
  }
}
