// Files that a person drops on the page or opens.

import { lotOfFile } from './lots.js';

/** `onLot(file, lot)`, `onRules(file, text)` and `onAsset(name, bytes)` get the contents of a file. */
export function takeFiles({ button, input }, { onLot, onRules, onAsset, announce }) {
  const take = async (files) => {
    for (const file of files) {
      const lot = await lotOfFile(file);
      if (lot) await onLot(file, lot);
      else if (/\.cga$/i.test(file.name)) await onRules(file, await file.text());
      else if (/\.(png|jpe?g)$/i.test(file.name)) await onAsset(file.name, new Uint8Array(await file.arrayBuffer()));
      else announce(`${file.name}: the page takes GeoJSON, OBJ, .cga, PNG and JPEG files.`);
    }
  };
  const isFile = (event) => event.dataTransfer?.types.includes('Files');
  const { body } = document;
  let depth = 0;
  window.addEventListener('dragenter', (event) => isFile(event) && (depth++, body.classList.add('dropping')));
  window.addEventListener('dragleave', (event) => isFile(event) && --depth <= 0 && body.classList.remove('dropping'));
  window.addEventListener('dragover', (event) => isFile(event) && event.preventDefault());
  // Before the editor, which would insert the text.
  window.addEventListener('drop', (event) => {
    if (!isFile(event)) return;
    event.preventDefault();
    event.stopPropagation();
    depth = 0;
    body.classList.remove('dropping');
    take([...event.dataTransfer.files]).catch((error) => announce(error.message));
  }, true);
  button.addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    take([...input.files]).catch((error) => announce(error.message));
    input.value = '';
  });
}
