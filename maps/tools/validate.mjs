// The Khronos validator on GLB files: node validate.mjs FILES. The last line has the numbers; the exit status is 1 with an error.
import { readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { validateBytes } from "gltf-validator";

let errors = 0;
let warnings = 0;
const files = process.argv.slice(2);
for (const file of files) {
    // Images are files beside the tiles.
    const externalResourceFunction = async (address) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(address))));
    const report = await validateBytes(new Uint8Array(readFileSync(file)), { uri: file, externalResourceFunction });
    errors += report.issues.numErrors;
    warnings += report.issues.numWarnings;
    for (const issue of report.issues.messages.filter((message) => message.severity < 2)) {
        console.log(`${file}: ${issue.code} ${issue.pointer ?? ""}: ${issue.message}`);
    }
}
console.log(`${files.length} files, ${errors} errors, ${warnings} warnings`);
process.exit(errors === 0 ? 0 : 1);
