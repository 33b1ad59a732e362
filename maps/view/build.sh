#!/usr/bin/env bash
# Builds the page of `cga-city view` in dist/. It needs Node.js 20 or newer, and installs three.js, 3d-tiles-renderer and esbuild in node_modules.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
for command in node npm; do
    command -v "$command" >/dev/null || { echo "maps/view: $command is missing. Install Node.js 20 or newer." >&2 && exit 1; }
done
if ! [ package-lock.json -ot node_modules/.package-lock.json ]; then
    npm ci --no-audit --no-fund --loglevel=error || { echo "maps/view: the packages could not be installed. Run npm ci." >&2 && exit 1; }
fi
rm -rf dist
mkdir dist
cp src/index.html dist/
npx esbuild src/main.js --bundle --format=esm --minify --target=es2022 --outdir=dist --log-level=warning
