// Files that a person saves.

/** Saves bytes or text as a file. */
export function save(name, content, type) {
  const url = URL.createObjectURL(new Blob([content], { type }));
  Object.assign(document.createElement('a'), { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** The files of the menu: each saves the model that is shown, and returns the names of its files. */
export const FILES = {
  async glb({ stem, engine }) {
    save(`${stem}.glb`, await engine.query('glb'), 'model/gltf-binary');
    return [`${stem}.glb`];
  },
  async rules({ stem, engine }) {
    save(`${stem}-rules.glb`, await engine.query('glbByRule'), 'model/gltf-binary');
    return [`${stem}-rules.glb`];
  },
  async obj({ stem, engine }) {
    const [obj, mtl] = await engine.query('obj', `${stem}.mtl`);
    save(`${stem}.obj`, obj, 'model/obj');
    save(`${stem}.mtl`, mtl, 'model/mtl');
    return [`${stem}.obj`, `${stem}.mtl`];
  },
  async cga({ name, text }) {
    save(`${name}.cga`, text, 'text/plain');
    return [`${name}.cga`];
  },
  async reports({ stem, report }) {
    save(`${stem}.json`, JSON.stringify(report, null, 1), 'application/json');
    return [`${stem}.json`];
  },
};
