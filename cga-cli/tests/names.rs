//! Names of files that are not text.
#![cfg(target_os = "linux")]

use std::ffi::{OsStr, OsString};
use std::os::unix::ffi::OsStrExt;
use std::path::Path;
use std::process::{Command, Output};

fn name(ending: &str) -> OsString {
    OsStr::from_bytes(&[b"a\xff", ending.as_bytes()].concat()).to_owned()
}

fn run(folder: &Path, args: &[&OsStr]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cga"));
    command.current_dir(folder).arg("run").args(args).output().expect("the command")
}

/// Names of assets are text, and so is the name of a mesh. Rules and outputs may have any names.
#[test]
fn only_meshes_have_names_that_are_text() {
    let folder = std::env::temp_dir().join(format!("cga-cli-names-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join(name(".cga")), "Lot --> extrude(3) X.").expect("the rules");
    std::fs::write(folder.join(name(".obj")), "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n").expect("a mesh");
    let good = run(&folder, &[&name(".cga"), OsStr::new("-o"), &name(".glb")]);
    let is_written = folder.join(name(".glb")).is_file();
    let refused = run(&folder, &[&name(".cga"), OsStr::new("--mesh"), &name(".obj")]);
    std::fs::remove_dir_all(&folder).expect("the folder");
    assert!(good.status.success() && is_written, "{good:?}");
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        refused.status.code() == Some(2) && said.contains("its name is not valid UTF-8; rename the file"),
        "{said}"
    );
}
