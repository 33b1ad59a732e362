//! The texts of the reference: for each word a page, a sentence and an example.
//!
//! ```text
//! # The group of the words after it
//!
//! extrude | op_extrude
//! The sentence, on one line.
//! Lot --> extrude(10) Mass.
//! ```

use super::Section;

/// The text about a word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Doc {
    /// The table that has the word.
    pub section: Section,
    /// The group of words on the page.
    pub group: &'static str,
    /// The word, or several words with spaces between them.
    pub name: &'static str,
    /// The name of Esri's page, such as `op_extrude`. Words that no page of Esri has are on the page of the changelog.
    pub page: &'static str,
    /// The signature of an annotation. The tables have the signatures of all other words.
    pub signature: Option<&'static str>,
    /// The description.
    pub text: &'static str,
    /// A rule file.
    pub example: &'static str,
}

impl Doc {
    /// The words.
    pub fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.name.split(' ')
    }
}

const FILES: [(Section, &str); 6] = [
    (Section::Syntax, include_str!("syntax.txt")),
    (Section::Operation, include_str!("operations.txt")),
    (Section::Selector, include_str!("selectors.txt")),
    (Section::Function, include_str!("functions.txt")),
    (Section::ShapeAttr, include_str!("attributes.txt")),
    (Section::Annotation, include_str!("annotations.txt")),
];

/// The texts of all words, in the order of the page. Parts that are missing are empty.
pub fn docs() -> Vec<Doc> {
    FILES.iter().flat_map(|(section, text)| file(*section, text)).collect()
}

fn file(section: Section, text: &'static str) -> Vec<Doc> {
    let (mut list, mut group) = (Vec::new(), "");
    for block in text.split("\n\n").map(str::trim).filter(|block| !block.is_empty()) {
        if let Some(name) = block.strip_prefix("# ") {
            group = name;
            continue;
        }
        let (head, rest) = block.split_once('\n').unwrap_or((block, ""));
        let (about, example) = rest.split_once('\n').unwrap_or((rest, ""));
        let mut head = head.splitn(3, " | ");
        let mut next = || head.next().map(str::trim);
        let (name, page, signature) = (next().unwrap_or_default(), next().unwrap_or_default(), next());
        list.push(Doc { section, group, name, page, signature, text: about, example });
    }
    list
}
