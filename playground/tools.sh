# Sourced by build.sh and test.sh: installs what they need and names what cannot be installed.
cd "$(dirname "${BASH_SOURCE[0]}")"
export PATH="$PWD/.tools/bin:$PATH"

missing() {
    echo "playground: $1 is missing and could not be installed. $2" >&2
    exit 1
}

# need_package COMMAND PACKAGE: a package of Debian or Ubuntu.
need_package() {
    command -v "$1" >/dev/null && return
    if command -v apt-get >/dev/null && [ "$(id -u)" = 0 ]; then
        echo "installing $2"
        { apt-get update -qq && apt-get install -y -qq --no-install-recommends "$2"; } >/dev/null || true
    fi
    command -v "$1" >/dev/null || missing "$1" "Install the package $2."
}

# The crate and the command must have the same version.
bindgen_version() {
    sed -n '/^name = "wasm-bindgen"$/{n;s/version = "\(.*\)"/\1/p}' Cargo.lock
}

need_build_tools() {
    command -v cargo >/dev/null || missing cargo "See rustup.rs."
    command -v node >/dev/null || missing node "Install Node.js 20 or newer."
    command -v npm >/dev/null || missing npm "Install npm."
    if ! [ -d "$(rustc --print target-libdir --target wasm32-unknown-unknown)" ]; then
        rustup target add wasm32-unknown-unknown || missing "the target wasm32-unknown-unknown" "Run rustup target add wasm32-unknown-unknown."
    fi
    local version
    version=$(bindgen_version)
    if [ "$(wasm-bindgen --version 2>/dev/null)" != "wasm-bindgen $version" ]; then
        echo "installing wasm-bindgen $version"
        cargo install wasm-bindgen-cli --version "$version" --no-default-features --root .tools || missing "wasm-bindgen $version" "Run cargo install wasm-bindgen-cli --version $version."
    fi
    if ! [ package-lock.json -ot node_modules/.package-lock.json ]; then
        npm ci --no-audit --no-fund --loglevel=error || missing "three, esbuild or puppeteer-core" "Run npm ci."
    fi
}
