//! Parameters of operations and functions.

use super::{Allowed, ParamBounds};
use crate::diag::code::Code;
use crate::types::Type;

/// A parameter of an operation or function.
#[derive(Debug, PartialEq)]
pub struct Param {
    /// The name in messages.
    pub name: &'static str,
    /// The kind of argument that it takes.
    pub kind: ParamKind,
    /// The value of an argument that is left out.
    pub default: Option<Default>,
    /// The values that the reference allows, if it restricts them.
    pub bounds: Option<&'static ParamBounds>,
}

/// The value of an argument that is left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// A number.
    Float(f64),
    /// A truth value.
    Bool(bool),
    /// Text.
    Text(&'static str),
    /// A word of the parameter.
    Word(&'static str),
}

/// The kind of argument of a parameter, and of value of an attribute of shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ParamKind {
    /// A value of this type.
    Value(Type),
    /// A value of any type. The runtime's function is generic.
    Any,
    /// A length in metres, or relative with `'`.
    Length,
    /// A length in metres, relative with `'` or floating with `~`.
    Size,
    /// Text: a colour, as in `"#ff8000"`.
    Color,
    /// A part of a colour, from 0 to 1.
    Channel,
    /// Text: the name of a file, which is searched from the folder of the rule file that contains it.
    File(FileUse),
    /// Names of files, which are searched as for `File`: a list in text, with a semicolon after each name, or an array.
    Files(Type),
    /// Text: the name of the image of a texture layer. The file is not opened, because materials only keep its name.
    /// The number of the layer is the number of its uv set (*texturing*).
    Image(u32),
    /// A selector of components, an index or a condition. No implemented row has such a parameter yet.
    Selector,
    /// A float that is computed for each edge of each face, with the edge as current shape. The runtime gets the array.
    PerEdge,
    /// A word.
    Word(Words),
}

/// The use of a file named by an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileUse {
    /// It is read, so it must exist.
    Read,
    /// It is inserted as geometry, so it must exist and have faces.
    Inserted,
    /// Its existence is tested.
    Asked,
    /// It is a pattern that several files may match.
    Searched,
}

/// The words that a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Words {
    /// The words in rules.
    pub list: &'static [&'static str],
    /// Old words with their replacements. They are also in the list.
    pub old: Pairs,
    /// The enum of the runtime that has a variant for each word.
    pub rust: &'static str,
    /// Words whose variant has another name, with this name.
    pub renamed: Pairs,
    /// The code of a diagnostic about an unknown word.
    pub unknown: Code,
}

/// Words, each with another name.
type Pairs = &'static [(&'static str, &'static str)];

impl Words {
    /// Returns true if `word` is one of the words.
    pub fn has(&self, word: &str) -> bool {
        self.list.contains(&word)
    }

    /// The words without the old ones.
    pub fn current(self) -> impl Iterator<Item = &'static str> + Clone {
        self.list.iter().copied().filter(move |word| self.old.iter().all(|(old, _)| old != word))
    }

    /// The word and replacement of an old word.
    pub fn old(&self, word: &str) -> Option<(&'static str, &'static str)> {
        self.old.iter().copied().find(|(old, _)| *old == word)
    }

    /// The name of a word's variant in the runtime's enum.
    pub fn variant(&self, word: &str) -> String {
        match self.renamed.iter().find(|(own, _)| *own == word) {
            Some((_, variant)) => (*variant).to_owned(),
            None => variant(word),
        }
    }
}

/// The usual variant name of a word in an enum of the runtime: `WorldUp` for `world.up`.
pub fn variant(word: &str) -> String {
    let capitalized = |part: &str| {
        let mut chars = part.chars();
        chars.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(chars).collect::<String>()
    };
    word.split('.').map(capitalized).collect()
}

impl ParamKind {
    /// The words that it takes, if it takes words.
    pub fn words(&self) -> Option<Words> {
        match self {
            ParamKind::Word(words) => Some(*words),
            _ => None,
        }
    }

    /// Returns true if a bare word means this word and not the name of a value.
    pub fn has_word(&self, word: &str) -> bool {
        self.words().is_some_and(|words| words.has(word))
    }

    /// Returns true if an argument can fit both kinds.
    pub fn overlaps(&self, other: &ParamKind) -> bool {
        match (self, other) {
            (ParamKind::Word(words), ParamKind::Word(others)) => words.list.iter().any(|word| others.has(word)),
            (ParamKind::Selector, _) | (_, ParamKind::Selector) => true,
            (ParamKind::Word(_), _) | (_, ParamKind::Word(_)) => false,
            (ParamKind::Any, _) | (_, ParamKind::Any) => true,
            _ => self.ty() == other.ty(),
        }
    }

