// The parts of a model and the values that rules reported, as tables.

import { element } from './controls.js';

/** A number for people. */
export function short(number) {
  if (number === null || number === undefined) return '–';
  return number.toLocaleString('en', { maximumFractionDigits: Math.abs(number) < 100 ? 2 : 0 });
}

function table(caption, heads, rows) {
  const head = element('tr', {}, ...heads.map((text) => element('th', { scope: 'col' }, text)));
  const body = rows.map((cells) => element('tr', {}, ...cells.map((cell) => element('td', {}, cell))));
  return element('table', {}, element('caption', {}, caption), element('thead', {}, head), element('tbody', {}, ...body));
}

/** Fills the panel. `onChoose(rule)` gets the rule that a person chooses. */
export function showReports(panel, facts, chosen, onChoose) {
  const focused = panel.contains(document.activeElement) ? document.activeElement.textContent : null;
  const parts = [...facts.rules].sort((a, b) => b.leaves - a.leaves).map(({ name, leaves }) => {
    const button = element('button', { type: 'button', 'aria-pressed': String(name === chosen) }, name);
    button.addEventListener('click', () => onChoose(name));
    return [button, short(leaves)];
  });
  const numbers = facts.report.reports.filter(({ summary }) => summary.numbers);
  const texts = facts.report.reports.filter(({ texts }) => texts && Object.keys(texts).length);
  const made = [];
  if (numbers.length) {
    made.push(table('Reports', ['Name', 'Count', 'Sum', 'Least', 'Most', 'Mean'], numbers.map(({ key, summary }) => [
      key, short(summary.count), short(summary.sum), short(summary.min), short(summary.max), short(summary.average),
    ])));
  }
  for (const { key, texts: counts } of texts) {
    made.push(table(`Report “${key}”`, ['Text', 'Count'], Object.entries(counts).map(([text, count]) => [text, short(count)])));
  }
  if (!made.length) made.push(element('p', { className: 'quiet' }, 'The rules report nothing.'));
  if (facts.report.prints.length) {
    made.push(table('Printed', ['Rule', 'Value'], facts.report.prints.slice(0, 50).map(({ rule, value }) => [rule, String(value)])));
  }
  if (facts.faults.length) made.push(table('Faults', ['Fault'], facts.faults.slice(0, 50).map((fault) => [fault])));
  made.push(table('Parts', ['Rule', 'Leaves'], parts));
  panel.replaceChildren(...made);
  if (focused !== null) [...panel.querySelectorAll('button')].find((button) => button.textContent === focused)?.focus();
}
