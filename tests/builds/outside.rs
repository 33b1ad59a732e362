//! The documents from outside: a package that depends on `cga` alone compiles their code, and its documentation has no broken link.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use cga_tests::tree::{files_below, root};
use cga_tests::tutorial::{blocks, programs, steps};

use super::package::{Package, target};

#[test]
fn documents_hold_in_a_package_of_a_user() {
    let package = Package::new("outside", "cga", "");
    package.write("src/lib.rs", "");
    let doc = target().join("doc");
    let _ = fs::remove_dir_all(&doc);
    succeeds(package.command("doc").args(["-p", "cga", "--no-deps"]));

    let pages = files_below(&doc.join("cga"), ".html");
    let guide = pages.iter().filter(|page| page.starts_with(doc.join("cga/guide")));
    let front = [doc.join("cga/index.html"), doc.join("cga/reference/index.html")];
    let broken: Vec<String> = front.iter().chain(guide).flat_map(|page| broken_links(page)).collect();
    assert_eq!(broken, [] as [&str; 0]);

    let mut modules = Modules { package: &package, list: String::from("#![allow(dead_code, unused)]\n"), count: 0 };
    let lines: BTreeSet<String> =
        pages.iter().flat_map(|page| use_lines(&fs::read_to_string(page).expect("a page"))).collect();
    assert!(50 < lines.len(), "the examples were found");
    for (number, line) in (1..).zip(&lines) {
        let _ = writeln!(modules.list, "mod use_{number} {{ {line} }}");
    }
    for file in documents() {
        let text = fs::read_to_string(&file).expect("a document");
        let name = file.file_stem().expect("a name").to_string_lossy().to_lowercase();
        // The blocks of the tutorial are steps.
        for block in blocks(&text).into_iter().filter(|_| name != "tutorial") {
            modules.add(&name, &whole(block));
        }
    }
    assert!(40 < modules.count, "the blocks were found");

    let guide = root().join("docs/guide");
    for file in ["house.cga", "assets/bricks.png", "assets/tiles.png"] {
        let to = package.folder.join(file);
        fs::create_dir_all(to.parent().expect("a folder")).expect("a writable folder");
        fs::copy(guide.join(file), to).expect("a file of the tutorial");
    }
    for step in steps() {
        modules.add("step", &step.program());
    }
    for (name, program) in programs() {
        package.write(&format!("src/bin/{name}.rs"), &program);
    }

    package.write("src/lib.rs", &modules.list);
    let messages = succeeds(&mut package.check());
    // Also a file of the tutorial that the compiler does not find.
    assert!(!messages.contains("warning: "), "{messages}");
}

/// Runs a command, and returns what it writes to standard error.
fn succeeds(command: &mut Command) -> String {
    let output = command.output().expect("cargo");
    let messages = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{messages}");
    messages
}

/// The README and the pages with code in Rust.
fn documents() -> Vec<PathBuf> {
    let mut list = vec![root().join("README.md")];
    list.extend(files_below(&root().join("docs/guide"), ".md"));
    list
}

/// The modules of the package.
struct Modules<'p> {
    package: &'p Package,
    list: String,
    count: usize,
}

impl Modules<'_> {
    fn add(&mut self, name: &str, code: &str) {
        self.count += 1;
        let name = format!("{name}_{}", self.count);
        self.package.write(&format!("src/{name}.rs"), code);
        let _ = writeln!(self.list, "mod {name};");
    }
}

/// The code of a block that a reader can copy, with a `main` if it has none.
fn whole(block: &str) -> String {
    let mut lines = Vec::new();
    for line in block.lines() {
        let hidden = line.strip_prefix("# ").or((line == "#").then_some(""));
        // Conditions are for documentation tests without all features, and results are for their functions.
        let left_out = |own: &str| own.starts_with("#[cfg") || own == "{" || own == "}" || own.starts_with("Ok::<");
        match hidden {
            Some(own) if left_out(own) => {}
            Some(own) => lines.push(own),
            None => lines.push(line),
        }
    }
    let code = lines.join("\n");
    if code.contains("fn main()") {
        return code;
    }
    format!("fn main() -> Result<(), Box<dyn std::error::Error>> {{\n{code}\nOk(())\n}}\n")
}

/// The lines of examples in a page of documentation that begin with `use cga`.
fn use_lines(page: &str) -> Vec<String> {
    let mut list = Vec::new();
    for example in page.split("<pre class=\"rust rust-example-rendered\">").skip(1) {
        let example = plain(example.split("</pre>").next().unwrap_or_default());
        let mut rest = example.as_str();
        while let Some(start) = rest.find("use cga") {
            let begins = rest[..start].chars().next_back().is_none_or(char::is_whitespace);
            let length = rest[start..].find(';').map_or(rest.len() - start, |end| end + 1);
            if begins {
                list.push(rest[start..start + length].replace('\n', " "));
            }
            rest = &rest[start + length..];
        }
        list.extend(example.split("cga::").skip(1).filter_map(path));
    }
    list
}

/// The path after `cga::`, as an import: up to the first name of a type.
fn path(rest: &str) -> Option<String> {
    let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_' && c != ':').unwrap_or(rest.len());
    let names: Vec<&str> = rest[..end].split("::").collect();
    let is_type = |name: &&str| name.starts_with(char::is_uppercase);
    let length = names.iter().position(is_type).map_or(names.len(), |at| at + 1);
    let path = names[..length].join("::");
    (!path.is_empty() && !path.ends_with("::")).then(|| format!("use cga::{path};"))
}

/// Text of a page without its marks.
fn plain(html: &str) -> String {
    let mut text = String::new();
    for part in html.split('<') {
        text.push_str(part.split_once('>').map_or(part, |(_, rest)| rest));
    }
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&#39;", "'").replace("&amp;", "&")
}

/// The links and pictures in the text of a page that lead to a file or heading that does not exist.
fn broken_links(page: &Path) -> Vec<String> {
    let html = fs::read_to_string(page).unwrap_or_else(|error| panic!("{}: {error}", page.display()));
    let (_, text) = html.split_once("<section id=\"main-content\"").expect("a text");
    let targets = text.split("href=\"").skip(1).chain(text.split("src=\"").skip(1));
    let mut broken = Vec::new();
    for target in targets.filter_map(|rest| rest.split('"').next()) {
        if target.starts_with("https://") || target.starts_with("data:") {
            continue;
        }
        let target = target.replace("%20", " ").replace("&amp;", "&");
        let (file, anchor) = target.split_once('#').unwrap_or((&target, ""));
        // Lines of source code are marked by a script.
        let anchor = if file.ends_with(".rs.html") { "" } else { anchor };
        let path = match file.strip_prefix("file://") {
            Some(path) => PathBuf::from(path),
            None if file.is_empty() => page.to_owned(),
            None => page.with_file_name("").join(file),
        };
        let has_anchor = || fs::read_to_string(&path).is_ok_and(|other| other.contains(&format!("id=\"{anchor}\"")));
        if !path.exists() || !(anchor.is_empty() || has_anchor()) {
            broken.push(format!("{}: {target}", page.display()));
        }
    }
    broken
}