    /// The type of the value; `None` for words and if any type fits.
    pub const fn ty(&self) -> Option<Type> {
        match self {
            ParamKind::Value(ty) | ParamKind::Files(ty) => Some(*ty),
            ParamKind::Length | ParamKind::Size | ParamKind::PerEdge | ParamKind::Channel => Some(Type::Float),
            ParamKind::File(_) | ParamKind::Image(_) | ParamKind::Color => Some(Type::Text),
            ParamKind::Any | ParamKind::Selector | ParamKind::Word(_) => None,
        }
    }

    /// Returns true for the name of a file, and for several names.
    pub fn is_file(&self) -> bool {
        matches!(self, ParamKind::File(_) | ParamKind::Files(_) | ParamKind::Image(_))
    }
}

/// Returns true if the parameters take `count` arguments.
pub(super) fn takes(params: &[Param], count: usize) -> bool {
    required(params) <= count && count <= params.len()
}

/// The number of required arguments.
pub fn required(params: &[Param]) -> usize {
    params.iter().take_while(|param| param.default.is_none()).count()
}

// Short forms for the tables.

pub(super) const fn param(name: &'static str, kind: ParamKind) -> Param {
    Param { name, kind, default: None, bounds: None }
}

pub(super) const fn float(name: &'static str) -> Param {
    of(name, Type::Float)
}

pub(super) const fn boolean(name: &'static str) -> Param {
    of(name, Type::Bool)
}

pub(super) const fn text(name: &'static str) -> Param {
    of(name, Type::Text)
}

pub(super) const fn of(name: &'static str, ty: Type) -> Param {
    param(name, ParamKind::Value(ty))
}

/// A file that is read.
pub(super) const FILE: Param = file("filePath", FileUse::Read);

pub(super) const fn file(name: &'static str, used: FileUse) -> Param {
    param(name, ParamKind::File(used))
}

/// Names of files, in text or in an array.
pub(super) const fn files(name: &'static str, ty: Type) -> Param {
    param(name, ParamKind::Files(ty))
}

pub(super) const fn length(name: &'static str) -> Param {
    param(name, ParamKind::Length)
}

pub(super) const fn size(name: &'static str) -> Param {
    param(name, ParamKind::Size)
}

/// A colour as text.
pub(super) const HEX: Param = param("hexValue", ParamKind::Color);

/// A part of a colour.
pub(super) const fn channel(name: &'static str) -> Param {
    param(name, ParamKind::Channel)
}

/// A parameter with a default.
pub(super) const fn or(param: Param, default: Default) -> Param {
    Param { default: Some(default), ..param }
}

/// A parameter with documented bounds.
pub(super) const fn within(param: Param, bounds: &'static ParamBounds) -> Param {
    Param { bounds: Some(bounds), ..param }
}

/// Bounds without a documented result for other values.
pub(super) const fn bounds(values: Allowed, about: &'static str) -> ParamBounds {
    ParamBounds { values, about, code: Code::OutOfRange, result: None, with_word: &[], element: None }
}

/// The numbers of uv sets (*texturing*).
static UV_SETS: ParamBounds =
    ParamBounds { code: Code::UnknownUvSet, ..bounds(Allowed::Between(0.0, 9.0), "uv sets are numbered from 0 to 9") };

/// The number of a uv set.
pub(super) const fn uv_set(name: &'static str) -> Param {
    within(float(name), &UV_SETS)
}

/// Any query; a check compares its parts with known tags.
static TAG_QUERIES: ParamBounds =
    ParamBounds { code: Code::UnknownTag, ..bounds(Allowed::TagQuery, "`?` is one part of a tag, `*` one or more") };

/// A query for component tags.
pub(super) const TAG_QUERY: Param = within(text("tagQuery"), &TAG_QUERIES);

/// A parameter for words, each of which is a variant of an enum of the runtime.
pub(super) const fn word(name: &'static str, rust: &'static str, list: &'static [&'static str]) -> Param {
    param(name, ParamKind::Word(Words { list, rust, old: &[], renamed: &[], unknown: Code::UnknownWord }))
}

/// The parameter with words whose variants have other names.
pub(super) const fn renamed(renamed: Pairs, row: Param) -> Param {
    match row.kind {
        ParamKind::Word(words) => Param { kind: ParamKind::Word(Words { renamed, ..words }), ..row },
        _ => row,
    }
}

/// The parameter with another code for unknown words.
pub(super) const fn unknown(unknown: Code, row: Param) -> Param {
    match row.kind {
        ParamKind::Word(words) => Param { kind: ParamKind::Word(Words { unknown, ..words }), ..row },
        _ => row,
    }
}

/// The parameter with old words.
pub(super) const fn outdated(old: Pairs, row: Param) -> Param {
    match row.kind {
        ParamKind::Word(words) => Param { kind: ParamKind::Word(Words { old, ..words }), ..row },
        _ => row,
    }
}
