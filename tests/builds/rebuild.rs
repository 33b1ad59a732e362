//! A package of its own, built as a user would: it follows changes of its rule file, and the dependency has another
//! name. Its library denies warnings and missing documentation, which only a library can show.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const LIBRARY: &str = r#"//! Rules in a file.
#![deny(warnings, missing_docs)]
#![forbid(unsafe_code)]

shapes::cga! {
    /// From a file.
    #[cga(crate = shapes)]
    pub grammar Tower in "rules/tower.cga";
}

shapes::cga! {
    #[cga(crate = ::shapes)]
    pub grammar Inline;
    attr height = 3
    /// About it.
    attr colour = "x" + rand
    Lot --> extrude(height) print(colour) A.
}

/// Needs the fields.
pub fn tower(height: f64) -> Tower {
    Tower { height, ..Tower::default() }
}
"#;

const RULES: &str = "attr height = 3\nLot --> extrude(height) Wall.\n";

struct Package {
    folder: PathBuf,
}

impl Package {
    fn new() -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rebuild");
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace");
        let manifest = format!(
            "[package]\nname = \"rebuild\"\nversion = \"0.0.0\"\nedition = \"2021\"\npublish = false\n\n[dependencies]\n\
             shapes = {{ package = \"cga\", path = {root:?}, default-features = false }}\n\n[workspace]\n"
        );
        for part in ["src", "rules"] {
            fs::create_dir_all(folder.join(part)).expect("a writable target folder");
        }
        let package = Package { folder };
        package.write("Cargo.toml", &manifest);
        package.write("src/lib.rs", LIBRARY);
        package.write("rules/tower.cga", RULES);
        // The versions that are there already.
        fs::copy(root.join("Cargo.lock"), package.folder.join("Cargo.lock")).expect("a lock file");
        package
    }

    fn write(&self, file: &str, text: &str) {
        fs::write(self.folder.join(file), text).expect("a writable target folder");
    }

    /// Builds the package. Returns true for success, and cargo's output.
    fn check(&self) -> (bool, String) {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let output = Command::new(cargo)
            .args(["check", "--offline", "--color=never"])
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", self.folder.join("target"))
            .env_remove("RUSTFLAGS")
            .output()
            .expect("cargo");
        (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
    }
}

#[test]
fn a_build_follows_its_rule_file() {
    let package = Package::new();
    let (good, said) = package.check();
    assert!(good && said.contains("Checking rebuild"), "{said}");
    let (good, said) = package.check();
    assert!(good && !said.contains("Checking rebuild"), "nothing has changed\n{said}");

    package.write("rules/tower.cga", "attr height = 3\n\nLot --> extrude(heigth) Wall.\n");
    let (good, said) = package.check();
    assert!(!good && said.contains("unknown name `heigth`") && said.contains("rules/tower.cga:3:17"), "{said}");
    // The fields are there all the same.
    assert!(said.contains("due to 1 previous error"), "{said}");

    package.write("rules/tower.cga", RULES);
    let (good, said) = package.check();
    assert!(good, "{said}");

    fs::remove_file(package.folder.join("rules/tower.cga")).expect("it was there");
    let (good, said) = package.check();
    assert!(!good && said.contains("there is no file `rules/tower.cga`"), "{said}");
}
