// Runs a program that was compiled to wasm: `node .ci/wasm.mjs program.wasm`.
import { readFile } from "node:fs/promises";
import { argv, exit } from "node:process";
import { WASI } from "node:wasi";

const wasi = new WASI({ version: "preview1", args: argv.slice(2) });
const imports = wasi.getImportObject();
// Functions of `node:wasi` that wasm calls directly crash some versions of Node when the memory has grown (nodejs/node#51303).
for (const functions of Object.values(imports)) {
    for (const [name, call] of Object.entries(functions)) {
        functions[name] = (...values) => call(...values);
    }
}
const program = await WebAssembly.compile(await readFile(argv[2]));
exit(wasi.start(await WebAssembly.instantiate(program, imports)));
