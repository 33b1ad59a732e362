//! The meaning of each name in inline rules.

use cga_lang::compile::Compiled;
use cga_lang::editor::Context;
use cga_lang::editor::index::{NameKind, Named};
use cga_lang::editor::outline::{Part, PartKind, Word, outline};
use cga_lang::ir::Type;
use cga_lang::ops::{functions, operations};
use cga_source::rust::Header;
use proc_macro2::{Ident, Span, TokenStream};
use std::collections::{HashMap, HashSet};

use crate::codegen::{PublicAttr, is_plain};
use crate::source::Source;

/// The names of a file.
pub(super) struct Scope<'a> {
    pub(super) header: &'a Header,
    pub(super) source: &'a Source,
    pub(super) compiled: &'a Compiled,
    pub(super) parts: Vec<Part>,
    /// The declaration of each resolved name.
    declared: HashMap<u32, &'a Named>,
    /// The types of declared names, where they are known.
    types: HashMap<u32, Option<Type>>,
    /// The items of declarations, by token. Overloads and styles get numbers.
    items: HashMap<u32, String>,
    /// Rules, and attributes, constants and functions, by name: the first of each.
    rules: HashMap<&'a str, u32>,
    values: HashMap<&'a str, u32>,
    attrs: HashSet<u32>,
    /// The fields of the public struct.
    fields: &'a [PublicAttr],
}

/// The meaning of a name.
pub(super) enum Meaning {
    /// The item of a declaration.
    Item(String),
    /// An attribute: a field of the public struct.
    Field,
    /// A parameter or local value.
    Local,
    /// A word of the language, or a name that is not known.
    Word,
}

impl<'a> Scope<'a> {
    pub(super) fn new(
        compiled: &'a Compiled,
        header: &'a Header,
        source: &'a Source,
        fields: &'a [PublicAttr],
    ) -> Self {
        let tokens = source.tokens.as_slice();
        let parts = outline(tokens);
        let mut scope = Scope {
            header,
            source,
            compiled,
            declared: HashMap::new(),
            types: compiled.index.iter().map(|named| (named.token, named.ty)).collect(),
            items: HashMap::new(),
            rules: HashMap::new(),
            values: HashMap::new(),
            attrs: HashSet::new(),
            fields,
            parts: Vec::new(),
        };
        for named in &compiled.index {
            scope.declared.extend(named.uses.iter().map(|token| (*token, named)));
        }
        let mut counts: HashMap<(&str, bool), u32> = HashMap::new();
        for part in &parts {
            let Some(token) = part.name else { continue };
            let Some(name) = tokens[token as usize].ident().filter(|name| is_plain(name)) else { continue };
            let kind = if part.kind == PartKind::Rule { &mut scope.rules } else { &mut scope.values };
            kind.entry(name).or_insert(token);
            if part.kind == PartKind::Attr {
                scope.attrs.insert(token);
                continue;
            }
            let count = counts.entry((name, part.kind == PartKind::Rule)).or_insert(0);
            *count += 1;
            let item = if *count == 1 { name.to_owned() } else { format!("{name}_{count}") };
            scope.items.insert(token, item);
        }
        scope.parts = parts;
        scope
    }

    /// The name of a token, if Rust can have it.
    pub(super) fn plain(&self, token: u32) -> Option<&'a str> {
        self.source.tokens.as_slice().get(token as usize)?.ident().filter(|name| is_plain(name))
    }

    /// A name with the place of a token.
    pub(super) fn at(&self, name: &str, token: u32) -> Ident {
        Ident::new(name, self.source.token(token))
    }

    /// The item of a declaration.
    pub(super) fn item(&self, token: u32) -> Option<Ident> {
        self.items.get(&token).map(|item| self.at(item, token))
    }

    /// The type of a declared name.
    pub(super) fn ty(&self, token: u32) -> TokenStream {
        match self.types.get(&token).copied().flatten() {
            Some(Type::Float) => code!(f64),
            Some(Type::Bool) => code!(bool),
            Some(Type::Text) => code!(&'static str),
            Some(Type::Floats) => code!(&'static [f64]),
            Some(Type::Bools) => code!(&'static [bool]),
            Some(Type::Texts) => code!(&'static [&'static str]),
            None => code!(()),
        }
    }

    /// The meaning of a name: as the compiler found it, else by the tokens alone.
    pub(super) fn meaning(&self, part: &Part, word: &Word) -> Option<Meaning> {
        let name = self.plain(word.token)?;
        if let Some(named) = self.declared.get(&word.token) {
            return Some(self.own(named.kind, named.token));
        }
        let is_dotted = !word.fields.is_empty();
        let found = match word.context {
            Context::Operation if operations(name).next().is_none() => self.rules.get(name),
            Context::Value | Context::Argument { .. } if !is_dotted => {
                if part.params.iter().chain(&part.locals).any(|token| self.plain(*token) == Some(name)) {
                    return Some(Meaning::Local);
                }
                self.values.get(name).filter(|_| functions(name).next().is_none())
            }
            _ => None,
        };
        Some(match found {
            Some(token) if self.attrs.contains(token) => Meaning::Field,
            Some(token) => self.own(NameKind::Rule, *token),
            None => Meaning::Word,
        })
    }

    fn own(&self, kind: NameKind, token: u32) -> Meaning {
        match kind {
            NameKind::Attr => Meaning::Field,
            NameKind::Param(_) => Meaning::Local,
            NameKind::Const | NameKind::Function | NameKind::Rule => {
                self.items.get(&token).cloned().map_or(Meaning::Word, Meaning::Item)
            }
        }
    }

    /// A name with the names after its dots.
    pub(super) fn dotted(&self, word: &Word) -> String {
        let tokens = self.source.tokens.as_slice();
        let names = std::iter::once(&word.token).chain(&word.fields);
        names.filter_map(|token| tokens.get(*token as usize)?.ident()).collect::<Vec<_>>().join(".")
    }

    /// Some value of the type of a declared name. An editor computes the values of constants.
    fn some(&self, token: u32) -> TokenStream {
        match self.types.get(&token).copied().flatten() {
            Some(Type::Float) => code!(0.0),
            Some(Type::Bool) => code!(false),
            Some(Type::Text) => code!(""),
            Some(Type::Floats | Type::Bools | Type::Texts) => code!(&[]),
            None => code!(()),
        }
    }

    /// The documentation of an attribute, which its field also has.
    fn attr_doc(&self, token: u32) -> Option<&str> {
        let name = self.plain(token).filter(|_| self.attrs.contains(&token))?;
        self.fields.iter().find(|field| field.name == name).map(|field| field.doc.as_str())
    }

    /// An attribute, parameter or local value as a name for completion.
    pub(super) fn constant(&self, token: u32) -> TokenStream {
        let Some(name) = self.plain(token) else { return TokenStream::new() };
        let (name, ty, value) = (Ident::new(name, Span::mixed_site()), self.ty(token), self.some(token));
        let doc = self.attr_doc(token).map(|doc| code!(#[doc = #doc]));
        code!(#doc pub const #name: #ty = #value;)
    }

    /// The attributes, the first of each name.
    pub(super) fn attrs(&self) -> impl Iterator<Item = u32> {
        let attrs = self.parts.iter().filter_map(|part| part.name).filter(|token| self.attrs.contains(token));
        attrs.filter(|token| self.plain(*token).is_some_and(|name| self.values.get(name) == Some(token)))
    }
}
