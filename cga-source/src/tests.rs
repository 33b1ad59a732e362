//! Files that are found, that are missing, and that must not be read.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use cga_lang::link::Files as _;

use crate::RuleFiles;

/// A folder that goes with its test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &str)]) -> Self {
        let folder = std::env::temp_dir().join(format!("cga-source-{name}-{}", std::process::id()));
        for (name, text) in files {
            let path = folder.join(name);
            fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
            fs::write(path, text).expect("a file");
        }
        Folder(folder.canonicalize().expect("a folder"))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn memory(files: &[(&str, &str)]) -> RuleFiles {
    RuleFiles::in_memory(files.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect())
}

#[test]
fn the_nearest_file_is_imported_although_another_was_read() {
    let folder = Folder::new("nearest", &[("a/b.cga", ""), ("a/x.cga", "near"), ("x.cga", "far")]);
    let mut files = RuleFiles::default().below(&folder.0).expect("a folder");
    files.load("x.cga".as_ref()).expect("a file");
    assert_eq!(files.open("x.cga", "a/b.cga").expect("a file").name, "a/x.cga");
    assert_eq!(files.open("../x.cga", "a/b.cga").expect("a file").name, "x.cga");
}

#[test]
fn the_list_has_the_files_that_were_read_and_those_that_are_missing() {
    let folder = Folder::new("list", &[("a/b.cga", ""), ("x.cga", "")]);
    let mut files = RuleFiles::default().below(&folder.0).expect("a folder");
    files.load("a/b.cga".as_ref()).expect("a file");
    files.open("x.cga", "a/b.cga").expect("a file");
    let paths = |list: &[&str]| list.iter().map(|name| folder.0.join(name)).collect::<Vec<_>>();
    assert_eq!(files.list().read(), paths(&["a/b.cga", "x.cga"]));
    assert_eq!(files.list().missing(), paths(&["a/x.cga", "a/assets/x.cga"]));
    assert!(files.load("lost.cga".as_ref()).is_err());
    assert!(files.list().missing().contains(&folder.0.join("lost.cga")));
    assert_eq!(memory(&[("x.cga", "")]).list(), &crate::FileList::default());
}

#[test]
fn names_in_memory_may_be_written_in_every_way() {
    let mut files = memory(&[("./a.cga", "1"), ("lib\\b.cga", "2"), ("rules.cga", "3"), ("../c.cga", "4")]);
    let text = files.add_text("text".to_owned());
    let from = files.unit(text).name;
    for (path, name) in [("a.cga", "a.cga"), ("lib/../lib/b.cga", "lib/b.cga"), ("../c.cga", "../c.cga")] {
        assert_eq!(files.open(path, &from).expect(path).name, name);
    }
    // The text is not the file of the same name.
    let unit = files.open("./rules.cga", &from).expect("a file");
    assert!(unit.name == "rules.cga" && from != "rules.cga", "{from}");
    assert_eq!(RuleFiles::in_memory(BTreeMap::new()).add_text(String::new()), 0);
}

#[test]
fn reasons_are_the_same_in_all_programs() {
    let folder = Folder::new("reasons", &[("rules/a.cga", ""), ("out.cga", "")]);
    let rules = folder.0.join("rules");
    let why = |files: &mut RuleFiles, path: &str| files.load(path.as_ref()).expect_err("an error");
    let disk = &mut RuleFiles::default().with_disk();
    let lost = rules.join("lost.cga").display().to_string();
    assert_eq!(why(disk, &lost), format!("cannot read `{lost}`: there is no such file"));
    let shown = rules.display().to_string();
    assert_eq!(why(disk, &shown), format!("cannot read `{shown}`: it is a folder; name a rule file in it"));
    let reason = format!("it is not a file in `{shown}`, and paths and links that lead out of it are not followed");
    let inside = &mut RuleFiles::default().below(&rules).expect("a folder");
    for path in ["../out.cga", "lost.cga"] {
        assert_eq!(why(inside, path), format!("cannot read `{path}`: {reason}"));
        assert_eq!(inside.open(path, "a.cga").expect_err("an error"), reason);
    }
    let file = rules.join("a.cga");
    assert_eq!(
        RuleFiles::default().inside(&file).expect_err("a file"),
        format!("cannot read `{}`: it is not a folder", file.display())
    );
}
