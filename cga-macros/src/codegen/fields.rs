//! The attributes as fields of the public struct: one for each name, whatever the style.

use std::collections::HashMap;

use cga_lang::ir::{AttrInfo, Global, Grammar, Type, Value};
use proc_macro2::{Ident, Literal, TokenStream};

use super::names::{Taken, ident};
use super::types;
use crate::source::Source;

/// A public field.
pub(super) struct AttrField<'g> {
    /// The attribute, as the style `Default` has it.
    pub(super) global: &'g Global,
    /// Its annotations.
    pub(super) attr: &'g AttrInfo,
    /// Its name in Rust.
    pub(super) name: Ident,
    /// The default, when it is the same constant in every style; else the field is an `Option`.
    pub(super) known: Option<&'g Value>,
}

/// The fields of a grammar, in the order of its attributes.
pub(super) fn of<'g>(grammar: &'g Grammar, source: &Source) -> Vec<AttrField<'g>> {
    let (mut taken, mut numbers) = (Taken::default(), HashMap::new());
    let mut fields: Vec<AttrField<'g>> = Vec::new();
    for global in grammar.globals.iter().filter(|global| global.public) {
        let Some(attr) = &global.attr else { continue };
        if let Some(&number) = numbers.get(&global.name) {
            let field: &mut AttrField<'g> = &mut fields[number];
            field.known = field.known.filter(|known| global.known.as_ref() == Some(*known));
            continue;
        }
        numbers.insert(&global.name, fields.len());
        let name = ident(&taken.field(&global.name), source.token(global.span.first));
        fields.push(AttrField { global, attr, name, known: global.known.as_ref() });
    }
    fields
}

/// The fields by the names of their attributes.
pub(super) fn by_name<'f, 'g>(fields: &'f [AttrField<'g>]) -> HashMap<&'g str, &'f AttrField<'g>> {
    fields.iter().map(|field| (field.global.name.as_str(), field)).collect()
}

impl AttrField<'_> {
    /// The value of the field, converted for the rules; an `Option` without a known default.
    pub(super) fn value(&self) -> TokenStream {
        let name = &self.name;
        match self.global.ty {
            Type::Float | Type::Bool => code!(self.#name),
            Type::Text if self.known.is_some() => code!(cga_rt::text(&self.#name)),
            Type::Text => code!(self.#name.as_deref().map(cga_rt::text)),
            _ => code!(::core::clone::Clone::clone(&self.#name)),
        }
    }
}

/// Setting to the default by number, for `dyn Grammar`.
pub(super) fn reset_arms(fields: &[AttrField<'_>]) -> Vec<TokenStream> {
    let arm = |(number, field): (usize, &AttrField<'_>)| {
        let (number, name) = (Literal::usize_unsuffixed(number), &field.name);
        let default = match field.known {
            Some(known @ Value::Text(_)) => types::field(known, &code!(cga_rt)),
            Some(known) => types::value(known),
            None => code!(::core::option::Option::None),
        };
        code!(#number => self.#name = #default,)
    };
    fields.iter().enumerate().map(arm).collect()
}

/// Reading and writing by number, for `dyn Grammar`.
pub(super) fn arms(fields: &[AttrField<'_>]) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let arm = |(number, field): (usize, &AttrField<'_>)| {
        let (number, name) = (Literal::usize_unsuffixed(number), &field.name);
        (
            code!(#number => cga_rt::Field::get(&self.#name),),
            code!(#number => cga_rt::Field::set(&mut self.#name, value),),
        )
    };
    fields.iter().enumerate().map(arm).unzip()
}
