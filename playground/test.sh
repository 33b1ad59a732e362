#!/usr/bin/env bash
# Builds the playground and tests it in a headless browser. The last line has the numbers of passed and failed checks.
# With arguments, only the checks whose names contain one of them run: test.sh slider "a link".
set -euo pipefail
source "$(dirname "$0")/tools.sh"
need_package chromium chromium
need_package brotli brotli
./build.sh
# The files that the page must equal come from the same code, compiled for this machine. Results do not depend on optimization.
cargo build -p cga-playground --bin glb
cargo test --workspace --quiet
rm -rf out
mkdir out
CHROMIUM=$(command -v chromium) exec node test/page.mjs "$@"
