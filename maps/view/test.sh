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
city() { "$command" "$folder/town.fgb" --lod Block --tile-lots 64 --quiet "$@"; }
show() { CHROMIUM=$(command -v chromium) node test.mjs "$command" "$@"; }
city --rules ../cga-city/rules/town.cga --out "$folder/tiles"
show "$folder/tiles"
# The same with images that tiles share, and far tiles without normals.
sed 's/ extrude(height) comp(f) { side : Wall/ extrude(height) comp(f) { side : setupProjection(0, scope.xy, 2, 2) texture("bricks.png") projectUV(0) Wall/' \
    ../cga-city/rules/town.cga >"$folder/bricks.cga"
grep -q bricks.png "$folder/bricks.cga"
city --rules "$folder/bricks.cga" --assets ../../docs/guide/assets --plain-far --out "$folder/bricks"
show "$folder/bricks" 1
# Houses that are one mesh at many places.
mkdir "$folder/meshes"
printf '%s\n' 'v 0 0 0' 'v 1 0 0' 'v 1 0 1' 'v 0 0 1' 'v 0 1 0' 'v 1 1 0' 'v 1 1 1' 'v 0 1 1' \
    'f 1 2 3 4' 'f 5 8 7 6' 'f 1 5 6 2' 'f 2 6 7 3' 'f 3 7 8 4' 'f 4 8 5 1' >"$folder/meshes/house.obj"
printf '%s\n' 'attr height = 9' '@StartRule Lot --> extrude(height) i("house.obj")' '@StartRule Block --> extrude(height)' >"$folder/meshes.cga"
city --rules "$folder/meshes.cga" --assets "$folder/meshes" --out "$folder/inserted"
show "$folder/inserted"
