#!/usr/bin/env bash
# Builds the page in dist/.
set -euo pipefail
source "$(dirname "$0")/tools.sh"
need_build_tools

target=wasm32-unknown-unknown
cargo build --release --lib --target "$target"
bind() {
    wasm-bindgen --target web --no-typescript --remove-name-section --remove-producers-section --out-dir pkg --out-name "$1" "$2"
}
folder=${CARGO_TARGET_DIR:-target}/$target
bind grammars "$folder/release/cga_playground.wasm"
bind checker "$folder/release/cga_playground_checker.wasm"

rm -rf dist
mkdir dist
cp page/index.html page/style.css pkg/*_bg.wasm dist/
npx esbuild page/src/main.js --bundle --splitting --format=esm --minify --target=es2022 --outdir=dist --log-level=warning
