//! Writes the grammars of the seeds in `CGA_GRAMMARS`; without it, none.

use std::path::Path;
use std::{env, fs};

#[path = "../laws/files.rs"]
mod files;
#[path = "../../cga-lang/tests/front/common/random.rs"]
mod random;
#[path = "../laws/write/mod.rs"]
mod write;

/// The findings that random rules lead to: parts that nothing uses or reaches, sizes that leave no space, operations without
/// effect, no files of textures. `tests/laws/played` compares such claims with runs. Any other warning is a mistake of the
/// writer, of the checks or of the generated code.
const ALLOWED: [&str; 22] = [
    "case_always",
    "endless_rules",
    "flat_split",
    "float_without_space",
    "gap_left",
    "missing_asset",
    "missing_uv_set",
    "no_faces",
    "old_spelling",
    "repeat_no_progress",
    "repeat_once",
    "rule_not_reached",
    "selector_hidden",
    "shares_beyond_whole",
    "size_not_positive",
    "sizes_beyond_extent",
    "slot_always_cut",
    "slot_never_made",
    "split_without_uv",
    "unused_attribute",
    "unused_constant",
    "unused_parameter",
];

/// The first seed of a number of grammars.
const FIRST: u64 = 1000;

fn main() {
    println!("cargo::rerun-if-env-changed=CGA_GRAMMARS");
    let seeds = env::var("CGA_GRAMMARS").map_or(Vec::new(), |text| seeds(&text));
    // Messages quote the line of the header, which is therefore short.
    let levels = format!("\n@Allow({})\n", ALLOWED.join(", "));
    let text = files::list(&seeds, &levels, |seed| format!("= r###\"{}\"###", write::write(seed)));
    let folder = env::var_os("OUT_DIR").expect("a folder of the package");
    fs::write(Path::new(&folder).join("grammars.rs"), text).expect("the module of grammars");
}

/// The seeds that a text names: their number, the first and the end, or all of them.
fn seeds(text: &str) -> Vec<u64> {
    let number = |text: &str| {
        text.parse::<u64>()
            .unwrap_or_else(|_| panic!("`CGA_GRAMMARS` is `20`, `1000..1020` or `1000,1007`, not `{text}`"))
    };
    match (text.split_once(".."), text.contains(',')) {
        (Some((first, end)), _) => (number(first)..number(end)).collect(),
        (None, true) => text.split(',').map(number).collect(),
        (None, false) => (FIRST..FIRST + number(text)).collect(),
    }
}
