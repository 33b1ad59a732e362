// Controls for the attributes of a grammar.

const UNITS = { angle: '°', distance: 'm', percent: '%' };
let numbered = 0;

/** Makes an element with properties and children. */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.includes('-') || name === 'role' || name === 'for') made.setAttribute(name, value);
    else made[name] = value;
  }
  made.append(...children);
  return made;
}

/**
 * Fills `panel` with a control for each attribute. `change(name, value)` gets a new value; null is the default.
 * `refuse(sentence)` gets the reason why a value is not taken; the control shows its old value again.
 */
export class Controls {
  constructor(panel, change, refuse) {
    this.panel = panel;
    this.change = change;
    this.refuse = refuse;
    this.rows = new Map();
  }

  /** Shows the values of a run, with other controls if its attributes are others, or if they must be `rebuilt`. */
  update(attributes, used, rebuilt) {
    const kinds = JSON.stringify(attributes.map(({ value, allowed, ...kind }) => kind));
    if (rebuilt || kinds !== this.kinds) this.build(attributes);
    this.kinds = kinds;
    this.show(attributes, used);
  }

  /** Makes the controls of a grammar. */
  build(attributes) {
    this.rows.clear();
    this.panel.replaceChildren();
    const shown = attributes.filter((attribute) => !attribute.hidden);
    if (!shown.length) this.panel.append(element('p', { className: 'quiet' }, 'This grammar has no attributes.'));
    this.group(this.panel, shown, 0);
  }

  /** The attributes of a group by order, then the groups in it. */
  group(parent, attributes, depth) {
    const byNumber = (number) => (a, b) => (number(a) ?? Infinity) - (number(b) ?? Infinity) || 0;
    const own = attributes.filter((attribute) => attribute.group.length === depth);
    for (const attribute of own.sort(byNumber((attribute) => attribute.order))) parent.append(this.row(attribute));
    const groups = new Map();
    for (const attribute of attributes.filter((attribute) => attribute.group.length > depth)) {
      const name = attribute.group[depth];
      groups.set(name, [...(groups.get(name) ?? []), attribute]);
    }
    const order = ([, list]) => list.find((attribute) => attribute.group.length === depth + 1 && attribute.group_order !== null)?.group_order;
    for (const [name, list] of [...groups].sort(byNumber(order))) {
      const set = element('fieldset', {}, element('legend', {}, name));
      this.group(set, list, depth + 1);
      parent.append(set);
    }
  }

  row(attribute) {
    const id = `attribute-${numbered++}`;
    const name = attribute.display_name || attribute.name;
    const control = makeControl(attribute, id, (value) => this.change(attribute.name, value), (reason) => this.refuse(`${name}: ${reason}`));
    const label = element('label', { for: id }, name);
    const undo = element('button', { type: 'button', className: 'undo', title: 'Back to the default' }, '↺');
    undo.setAttribute('aria-label', `Reset ${name}`);
    undo.addEventListener('click', () => this.change(attribute.name, null));
    const value = element('span', { className: 'value' }, ...control.parts, undo);
    const note = element('span', { className: 'note', id: `${id}-note` });
    const row = element('div', { className: 'attribute' }, label, value);
    row.dataset.name = attribute.name;
    if (control.wide) row.append(control.wide);
    row.append(note);
    if (attribute.about) {
      row.title = attribute.about;
      const about = element('span', { className: 'hidden', id: `${id}-about` }, attribute.about);
      row.append(about);
    }
    const described = [attribute.about ? `${id}-about` : '', note.id].filter(Boolean).join(' ');
    for (const input of [...control.parts, control.wide].filter((part) => part?.matches?.('input, select'))) {
      input.setAttribute('aria-describedby', described);
    }
    this.rows.set(attribute.name, { control, undo, note, attribute });
    return row;
  }

  /** Shows the values of a run. `used` has the values that its shapes used, for defaults that are computed. */
  show(attributes, used) {
    for (const attribute of attributes) {
      const row = this.rows.get(attribute.name);
      if (!row) continue;
      const isComputed = attribute.value === null;
      const values = used[attribute.name] ?? [];
      const value = isComputed ? values[0] ?? null : attribute.value;
      row.control.show(value, attribute.allowed);
      row.note.textContent = isComputed ? computed(values) : '';
      row.note.hidden = !isComputed;
      // A computed default is null.
      const isDefault = JSON.stringify(attribute.value) === JSON.stringify(attribute.default);
      // A hidden button loses the focus, and keys would start again at the top of the page.
      if (isDefault && document.activeElement === row.undo) row.control.parts[0].focus();
      row.undo.hidden = isDefault;
    }
  }
}

/** The sentence for a default that rules compute. */
function computed(values) {
  const numbers = values.filter((value) => typeof value === 'number');
  const short = (number) => String(Number(number.toFixed(2)));
  if (values.length < 2) return 'computed by the rules';
  if (numbers.length === values.length) {
    return `computed by the rules: ${short(Math.min(...numbers))} to ${short(Math.max(...numbers))}`;
  }
  return `computed by the rules: ${values.length} different values`;
}

