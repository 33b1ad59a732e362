// Named checks, counted. With arguments, only those whose names contain one of them.

const wanted = process.argv.slice(2);
let passed = 0;
let failed = 0;

/** Runs a check. It fails by throwing; what it returns is printed as a figure. */
export async function check(name, run) {
  if (wanted.length && !wanted.some((part) => name.includes(part))) return;
  try {
    const figure = await run();
    passed++;
    console.log(`ok    ${name}${figure === undefined ? '' : `: ${figure}`}`);
  } catch (error) {
    failed++;
    console.log(`FAIL  ${name}: ${error.message}`);
  }
}

/** Throws unless a condition holds. */
export function ensure(condition, message) {
  if (!condition) throw new Error(message);
}

export function equal(actual, expected, what = 'value') {
  const [a, e] = [JSON.stringify(actual), JSON.stringify(expected)];
  ensure(a === e, `${what}: ${a}, expected ${e}`);
}

/** Prints the totals and ends the program. */
export function finish() {
  console.log(`${passed} passed, ${failed} failed`);
  process.exit(failed ? 1 : 0);
}
