//! The public interface: every name that a program can use, in a list. A change of the list is a decision; `CGA_BLESS=1` renews it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cga_tests::tree::root;

/// The checked list.
const LIST: &str = "tests/house/interface.txt";

/// The items of a library by name: the lines below, each with the name of the item before it.
type Items = BTreeMap<String, BTreeSet<String>>;

#[test]
fn the_public_interface_is_the_list() {
    let facade = fs::read_to_string(root().join("src/lib.rs")).expect("the library");
    let mut items = Items::new();
    let mut modules = BTreeMap::new();
    let crates = ["cga-runtime/src", "cga-geometry/src", "cga-street/src", "cga-picture/src"];
    let crates = crates.map(|folder| root().join(folder));
    for file in crates.iter().flat_map(|folder| sources(folder)) {
        let text = fs::read_to_string(&file).expect("a source file");
        let found = names_of(&text);
        modules.insert(file, found);
        read(&text, &mut items);
    }
    let mut lines = BTreeSet::new();
    for (module, name) in used(&facade).into_iter().filter(|(module, _)| !module.starts_with("__")) {
        let place = if module.is_empty() { "cga".to_owned() } else { format!("cga::{module}") };
        if let Some(members) = items.get(&name) {
            lines.insert(format!("{place}::{name}"));
            lines.extend(members.iter().map(|member| format!("{place}::{name}{member}")));
            continue;
        }
        lines.insert(format!("{place}::{name}"));
        // A module of the runtime: all names of its file.
        let members = [crates[0].join("output"), crates[1].clone()].into_iter().map(|folder| {
            members_of(&folder, &name, &modules, &items).map(|member| format!("{place}::{name}{member}")).collect()
        });
        lines.extend(members.into_iter().find(|members: &Vec<String>| !members.is_empty()).unwrap_or_default());
    }
    for (place, folder) in [("cga_geometry", &crates[1]), ("cga_picture", &crates[3])] {
        let library = fs::read_to_string(folder.join("lib.rs")).expect("the library");
        for name in library.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')) {
            lines.insert(format!("{place}::{name}"));
            let members = members_of(folder, name, &modules, &items);
            lines.extend(members.map(|member| format!("{place}::{name}{member}")));
        }
        for (_, name) in used(&library) {
            let members = items.get(&name).into_iter().flatten();
            lines.extend(members.map(|member| format!("{place}::{name}{member}")));
            lines.insert(format!("{place}::{name}"));
        }
    }
    let now: String = lines.iter().map(|line| format!("{line}\n")).collect();
    let path = root().join(LIST);
    if std::env::var_os("CGA_BLESS").is_some() {
        fs::write(&path, &now).expect("the list");
    }
    let listed = fs::read_to_string(&path).unwrap_or_default();
    let [old, new] = [&listed, &now].map(|text| text.lines().collect::<BTreeSet<_>>());
    let (gone, added): (Vec<_>, Vec<_>) = (old.difference(&new).collect(), new.difference(&old).collect());
    assert!(gone.is_empty() && added.is_empty(), "{LIST}: gone {gone:#?}, new {added:#?}; CGA_BLESS=1 accepts this");
    assert!(500 < lines.len(), "only {} names are found", lines.len());
}

/// All names of the file of a module, and their members.
fn members_of<'l>(
    folder: &Path,
    name: &str,
    modules: &'l BTreeMap<PathBuf, Vec<String>>,
    items: &'l Items,
) -> impl Iterator<Item = String> + use<'l> {
    let files = [folder.join(format!("{name}.rs")), folder.join(name).join("mod.rs")];
    let names = files.into_iter().filter_map(|file| modules.get(&file)).flatten();
    names.flat_map(|inner| {
        let members = items.get(inner).into_iter().flatten();
        members.map(move |member| format!("::{inner}{member}")).chain([format!("::{inner}")])
    })
}

/// The source files below a folder, tests left out.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if entry.is_dir() && name != "tests" {
            found.extend(sources(&entry));
        } else if name.ends_with(".rs") && !name.starts_with("tests") {
            found.push(entry);
        }
    }
    found
}

