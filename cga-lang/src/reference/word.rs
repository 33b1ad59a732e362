//! The words of the tables with their parameters and the text of the reference, for editors.

use super::entry::{Entry, Section, entries};
use super::markdown::about;
use super::text::docs;
use std::collections::HashMap;

/// A word of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The table that has it.
    pub section: Section,
    /// The word.
    pub name: &'static str,
    /// The text of the reference, as Markdown.
    pub about: String,
    /// The names and kinds of the parameters of its first row, without those that have a default. `None` for a word that takes no
    /// parentheses.
    pub params: Option<Vec<(&'static str, &'static str)>>,
    /// The type of its value, if it is a function with one.
    pub result: Option<&'static str>,
}

/// All words, in the order of the page.
pub fn words() -> Vec<Word> {
    let entries = entries();
    let by_name: HashMap<(Section, &str), &Entry> =
        entries.iter().map(|entry| ((entry.section, entry.name), entry)).collect();
    let mut list = Vec::new();
    for doc in docs() {
        let own: Vec<&Entry> = doc.names().filter_map(|name| by_name.get(&(doc.section, name)).copied()).collect();
        let text = about(&doc, &own);
        for entry in own {
            let first = entry.forms.first().map(|form| &form.signature);
            list.push(Word {
                section: doc.section,
                name: entry.name,
                about: text.clone(),
                params: first.and_then(|signature| signature.required()),
                result: first.and_then(|signature| signature.result()),
            });
        }
    }
    list
}
