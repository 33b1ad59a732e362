#!/usr/bin/env bash
# Shows a city in a headless browser: flies from far to near, expects no missing tile, and clicks a building. It needs Node.js and Chromium.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
command -v chromium >/dev/null || { echo "maps/view: chromium is missing. Install the package chromium." >&2 && exit 1; }
./build.sh
cargo build --release --workspace --manifest-path ../Cargo.toml
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
command=$PWD/../target/release/cga-city
"$command" outlines "$folder/town.fgb" --rows 6000
"$command" "$folder/town.fgb" --rules ../cga-city/rules/town.cga --out "$folder/tiles" --lod Block --tile-lots 64 --quiet
CHROMIUM=$(command -v chromium) node test.mjs "$command" "$folder/tiles"
