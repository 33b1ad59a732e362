// The grammars: a wasm module that turns requests into GLB files and facts.

import init, { catalog, PageRun } from '../../pkg/grammars.js';

/** Loads the module and returns the list of grammars. */
export async function load() {
  await init({ module_or_path: new URL('grammars_bg.wasm', document.baseURI) });
  return JSON.parse(catalog());
}

/**
 * Runs a grammar: `{ grammar, values, seed }`. Throws an error with a sentence for people. A run must be freed.
 */
export function run(request) {
  const made = new PageRun(JSON.stringify(request));
  return {
    glb: made.takeGlb(),
    facts: JSON.parse(made.facts()),
    /** The leaf that a ray hits and its rule, or null. */
    pick(origin, direction) {
      const leaf = made.pick(Float64Array.from(origin), Float64Array.from(direction));
      return leaf === undefined ? null : { leaf, rule: made.rule(leaf) };
    },
    leafTriangles: (leaf) => made.trianglesOfLeaf(leaf),
    ruleTriangles: (rule) => made.trianglesOfRule(rule),
    free: () => made.free(),
  };
}
