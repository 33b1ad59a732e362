//! The compiler's messages for mistakes: one case for each kind, in `ui/`. `TRYBUILD=overwrite` accepts new wording.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The wording of rustc around ours belongs to one version. `cga-macros/src/tests/ui.rs` asks for our first lines in all of
/// them.
const RUSTC: &str = "rustc 1.95.";

#[test]
fn mistakes_are_explained_at_the_guilty_token() {
    let compiler = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let version = Command::new(compiler).arg("--version").output().expect("a compiler");
    let version = String::from_utf8_lossy(&version.stdout).into_owned();
    if !version.starts_with(RUSTC) {
        println!("left out: the expected messages come from {RUSTC}*, not from {version}");
        return;
    }
    rule_files();
    trybuild::TestCases::new().compile_fail("ui/*/*.rs");
}

/// Rule files are found from the package's folder, and the cases are compiled in a package of their own.
fn rule_files() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("the target folder");
    let folder = target.join("tests/trybuild").join(env!("CARGO_PKG_NAME")).join("ui/door");
    fs::create_dir_all(&folder).expect("a writable target folder");
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("ui/door");
    for entry in fs::read_dir(own).expect("the cases") {
        let path = entry.expect("the cases").path();
        if path.extension().is_some_and(|extension| extension == "cga") {
            fs::copy(&path, folder.join(path.file_name().expect("a name"))).expect("a writable target folder");
        }
    }
}
