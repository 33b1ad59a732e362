// Rule texts as Rust.

/** Comments, then the annotations and the head of a grammar in Rust, which a rule file does not have. */
const HEAD = /^((?:\s|\/\/.*)*)((?:@\w+(?:\([^)]*\))?\s*)*(?:pub(?:\([^)]*\))?\s+)?grammar\s+(\w+)\s*;)/;

/** The text with blanks in place of the head of a grammar, so that places stay. */
export function withoutHead(text) {
  return text.replace(HEAD, (_, comments, head) => comments + head.replace(/[^\n]/g, ' '));
}

/** The text as a `cga!` macro with a raw string that ends only where it should. */
export function asRust(name, text) {
  const rules = withoutHead(text).replace(/\r\n?/g, '\n').replace(/\s+$/, '');
  const ends = [...rules.matchAll(/"(#*)/g)].map((found) => found[1].length + 1);
  const marks = '#'.repeat(Math.max(1, ...ends));
  // Without more indentation: texts in quotes may have several lines.
  return `cga! {\n    pub grammar ${name} = r${marks}"\n${rules}\n    "${marks};\n}\n`;
}

/** True for a name of a Rust type, written as Rust writes them. */
export function isTypeName(name) {
  return /^[A-Z][A-Za-z0-9]*$/.test(name) && name !== 'Self';
}
