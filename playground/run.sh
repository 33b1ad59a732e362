#!/usr/bin/env bash
# Builds the page and serves it on this computer: run.sh [PORT]
set -euo pipefail
cd "$(dirname "$0")"
./build.sh
exec node serve.mjs "${1:-8080}"
