//! The files of grammars: in the repository and in a throw-away crate.

use crate::write;
use std::fs;
use std::path::{Path, PathBuf};

/// The text of a module with grammars; their files are in a folder below the crate's.
fn list(seeds: &[u64], folder: &str) -> String {
    let mut text =
        String::from("//! The grammars that are played, each with its seed. They are written, not edited.\n\n");
    text += "use crate::play::Make;\nuse cga::cga;\n\n/// Each with the seed it is written with.\n";
    text += "pub(crate) const ALL: &[(u64, Make)] = &[\n";
    seeds.iter().for_each(|seed| text += &format!("    ({seed}, || Box::new(G{seed}::default())),\n"));
    text += "];\n\n";
    for seed in seeds {
        let levels = "@Warn(repeat_no_progress, endless_rules)";
        text += &format!("cga! {{ {levels} pub grammar G{seed} in \"{folder}/{seed}.cga\"; }}\n");
    }
    text
}

/// All files: the list at a path, and the grammars in a folder below the crate's.
pub(crate) fn all(seeds: &[u64], root: &Path, module: &str, folder: &str) -> Vec<(PathBuf, String)> {
    let rules = seeds.iter().map(|seed| (root.join(format!("{folder}/{seed}.cga")), write::write(*seed)));
    [(root.join(module), list(seeds, folder))].into_iter().chain(rules).collect()
}

/// Writes files, and nothing else into the folder of grammars.
pub(crate) fn put(files: &[(PathBuf, String)], folder: &Path) {
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder).expect("a folder for grammars");
    files.iter().for_each(|(path, text)| fs::write(path, text).expect("a file of grammars"));
}
