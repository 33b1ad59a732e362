//! The words of the tables, with the contents of their rows.

use super::signature::{self, Signature};
use crate::ops::{self, SYNTAX};
use crate::syntax::words::ANNOTATIONS;

/// A table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Section {
    /// Words and signs of rule bodies that are not operations.
    Syntax,
    /// Operations.
    Operation,
    /// Kinds of components and selectors.
    Selector,
    /// Functions.
    Function,
    /// Attributes of shapes.
    ShapeAttr,
    /// Annotations.
    Annotation,
}

/// A row of a table, or several that differ in types alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// The name with parameters.
    pub signature: Signature,
    /// The effect, in a few words. Empty if the table has none.
    pub about: &'static str,
    /// The words of each parameter that takes words.
    pub words: Vec<(&'static str, Vec<&'static str>)>,
    /// The documented values of parameters, in words.
    pub bounds: Vec<(&'static str, &'static str)>,
    /// The operations that take a selector, or the type of an attribute. Empty for other tables.
    pub note: String,
    /// The replacement of an old row: a use is a warning with this help.
    pub old: Option<&'static str>,
}

/// All rows with one name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The table.
    pub section: Section,
    /// The word.
    pub name: &'static str,
    /// Its rows, in the order of the table.
    pub forms: Vec<Form>,
}

impl Entry {
    fn add(&mut self, form: Form) {
        for own in &mut self.forms {
            let rest = (own.about, &own.words, &own.bounds, &own.note, own.old);
            let is_alike = rest == (form.about, &form.words, &form.bounds, &form.note, form.old);
            if is_alike && own.signature.merge(&form.signature) {
                return;
            }
        }
        self.forms.push(form);
    }
}

fn plain(signature: Signature, about: &'static str, old: Option<&'static str>) -> Form {
    Form { signature, about, words: Vec::new(), bounds: Vec::new(), note: String::new(), old }
}

/// Every word of the tables once, with its rows.
pub fn entries() -> Vec<Entry> {
    let mut list: Vec<Entry> = Vec::new();
    let mut add = |section: Section, name: &'static str, form: Form| match list
        .iter_mut()
        .find(|entry| entry.section == section && entry.name == name)
    {
        Some(entry) => entry.add(form),
        None => list.push(Entry { section, name, forms: vec![form] }),
    };
    for row in SYNTAX {
        add(Section::Syntax, row.name, plain(Signature::word(row.name), row.about, None));
    }
    for row in ops::all_operations() {
        let form = plain(Signature::operation(row), row.about, row.old);
        let (words, bounds) = (signature::words(row.params), signature::bounds(row.params));
        add(Section::Operation, row.name, Form { words, bounds, ..form });
    }
    for row in ops::COMPONENTS {
        let note = "`comp`, `modify`".to_owned();
        let form = Form { note, ..plain(Signature::word(row.name), row.about, None) };
        add(Section::Selector, row.name, form);
    }
    for row in ops::selectors() {
        let form = Form { note: signature::places(row.on), ..plain(Signature::word(row.name), row.about, row.old) };
        add(Section::Selector, row.name, form);
    }
    for row in ops::all_functions() {
        let form = plain(Signature::function(row), row.about, row.old);
        let (words, bounds) = (signature::words(row.params), signature::bounds(row.params));
        add(Section::Function, row.name, Form { words, bounds, ..form });
    }
    for row in ops::all_shape_attrs() {
        let access = if row.set.is_some() { "read and set" } else { "read only" };
        let note = format!("{}, {access}", signature::kind(&row.kind));
        let form = Form { note, ..plain(Signature::word(row.name), "", row.old) };
        add(Section::ShapeAttr, row.name, form);
    }
    for name in ANNOTATIONS {
        let old = (*name == "Location").then_some("leave it out");
        add(Section::Annotation, name, plain(Signature::word(name), "", old));
    }
    list
}
