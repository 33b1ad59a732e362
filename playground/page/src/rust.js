// Rule texts as Rust.

/** The text as a `cga!` macro with a raw string that ends only where it should. */
export function asRust(name, text) {
  const rules = text.replace(/\r\n?/g, '\n').replace(/\s+$/, '');
  const ends = [...rules.matchAll(/"(#*)/g)].map((found) => found[1].length + 1);
  const marks = '#'.repeat(Math.max(1, ...ends));
  const lines = rules.split('\n').map((line) => (line ? `        ${line}` : line));
  return `cga! {\n    pub grammar ${name} = r${marks}"\n${lines.join('\n')}\n    "${marks};\n}\n`;
}

/** True for a name of a Rust type, written as Rust writes them. */
export function isTypeName(name) {
  return /^[A-Z][A-Za-z0-9]*$/.test(name) && name !== 'Self';
}
