# Sourced by scripts that compare the lines of a program on this machine with its lines on wasm.
target=wasm32-wasip1
folder=${CARGO_TARGET_DIR:-target}

# Returns false, and reports what is missing, if programs cannot be compiled to wasm or run there.
has_wasm() {
    if ! [ -d "$(rustc --print target-libdir --target "$target")" ]; then
        echo "skipped: the target is missing (rustup target add $target)"
        return 1
    fi
    if ! node -e 'require("node:wasi")' 2>/dev/null; then
        echo "skipped: Node with node:wasi is missing"
        return 1
    fi
}

# same_on_wasm LINES PROGRAM: fails if the program, compiled to wasm without optimization, does not print the lines of the file.
same_on_wasm() {
    node --no-warnings .ci/wasm.mjs "$folder/$target/debug/$2.wasm" >"$folder/wasm.txt"
    diff "$1" "$folder/wasm.txt"
    echo "$(wc -l <"$1") lines of hashes are equal on wasm"
}
