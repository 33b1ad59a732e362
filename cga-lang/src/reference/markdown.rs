//! The reference as a page.

use super::entry::{Entry, Form, Section, entries};
use super::pages::{page_address, page_title};
use super::text::{Doc, docs};
use std::collections::{HashMap, HashSet};
use std::fmt::Write;

const HEAD: &str = "\
# Reference

Every word of the language, from the tables that the compiler reads. The examples are CGA as in `.cga` files and strings; in
inline rules, relative sizes are written with `^` instead of `'`, and comments with `//`.

A signature has each parameter with its kind, and with its default if it can be left out: a `length` is in metres or relative
(`'0.5`), a `size` may also float (`~1`), a `colour` is text such as `\"#ff8000\"`, a `channel` is a number from 0 to 1, a `file`
is the name of a file below the asset folder, and a `word` is one of the words that are listed. Functions without arguments
need no parentheses.

*Old* words run, and a use is a warning with the current spelling. The last line of each entry links to the page of Esri's reference,
which this page does not replace.

";

/// The page, as Markdown.
pub fn page() -> String {
    let mut page = HEAD.to_owned();
    let (docs, entries) = (docs(), entries());
    let by_name: HashMap<(Section, &str), &Entry> =
        entries.iter().map(|entry| ((entry.section, entry.name), entry)).collect();
    contents(&mut page, &docs);
    let (mut section, mut group) = (None, "");
    for doc in &docs {
        if section != Some(doc.section) {
            section = Some(doc.section);
            let _ = write!(page, "## {}\n\n", title(doc.section));
        }
        if group != doc.group {
            group = doc.group;
            let _ = write!(page, "### {group}\n\n");
        }
        let own: Vec<&Entry> = doc.names().filter_map(|name| by_name.get(&(doc.section, name)).copied()).collect();
        entry(&mut page, doc, &own);
    }
    page.truncate(page.trim_end().len());
    page.push('\n');
    page
}

fn title(section: Section) -> &'static str {
    match section {
        Section::Syntax => "Syntax of rules",
        Section::Operation => "Operations",
        Section::Selector => "Components and selectors",
        Section::Function => "Functions",
        Section::ShapeAttr => "Attributes of shapes",
        Section::Annotation => "Annotations",
    }
}

/// The anchor of a word. Names that differ in capitals alone, or occur in several tables, have anchors of their own.
fn anchor(section: Section, name: &str) -> String {
    let kind = match section {
        Section::Syntax => "syntax",
        Section::Operation => "operation",
        Section::Selector => "selector",
        Section::Function => "function",
        Section::ShapeAttr => "attribute",
        Section::Annotation => "annotation",
    };
    match name {
        "[" => format!("{kind}-push"),
        "]" => format!("{kind}-pop"),
        _ => format!("{kind}-{name}"),
    }
}

fn contents(page: &mut String, docs: &[Doc]) {
    let (mut section, mut group) = (None, "");
    for doc in docs {
        if section != Some(doc.section) {
            section = Some(doc.section);
            let _ = write!(page, "{}**{}**\n\n", if group.is_empty() { "" } else { "\n\n" }, title(doc.section));
            group = "";
        }
        if group != doc.group {
            let _ = write!(page, "{}- {}:", if group.is_empty() { "" } else { "\n" }, doc.group);
            group = doc.group;
        }
        for name in doc.names() {
            let _ = write!(page, " [`{name}`](#{})", anchor(doc.section, name));
        }
    }
    page.push_str("\n\n");
}

fn entry(page: &mut String, doc: &Doc, entries: &[&Entry]) {
    page.push_str("####");
    for name in doc.names() {
        let at = if doc.section == Section::Annotation { "@" } else { "" };
        let _ = write!(page, " <a id=\"{}\"></a>`{at}{name}`", anchor(doc.section, name));
    }
    page.push_str("\n\n");
    page.push_str(&about(doc, entries));
}

/// The text about words, without their heading.
pub(super) fn about(doc: &Doc, entries: &[&Entry]) -> String {
    let mut page = format!("{}\n\n", doc.text);
    let forms: Vec<&Form> = entries.iter().flat_map(|entry| &entry.forms).collect();
    match doc.section {
        Section::Operation | Section::Function => signatures(&mut page, &forms),
        Section::Annotation => {
            let _ = write!(page, "```text\n{}\n```\n\n", doc.signature.unwrap_or_default());
        }
        Section::Syntax | Section::Selector | Section::ShapeAttr => {}
    }
    let _ = write!(page, "```cga\n{}\n```\n\n", doc.example);
    let mut notes: Vec<String> = Vec::new();
    for form in &forms {
        let note = match doc.section {
            Section::Selector => format!("In {}.", form.note),
            Section::ShapeAttr => format!("{}.", capitalized(&form.note)),
            _ => continue,
        };
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    if let Some(olds) = forms.iter().map(|form| form.old).collect::<Option<Vec<_>>>()
        && let Some(instead) = olds.first()
    {
        notes.push(format!("Old: {instead}."));
    }
    let title = page_title(doc.page).unwrap_or_default();
    notes.push(format!("Esri: [{title}]({})", page_address(doc.page)));
    let _ = write!(page, "{}\n\n", notes.join(" "));
    page
}

fn capitalized(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(chars).collect()
}

/// The signatures, each with its effect if these differ, then the words and the values of parameters.
fn signatures(page: &mut String, forms: &[&Form]) {
    let is_mixed = forms.iter().any(|form| form.old != forms[0].old);
    let abouts: HashSet<&str> = forms.iter().map(|form| form.about).collect();
    page.push_str("```text\n");
    for form in forms {
        let mut notes: Vec<String> = Vec::new();
        if 1 < abouts.len() {
            notes.push(form.about.to_owned());
        }
        if let Some(instead) = form.old
            && is_mixed
        {
            notes.push(format!("old: {instead}"));
        }
        let notes = if notes.is_empty() { String::new() } else { format!("    # {}", notes.join("; ")) };
        let _ = writeln!(page, "{}{notes}", form.signature);
    }
    page.push_str("```\n\n");
    let mut lines: Vec<String> = Vec::new();
    for form in forms {
        for (name, words) in &form.words {
            let words: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
            lines.push(format!("- `{name}`: {}", words.join(", ")));
        }
        lines.extend(form.bounds.iter().map(|(name, about)| format!("- `{name}`: {about}")));
    }
    let mut seen = HashSet::new();
    lines.retain(|line| seen.insert(line.clone()));
    for line in &lines {
        let _ = writeln!(page, "{line}");
    }
    page.push_str(if lines.is_empty() { "" } else { "\n" });
}
