//! A package of its own, built as a user would: it follows changes of its rule file, and the dependency has another
//! name. Its library denies warnings and missing documentation, which only a library can show.

use std::fs;

use super::package::Package;

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

/// Checks the package. Returns true for success, and cargo's output.
fn check(package: &Package) -> (bool, String) {
    let output = package.check().output().expect("cargo");
    (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn a_build_follows_its_rule_file() {
    let package = Package::new("rebuild", "shapes", "");
    package.write("src/lib.rs", LIBRARY);
    package.write("rules/tower.cga", RULES);
    let (good, said) = check(&package);
    assert!(good && said.contains("Checking rebuild"), "{said}");
    let (good, said) = check(&package);
    assert!(good && !said.contains("Checking rebuild"), "nothing has changed\n{said}");

    package.write("rules/tower.cga", "attr height = 3\n\nLot --> extrude(heigth) Wall.\n");
    let (good, said) = check(&package);
    assert!(!good && said.contains("unknown name `heigth`") && said.contains("rules/tower.cga:3:17"), "{said}");
    // The fields are there all the same.
    assert!(said.contains("due to 1 previous error"), "{said}");

    package.write("rules/tower.cga", RULES);
    let (good, said) = check(&package);
    assert!(good, "{said}");

    fs::remove_file(package.folder.join("rules/tower.cga")).expect("it was there");
    let (good, said) = check(&package);
    assert!(!good && said.contains("there is no file `rules/tower.cga`"), "{said}");
}
