// The worker: the engine as a wasm module, away from the thread that draws the page.
//
// Messages `{ id, call, args }` are answered in order with `{ id, value }`, `{ id, error }`, or `{ id, stopped }` if the module cannot be used
// any more.

import { catalog, initSync, PageEngine } from '../../pkg/engine.js';

let engine = null;

const calls = {
  /** The module, and files that rules can name. */
  start(module, files) {
    initSync({ module });
    engine = new PageEngine();
    for (const [name, bytes] of files) engine.addFile(name, bytes);
  },
  catalog: () => JSON.parse(catalog()),
  addFile: (name, bytes) => engine.addFile(name, bytes),
  run(request) {
    const begin = performance.now();
    const answer = JSON.parse(engine.run(JSON.stringify(request)));
    answer.glb = answer.facts ? engine.viewGlb() : null;
    answer.took = performance.now() - begin;
    return answer;
  },
  /** The leaf that a ray hits, its rule and its triangles, or null. */
  pick(origin, direction) {
    const leaf = engine.pick(Float64Array.from(origin), Float64Array.from(direction));
    return leaf === undefined ? null : { leaf, rule: engine.rule(leaf), triangles: engine.trianglesOfLeaf(leaf) };
  },
  ruleTriangles: (rule) => engine.trianglesOfRule(rule),
  chain: (leaf) => JSON.parse(engine.chain(leaf)),
  glb: () => engine.glb(),
  glbByRule: () => engine.glbByRule(),
  obj: (library) => engine.obj(library),
};

self.onmessage = ({ data: { id, call, args } }) => {
  try {
    const value = calls[call](...args);
    self.postMessage({ id, value }, [value?.glb?.buffer, value?.triangles?.buffer].filter(Boolean));
  } catch (error) {
    const isStopped = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
    self.postMessage(isStopped ? { id, stopped: String(error) } : { id, error: error.message });
  }
};
