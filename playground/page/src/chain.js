// The chain of rules from the lot to a leaf, as a list with scopes.

import { element } from './controls.js';
import { short } from './reports.js';

const metres = (numbers) => numbers.map((number) => short(Math.abs(number) < 5e-4 ? 0 : number)).join(' × ');
const value = (it) => (typeof it === 'number' ? short(it) : typeof it === 'string' ? it : JSON.stringify(it));

/** Fills the list. `onStep(step)` gets the step that a person chooses. */
export function showChain(list, { steps, attributes, lot }, onStep) {
  const rows = steps.map((step, at) => {
    const { rule, lines, size, origin, number, siblings, isLeaf, arguments: given = [] } = step;
    const call = given.length ? `${rule}(${given.map(value).join(', ')})` : rule;
    const button = element('button', { type: 'button', 'aria-label': `Show the rule ${rule}` }, `${call}${isLeaf ? '.' : ''}`);
    button.addEventListener('click', () => onStep(step));
    const place = at === 0 ? `lot ${lot + 1}` : siblings === 1 ? 'the only part' : `part ${number + 1} of ${siblings}`;
    const where = lines.length ? `, line ${lines[0]}` : '';
    return element('li', {}, button, element('span', { className: 'hint' }, ` ${place}${where}`),
      element('div', { className: 'hint' }, `${metres(size)} m at ${origin.map((number) => short(Math.abs(number) < 5e-4 ? 0 : number)).join(', ')}`));
  });
  const used = Object.entries(attributes).map(([name, it]) => `${name} = ${value(it)}`).join(', ');
  if (used) rows[0]?.append(element('div', { className: 'hint' }, used));
  list.replaceChildren(...rows);
}