/** The control of an attribute: its parts, a wide part below them, and a function that shows a value. */
function makeControl(attribute, id, change, refuse) {
  if (attribute.choices && !attribute.type.endsWith('[]')) return makeMenu(attribute, id, change);
  switch (attribute.type) {
    case 'bool':
      return makeCheckbox(id, change);
    case 'float':
      return makeNumber(attribute, id, change, refuse);
    case 'string':
      return isColor(attribute) ? makeColor(id, change) : makeText(id, change, refuse, (text) => text, (value) => value ?? '');
    default:
      return makeText(id, change, refuse, JSON.parse, (value) => (value === null ? '' : JSON.stringify(value)));
  }
}

/** True for `@Color`, and for a default such as "#d9cdb8". */
function isColor(attribute) {
  return attribute.kind === 'color' || /^#[0-9a-f]{6}$/i.test(attribute.default ?? '');
}

function makeMenu(attribute, id, change) {
  const select = element('select', { id });
  let values = [];
  select.addEventListener('change', () => change(values[select.selectedIndex]));
  const { labels } = attribute.choices;
  return {
    parts: [select],
    show(value, allowed) {
      values = [...(allowed ?? [])];
      const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);
      // A default need not be among the choices.
      if (!values.some((one) => same(one, value))) values.unshift(value);
      const texts = values.map((one) => labels[(allowed ?? []).findIndex((other) => same(one, other))] ?? String(one));
      if ([...select.options].map((option) => option.text).join('\n') !== texts.join('\n')) {
        select.replaceChildren(...texts.map((text) => element('option', {}, text)));
      }
      select.selectedIndex = values.findIndex((one) => same(one, value));
    },
  };
}

function makeCheckbox(id, change) {
  const input = element('input', { id, type: 'checkbox' });
  input.addEventListener('change', () => change(input.checked));
  return { parts: [input], show: (value) => (input.checked = value === true) };
}

function makeColor(id, change) {
  const input = element('input', { id, type: 'color' });
  input.addEventListener('input', () => change(input.value));
  // Colours of CGA may have an opacity, which the control cannot show.
  return { parts: [input], show: (value) => (input.value = /^#[0-9a-f]{6}/i.exec(value ?? '')?.[0].toLowerCase() ?? '#ffffff') };
}

function makeText(id, change, refuse, read, write) {
  const input = element('input', { id, type: 'text', autocomplete: 'off', spellcheck: false });
  let before = '';
  input.addEventListener('change', () => {
    let value;
    try {
      value = read(input.value);
    } catch {
      input.value = before;
      refuse('write an array as in [1, 2, 3].');
      return;
    }
    change(value);
  });
  return { parts: [input], show: (value) => (input.value = before = write(value)) };
}

function makeNumber(attribute, id, change, refuse) {
  const isPercent = attribute.kind === 'percent';
  const scale = isPercent ? 100 : 1;
  const number = element('input', { id, type: 'number', step: 'any' });
  const unit = element('span', { className: 'unit' }, UNITS[attribute.kind] ?? '');
  const { range } = attribute;
  const isClosed = range && Number.isFinite(range.min) && Number.isFinite(range.max);
  let before = '';
  const send = (input) => change(Number((Number(input.value) / scale).toPrecision(12)));
  number.addEventListener('change', () => {
    if (number.value !== '' && number.validity.valid) return send(number);
    const { badInput, rangeUnderflow, rangeOverflow } = number.validity;
    const isOutside = !badInput && (rangeUnderflow || rangeOverflow);
    number.value = before;
    refuse(isOutside ? `takes ${number.min} to ${number.max}.` : 'write a number.');
  });
  if (!isClosed) return { parts: [number, unit], show: (value) => (number.value = before = shown(value)) };

  const slider = element('input', { type: 'range' });
  slider.setAttribute('aria-label', `${attribute.display_name || attribute.name}, slider`);
  const step = (range.step || niceStep(range.max - range.min)) * scale;
  for (const input of range.restricted ? [number, slider] : [slider]) {
    input.min = tidy(range.min * scale);
    input.max = tidy(range.max * scale);
  }
  slider.step = tidy(step);
  slider.addEventListener('input', () => {
    number.value = slider.value;
    send(slider);
  });
  return {
    parts: [number, unit],
    wide: slider,
    show(value) {
      const text = before = shown(value);
      if (document.activeElement !== number) number.value = text;
      if (document.activeElement !== slider || Number(slider.value) !== Number(text)) slider.value = text;
    },
  };

  function shown(value) {
    return typeof value === 'number' ? tidy(value * scale) : '';
  }
}

/** A number without the digits that rounding leaves. */
function tidy(number) {
  return String(Number(number.toPrecision(6)));
}

/** About a hundred steps, each 1, 2 or 5 times a power of ten. */
function niceStep(length) {
  const power = 10 ** Math.floor(Math.log10(length / 100));
  const steps = [1, 2, 5, 10].map((factor) => factor * power);
  return steps.find((step) => length / step <= 150) ?? power;
}
