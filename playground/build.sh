#!/usr/bin/env bash
# Builds the page in dist/.
set -euo pipefail
source "$(dirname "$0")/tools.sh"
need_build_tools

target=wasm32-unknown-unknown
cargo build --release --lib --target "$target"
folder=${CARGO_TARGET_DIR:-target}/$target
wasm-bindgen --target web --no-typescript --remove-name-section --remove-producers-section --out-dir pkg --out-name engine "$folder/release/cga_playground.wasm"

rm -rf dist
mkdir dist
cp page/index.html page/style.css pkg/*_bg.wasm dist/
npx esbuild page/src/main.js page/src/worker.js --bundle --format=esm --minify --target=es2022 --outdir=dist --log-level=warning