/// The names that the facade takes, each with its module.
fn used(facade: &str) -> Vec<(String, String)> {
    let (mut found, mut module, mut statement, mut hidden) = (Vec::new(), String::new(), String::new(), false);
    for line in facade.lines().map(|line| line.split("//").next().unwrap_or_default()) {
        let trimmed = line.trim();
        if let Some(name) = line.trim_start().strip_prefix("pub mod ").and_then(|rest| rest.strip_suffix(" {")) {
            module = if line.starts_with(' ') { format!("{module}::{name}") } else { name.to_owned() };
        } else if line == "}" {
            module.clear();
        } else if line == "    }" && statement.is_empty() {
            module = module.split("::").next().unwrap_or_default().to_owned();
        }
        hidden |= trimmed == "#[doc(hidden)]";
        if let Some(name) = trimmed.strip_prefix("pub type ") {
            let name = name.split([' ', '<']).next().unwrap_or_default();
            found.push((module.clone(), format!("{name} (old address)")));
        }
        if trimmed.starts_with("pub use ") || !statement.is_empty() {
            statement += trimmed;
            statement.push(' ');
            if !trimmed.ends_with(';') {
                continue;
            }
            let list = statement.trim_end_matches([';', ' ']).trim_start_matches("pub use ").to_owned();
            let names = match list.split_once('{') {
                Some((_, names)) => names.trim_end_matches(['}', ' ']).to_owned(),
                None => list.rsplit("::").next().unwrap_or_default().to_owned(),
            };
            let names = names.split(',').map(str::trim).filter(|name| !name.is_empty());
            let names = names.map(|name| name.rsplit(" as ").next().unwrap_or(name).to_owned());
            found.extend(names.filter(|_| !hidden).map(|name| (module.clone(), name)));
            (hidden, statement) = (false, String::new());
        }
    }
    found
}

/// The public names at the top of a file: its items, and what it takes from below.
fn names_of(text: &str) -> Vec<String> {
    let mut found: Vec<String> = text.lines().filter_map(|line| Some(head(line)?.1)).collect();
    found.extend(used(text).into_iter().filter(|(module, _)| module.is_empty()).map(|(_, name)| name));
    found
}

/// The kind and the name of a public item that begins in a line.
fn head(line: &str) -> Option<(&str, String)> {
    let (kind, rest) = line.strip_prefix("pub ")?.split_once(' ')?;
    let is_item = ["struct", "enum", "trait", "fn", "type", "const"].contains(&kind);
    let name: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    (is_item && !name.is_empty()).then_some((kind, name))
}

/// Adds the members of the items of a file. The code is formatted, so the depth of a line is its indent.
fn read(text: &str, items: &mut Items) {
    let (mut item, mut kind, mut header, mut hidden) = (String::new(), "", String::new(), false);
    for line in text.lines() {
        if line == "}" {
            item.clear();
            kind = "";
        } else if let Some((found, name)) = head(line) {
            items.entry(name.clone()).or_default();
            (item, kind) = if line.ends_with('{') { (name, found) } else { (String::new(), "") };
            (header, hidden) = (String::new(), false);
        } else if line.starts_with("impl") || !header.is_empty() {
            header += line;
            if line.ends_with('{') {
                (item, kind) = (implemented(&header).unwrap_or_default(), "impl");
                header.clear();
            }
        } else if let Some(member) = line.strip_prefix("    ").filter(|_| !item.is_empty()) {
            let name = |rest: &str| rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
            let public = member.strip_prefix("pub ");
            let found = match kind {
                "impl" => public
                    .map(|rest| {
                        rest.strip_prefix("const fn ").or(rest.strip_prefix("fn ")).or(rest.strip_prefix("const "))
                    })
                    .and_then(|rest| Some(format!("::{}", name(rest?)))),
                "trait" => member.strip_prefix("fn ").map(|rest| format!("::{}", name(rest))),
                "struct" => public.filter(|rest| rest.contains(':')).map(|rest| format!(".{}", name(rest))),
                "enum" if member.starts_with(char::is_uppercase) => Some(format!("::{}", name(member))),
                _ => None,
            };
            match found {
                Some(found) => {
                    if !std::mem::take(&mut hidden) {
                        items.entry(item.clone()).or_default().insert(found);
                    }
                }
                None => hidden |= member == "#[doc(hidden)]",
            }
        }
    }
}

/// The type of an `impl` without a trait.
fn implemented(header: &str) -> Option<String> {
    let mut rest = header.strip_prefix("impl")?;
    if rest.starts_with('<') {
        let mut depth = 0;
        let end = rest.char_indices().find_map(|(at, c)| {
            depth += i32::from(c == '<') - i32::from(c == '>' && !rest[..at].ends_with('-'));
            (depth == 0).then_some(at)
        })?;
        rest = &rest[end + 1..];
    }
    if rest.contains(" for ") {
        return None;
    }
    let path = rest.trim_start().split(['<', ' ']).next()?;
    Some(path.rsplit("::").next()?.to_owned())
}
