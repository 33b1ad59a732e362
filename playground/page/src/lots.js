// The choice of a lot and of a start rule, and files that are dropped on the page.

const L_SHAPE = [[0, 24], [24, 24], [24, 10], [10, 10], [10, 0], [0, 0]];
const round = (count, radius) => Array.from({ length: count }, (_, at) => {
  const turn = (-2 * Math.PI * at) / count;
  return [radius * (1 + Math.cos(turn)), radius * (1 + Math.sin(turn))].map((number) => Number(number.toFixed(3)));
});

/** The lots of the menu, by the names that addresses have. A rectangle has its size after its name. */
const LOTS = { l: { outline: L_SHAPE }, round: { outline: round(40, 12) } };
const RECTANGLE = /^(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)$/;

/** The lot of a name as the engine takes it; null for the lots of the grammar. */
export function lotOf(name) {
  const size = RECTANGLE.exec(name ?? '');
  if (size) return { rectangle: [Number(size[1]), Number(size[2])] };
  return LOTS[name] ?? null;
}

/** True for a name that an address may have. */
export const isLotName = (name) => lotOf(name) !== null;

export class LotMenu {
  /** `elements` are `lot`, `sides`, `width`, `depth`, `start`. `change({ lot, start, file })` gets a choice. */
  constructor(elements, change) {
    Object.assign(this, elements, { change, file: null });
    this.lot.addEventListener('change', () => this.choose());
    for (const side of [this.width, this.depth]) side.addEventListener('change', () => side.validity.valid && this.choose());
    this.start.addEventListener('change', () => change({ start: this.start.value || null }));
  }

  choose() {
    const { value } = this.lot;
    this.change({ lot: value === 'rectangle' ? `${this.width.valueAsNumber}x${this.depth.valueAsNumber}` : value || null });
  }

  /** Shows a choice: the name of a lot, and a start rule of some. */
  show(lot, start, starts) {
    const size = RECTANGLE.exec(lot ?? '');
    if (size) [this.width.value, this.depth.value] = size.slice(1);
    this.sides.hidden = !size;
    const own = [...this.lot.options].find(({ value }) => value === 'file');
    own.hidden = own.disabled = !this.file;
    own.textContent = this.file ? this.file.name : 'File';
    this.lot.value = size ? 'rectangle' : lot ?? '';
    const marked = starts.filter((rule) => rule.marked);
    const shown = (marked.length ? marked : starts).map(({ name }) => name);
    if (start && !shown.includes(start)) shown.push(start);
    this.start.replaceChildren(new Option('As the lots say', ''), ...shown.map((name) => new Option(name, name)));
    this.start.value = start ?? '';
  }
}

/** The lot in a file as the engine takes it; null for a file of another kind. */
export async function lotOfFile(file) {
  const name = file.name.toLowerCase();
  if (/\.(geojson|json)$/.test(name)) return { geo_json: await file.text() };
  if (name.endsWith('.obj')) return { obj: await file.text() };
  return null;
}
