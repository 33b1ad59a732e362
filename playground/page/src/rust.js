// Rule texts as Rust, and back. Places in the text stay, so that findings have the places of the text that a person sees.

/** Comments, then the annotations and the head of a grammar in Rust, which a rule file does not have. */
const HEAD = /^((?:\s|\/\/.*)*)((?:@\w+(?:\([^)]*\))?\s*)*(?:pub(?:\([^)]*\))?\s+)?grammar\s+(\w+)\s*;)/;

/** A macro whose rules are text in quotes, up to the text. */
const IN_QUOTES = /^(?:\s*use [^;]*;)*\s*cga!\s*\{\s*(?:pub(?:\([^)]*\))?\s+)?grammar\s+\w+\s*=\s*r(#*)"/;

/** A macro whose rules are in braces. */
const IN_BRACES = /^(?:\s*use [^;]*;)*\s*cga!\s*\{/;

/** The name in a head or a macro. */
const NAME = /\bgrammar\s+(\w+)\s*[;=]/;

const blank = (text) => text.replace(/[^\n]/g, ' ');

/** The rules of a text that may be a `cga!` macro or have the head of a grammar, with blanks in place of the rest. */
export function plainRules(text) {
  const quotes = IN_QUOTES.exec(text);
  if (quotes) {
    const [before, marks] = quotes;
    const end = text.indexOf(`"${marks}`, before.length);
    if (end < 0) return text;
    return blank(before) + text.slice(before.length, end) + blank(text.slice(end));
  }
  const braces = IN_BRACES.exec(text);
  if (!braces) return withoutHead(text);
  const end = text.lastIndexOf('}');
  const rules = text.slice(braces[0].length, end);
  // In Rust, relative sizes are written with `^`.
  return blank(braces[0]) + withoutHead(outsideTexts(rules, (piece) => piece.replaceAll('^', "'"))) + blank(text.slice(end));
}

/** The name of the grammar in a head or a macro, or null. */
export function nameOf(text) {
  return IN_BRACES.test(text) || HEAD.test(text) ? NAME.exec(text)?.[1] ?? null : null;
}

/** The text with blanks in place of the head of a grammar. */
export function withoutHead(text) {
  return text.replace(HEAD, (_, comments, head) => comments + blank(head));
}

/** Changes the pieces outside of texts in quotes and comments. */
function outsideTexts(text, change) {
  const kept = /"(?:[^"\\]|\\.)*"|\/\/.*/g;
  let made = '';
  let end = 0;
  for (const found of text.matchAll(kept)) {
    made += change(text.slice(end, found.index)) + found[0];
    end = found.index + found[0].length;
  }
  return made + change(text.slice(end));
}

/** The text as a `cga!` macro with a raw string that ends only where it should. */
export function asRust(name, text) {
  const rules = plainRules(text).replace(/\r\n?/g, '\n').replace(/\s+$/, '').replace(/^\s*\n/, '');
  const ends = [...rules.matchAll(/"(#*)/g)].map((found) => found[1].length + 1);
  const marks = '#'.repeat(Math.max(1, ...ends));
  // Without more indentation: texts in quotes may have several lines.
  return `cga! {\n    pub grammar ${name} = r${marks}"\n${rules}\n    "${marks};\n}\n`;
}

/** True for a name of a Rust type, written as Rust writes them. */
export function isTypeName(name) {
  return /^[A-Z][A-Za-z0-9]*$/.test(name) && name !== 'Self';
}
