//! Rows as text: `roofHip(angle: float, overhang: float = 0)`.

use crate::ops::{Braces, Default, Function, Operation, Param, ParamKind, SelectorPlaces};
use std::fmt::{Display, Formatter, Result};

/// The signature of a row, or of several rows that differ in types alone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    name: &'static str,
    /// `None` for words that take no parentheses.
    params: Option<Vec<Parameter>>,
    braces: &'static str,
    results: Vec<&'static str>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Parameter {
    name: &'static str,
    kinds: Vec<&'static str>,
    default: String,
}

impl Signature {
    /// A word alone.
    pub(super) fn word(name: &'static str) -> Self {
        Signature { name, params: None, braces: "", results: Vec::new() }
    }

    /// An operation with its parameters and braces.
    pub(super) fn operation(row: &Operation) -> Self {
        let braces = match row.braces {
            Braces::None => "",
            Braces::Slots(_) => " { size : operations | … }",
            Braces::Sections => " { length : depth : operations | … } { remainder : operations }",
            Braces::Arms(_) | Braces::Components | Braces::Modified => " { selector : operations | … }",
            Braces::Operands => " { operations | operations }",
            Braces::Ops | Braces::Inline => " { operations }",
        };
        // Operations with operands alone have no parentheses.
        let params = (row.braces == Braces::None || !row.params.is_empty()).then(|| params(row.params));
        Signature { params, braces, ..Signature::word(row.name) }
    }

    /// A function with its parameters and its result.
    pub(super) fn function(row: &Function) -> Self {
        Signature { params: Some(params(row.params)), results: vec![row.ty.word()], ..Signature::word(row.name) }
    }

    /// The names and first kinds of the parameters without a default. `None` without parentheses.
    pub(super) fn required(&self) -> Option<Vec<(&'static str, &'static str)>> {
        let params = self.params.as_ref()?.iter().filter(|param| param.default.is_empty());
        Some(params.map(|param| (param.name, param.kinds.first().copied().unwrap_or("any"))).collect())
    }

    /// The first type of its value.
    pub(super) fn result(&self) -> Option<&'static str> {
        self.results.first().copied()
    }

    /// Adds the types of another row. Returns false if the rows differ in more than types.
    pub(super) fn merge(&mut self, other: &Signature) -> bool {
        let (Some(own), Some(others)) = (&mut self.params, &other.params) else { return false };
        let is_alike = self.braces == other.braces
            && own.len() == others.len()
            && own.iter().zip(others).all(|(own, other)| (own.name, &own.default) == (other.name, &other.default));
        if is_alike {
            for (own, other) in own.iter_mut().zip(others) {
                add(&mut own.kinds, &other.kinds);
            }
            add(&mut self.results, &other.results);
        }
        is_alike
    }
}

fn add(list: &mut Vec<&'static str>, more: &[&'static str]) {
    for word in more {
        if !list.contains(word) {
            list.push(word);
        }
    }
}

impl Display for Signature {
    fn fmt(&self, text: &mut Formatter<'_>) -> Result {
        text.write_str(self.name)?;
        if let Some(params) = &self.params {
            text.write_str("(")?;
            for (index, param) in params.iter().enumerate() {
                text.write_str(if index == 0 { "" } else { ", " })?;
                write!(text, "{}: {}{}", param.name, param.kinds.join(" | "), param.default)?;
            }
            text.write_str(")")?;
        }
        text.write_str(self.braces)?;
        text.write_str(if self.results.is_empty() { "" } else { " → " })?;
        text.write_str(&self.results.join(" | "))
    }
}

fn params(list: &[Param]) -> Vec<Parameter> {
    let default = |param: &Param| match param.default {
        None => String::new(),
        Some(Default::Float(value)) => format!(" = {value}"),
        Some(Default::Bool(value)) => format!(" = {value}"),
        Some(Default::Text(value)) => format!(" = {value:?}"),
        Some(Default::Word(value)) => format!(" = {value}"),
    };
    let row = |param: &Param| Parameter { name: param.name, kinds: vec![kind(&param.kind)], default: default(param) };
    list.iter().map(row).collect()
}

/// The kind of argument, or of value of an attribute of shapes.
pub(super) fn kind(kind: &ParamKind) -> &'static str {
    match kind {
        ParamKind::Value(ty) | ParamKind::Files(ty) => ty.word(),
        ParamKind::Any => "any",
        ParamKind::Length => "length",
        ParamKind::Size => "size",
        ParamKind::Color => "colour",
        ParamKind::Channel => "channel",
        ParamKind::File(_) => "file",
        ParamKind::Image(_) => "image",
        ParamKind::Selector => "selector",
        ParamKind::PerEdge => "float per edge",
        ParamKind::Word(_) => "word",
    }
}

/// The names of a row's parameters that take words, with these words. Old words are left out.
pub(super) fn words(list: &'static [Param]) -> Vec<(&'static str, Vec<&'static str>)> {
    list.iter().filter_map(|param| Some((param.name, param.kind.words()?.current().collect()))).collect()
}

/// The documented values of a row's parameters, in words.
pub(super) fn bounds(list: &'static [Param]) -> Vec<(&'static str, &'static str)> {
    list.iter().filter_map(|param| Some((param.name, param.bounds?.about))).collect()
}

/// The operations that take a selector.
pub(super) fn places(on: SelectorPlaces) -> String {
    const NAMES: [(SelectorPlaces, &str); 11] = [
        (SelectorPlaces::FACES, "`comp(f)`"),
        (SelectorPlaces::EDGES, "`comp(e)`"),
        (SelectorPlaces::FACE_EDGES, "`comp(fe)`"),
        (SelectorPlaces::VERTICES, "`comp(v)`"),
        (SelectorPlaces::FACE_VERTICES, "`comp(fv)`"),
        (SelectorPlaces::GROUPS, "`comp(g)`"),
        (SelectorPlaces::MATERIALS, "`comp(m)`"),
        (SelectorPlaces::HOLES, "`comp(h)`"),
        (SelectorPlaces::SETBACK, "setbacks"),
        (SelectorPlaces::SHAPE, "`shapeL`, `shapeU`, `shapeO`, `innerRectangle`"),
        (SelectorPlaces::PERIMETER, "`splitAndSetbackPerimeter`"),
    ];
    let in_every = on.has(SelectorPlaces::COMP);
    let rest = if in_every { on.but(SelectorPlaces::COMP) } else { on };
    let names = NAMES.iter().filter(|(place, _)| rest.has(*place)).map(|(_, name)| *name);
    in_every.then_some("every `comp`").into_iter().chain(names).collect::<Vec<_>>().join(", ")
}
