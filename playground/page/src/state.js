// The state of the page in its address: grammar, changed rules, lot, attributes, seed, camera.
//
// `#grammar=tower&seed=9&.height=120&camera=…&rules=…`: attributes have a dot in front, so they cannot be taken for the rest.

/** Metres. A camera that is farther away has no accuracy left. */
const FARTHEST = 1e7;

/** Reads the part of an address after `#`. Values that cannot be read are left out. */
export function decode(hash) {
  const state = { grammar: null, seed: null, values: {}, camera: null, rules: null, lot: null, start: null, name: null };
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ''))) {
    if (name === 'seed') {
      const seed = Number(text);
      state.seed = /^\d+$/.test(text) && Number.isSafeInteger(seed) ? seed : null;
    } else if (name === 'camera') {
      const numbers = text.split(',').map(Number);
      state.camera = numbers.length === 6 && numbers.every((number) => Math.abs(number) <= FARTHEST) ? numbers : null;
    } else if (name.startsWith('.')) {
      try {
        state.values[name.slice(1)] = JSON.parse(text);
      } catch {
        // Not a value.
      }
    } else if (['grammar', 'rules', 'lot', 'start', 'name'].includes(name)) {
      state[name] = text;
    }
  }
  return state;
}

/** The part of an address after `#`, with the `#`. */
export function encode({ grammar, seed, values, camera, rules = null, lot = null, start = null, name = null }) {
  const list = new URLSearchParams({ grammar, seed });
  for (const [key, value] of Object.entries({ lot, start, name })) if (value) list.set(key, value);
  for (const [key, value] of Object.entries(values)) list.set(`.${key}`, JSON.stringify(value));
  if (camera) {
    list.set('camera', camera.map((number) => Number(number.toFixed(3))).join(','));
  }
  if (rules !== null) list.set('rules', rules);
  return `#${list}`;
}
