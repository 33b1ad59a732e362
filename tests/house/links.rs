//! Links of the README and of all pages lead to files, and to headings in them.

use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::path::PathBuf;

use cga_tests::tree::{files, root};

/// All Markdown files of the workspace.
fn pages() -> Vec<PathBuf> {
    let list = files(".md");
    assert!(list.iter().any(|path| path.ends_with("docs/guide/tutorial.md")), "the walk found the guide");
    list
}

/// The lines outside of code blocks, with code in backticks left out.
fn prose(text: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut in_code = false;
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            in_code = !in_code;
        } else if !in_code {
            lines.push(line.split('`').step_by(2).collect::<Vec<_>>().join("code"));
        }
    }
    lines
}

/// The targets of `[text](target)`, `[label]: target` and `src="target"`.
fn targets(text: &str) -> Vec<String> {
    let mut list = Vec::new();
    for line in prose(text) {
        let inline = line.split("](").skip(1).filter_map(|rest| rest.split([')', ' ']).next());
        let images = line.split("src=\"").skip(1).filter_map(|rest| rest.split('"').next());
        list.extend(inline.chain(images).map(str::to_owned));
        list.extend(definition(&line).map(|(_, target)| target.to_owned()));
    }
    list
}

/// `[label]: target`.
fn definition(line: &str) -> Option<(&str, &str)> {
    let (label, target) = line.strip_prefix('[')?.split_once("]: ")?;
    Some((label, target.split_whitespace().next()?))
}

/// The anchor of a heading, as GitHub and rustdoc make it.
pub(super) fn slug(heading: &str) -> String {
    let heading = heading.to_lowercase();
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | ' '));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// The anchors of a page: anchors of headings, as GitHub and rustdoc make them, and explicit ones.
fn anchors(text: &str) -> HashSet<String> {
    let mut list: HashSet<String> =
        text.split("<a id=\"").skip(1).filter_map(|rest| rest.split('"').next()).map(str::to_owned).collect();
    let mut in_code = false;
    for line in text.lines() {
        in_code ^= line.trim_start().starts_with("```");
        let Some(heading) = line.strip_prefix('#').filter(|_| !in_code) else { continue };
        let slug = slug(heading.trim_start_matches('#').trim());
        let same = (1..).map(|count| format!("{slug}-{count}")).find(|other| !list.contains(other));
        let slug = if list.contains(&slug) { same.expect("a free number") } else { slug };
        list.insert(slug);
    }
    list
}

#[test]
fn every_relative_link_leads_somewhere() {
    let (mut broken, mut count) = (Vec::new(), 0);
    for page in pages() {
        let text = fs::read_to_string(&page).expect("text");
        for target in targets(&text) {
            if target.contains("://") || target.starts_with("mailto:") {
                continue;
            }
            count += 1;
            let (file, anchor) = target.split_once('#').map_or((&*target, None), |(file, anchor)| (file, Some(anchor)));
            let path = if file.is_empty() { page.clone() } else { page.with_file_name("").join(file) };
            let has_anchor = || {
                let text = fs::read_to_string(&path).unwrap_or_default();
                anchor.is_none_or(|anchor| anchors(&text).contains(anchor))
            };
            if !path.exists() || !has_anchor() {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
    assert!(500 < count, "the links were found");
}

#[test]
fn labels_are_defined() {
    for page in pages() {
        let text = fs::read_to_string(&page).expect("text");
        let lines = prose(&text);
        let defined: HashSet<&str> = lines.iter().filter_map(|line| Some(definition(line)?.0)).collect();
        for line in &lines {
            for label in line.split("][").skip(1).filter_map(|rest| rest.split(']').next()) {
                assert!(defined.contains(label), "{}: `{label}` is not defined", page.display());
            }
        }
    }
}

#[test]
fn the_docs_of_the_crate_replace_each_link_of_the_readme() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    let source = fs::read_to_string(root().join("src/lib.rs")).expect("the crate");
    let links: BTreeMap<&str, &str> = readme.lines().filter_map(definition).collect();
    assert!(links.contains_key("picture") && links.contains_key("reference"));
    for (label, target) in links {
        let module = target.strip_prefix("docs/").unwrap_or_default().replace(".md", "").replace('/', "::");
        let module = format!("doc = \"[{label}]: crate::{module}\"");
        let online = format!(
            "concat!(\"[{label}]: <https://docs.rs/crate/cga/\", env!(\"CARGO_PKG_VERSION\"), \"/source/{target}>\")"
        );
        let local = format!("concat!(\"[{label}]: <file://\", env!(\"CARGO_MANIFEST_DIR\"), \"/{target}>\")");
        let is_file = source.contains(&online) && source.contains(&local);
        assert!(source.contains(&module) || is_file, "src/lib.rs: [{label}]: {target}");
    }
    // Links without a label would stay relative, and lead nowhere on docs.rs.
    let inline = prose(&readme).join("\n");
    let relative = inline.split("](").skip(1).find(|rest| !rest.starts_with("http"));
    assert_eq!(relative.and_then(|rest| rest.split(')').next()), None);
}

#[test]
fn code_of_the_readme_can_be_copied() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the README");
    let mut lines = readme.lines();
    while let Some(line) = lines.next() {
        if line == "```rust" {
            for line in lines.by_ref().take_while(|line| *line != "```") {
                assert!(line != "#" && !line.starts_with("# "), "package pages show hidden lines: {line}");
            }
        }
    }
}

/// The pages of the guide are modules, in which definitions of `src/guide.rs` replace the ones at the end of each page.
#[test]
fn the_docs_of_the_crate_replace_each_link_of_the_guide() {
    let source = fs::read_to_string(root().join("src/guide.rs")).expect("the guide");
    let pages: Vec<PathBuf> = pages().into_iter().filter(|path| path.starts_with(root().join("docs/guide"))).collect();
    assert!(9 < pages.len());
    for page in pages {
        let text = fs::read_to_string(&page).expect("text");
        let name = page.file_stem().expect("a name").to_string_lossy().into_owned();
        assert!(source.contains(&format!("page!({name}, \"../docs/guide/{name}.md\");")), "{name} is a module");
        for (label, target) in text.lines().filter_map(definition) {
            let from_docs = target.strip_prefix("../").map_or_else(|| format!("guide/{target}"), str::to_owned);
            let module = format!("\"[{label}]: crate::{}\"", from_docs.replace(".md", "").replace('/', "::"));
            let file = format!("concat!(\"[{label}]: \", file!(\"docs/{from_docs}\"))");
            assert!(source.contains(&module) || source.contains(&file), "src/guide.rs: {name}: [{label}]: {target}");
        }
        let inline = prose(&text).join("\n");
        let relative = inline.split("](").skip(1).find(|rest| !rest.starts_with("http") && !rest.starts_with('#'));
        assert_eq!(relative.and_then(|rest| rest.split(')').next()), None, "{name}: a link without a label");
    }
}
