//! Definitions that several sites share: a file that is imported several times. Each gets the number of its site from its
//! caller.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};

use cga_lang::ir::Type;
use cga_lang::ir::plan::MaterialChange;

use super::{Generator, hygienic, local, types};

/// Changes of the material that are the same in the whole run, or at a site.
#[derive(Default)]
pub(super) struct MaterialChanges {
    /// By text and count of sites: the first number and the function.
    known: HashMap<(String, u32), (u32, TokenStream)>,
    /// The next number.
    next: u32,
}

/// The parameter of a definition with `count` sites, if it is shared.
pub(super) fn param(count: usize) -> Option<(Ident, TokenStream)> {
    (0 < count).then(|| (hygienic("site"), code!(::core::primitive::u32)))
}

/// The site that a call passes on, if the called definition is shared.
pub(super) fn passed(sites: &[u32]) -> Option<TokenStream> {
    (!sites.is_empty()).then(|| of_site(sites))
}

/// The number of the site.
pub(super) fn of_site(numbers: &[u32]) -> TokenStream {
    let literal = |number: &u32| Literal::u32_suffixed(*number);
    let first = numbers.first().copied().unwrap_or_default();
    let value = literal(&first);
    if numbers.iter().all(|number| *number == first) {
        return code!(#value);
    }
    if numbers.iter().zip(first..).all(|(number, next)| *number == next) {
        return if first == 0 { code!(site) } else { code!(#value + site) };
    }
    let values = numbers.iter().map(literal);
    code!([#(#values),*][site as ::core::primitive::usize])
}

impl Generator<'_> {
    /// Steps that change the material in the same way in the whole run, or at a site, or for equal parameters. `code` is their code.
    pub(super) fn change_material(&self, change: &MaterialChange, code: TokenStream) -> TokenStream {
        let MaterialChange { sites, is_of_run, reaches_caps, params, .. } = change;
        let (number, code) = match params.is_empty() {
            true => self.shared_change(*sites, code),
            false => (self.change_number(*sites), code!({ let cx = cga_rt::MaterialCx { env }; #code })),
        };
        let number = Literal::u32_unsuffixed(number);
        let number = if *sites == 0 { code!(#number) } else { code!(#number + site) };
        let function = hygienic(if *reaches_caps { "change_coordinates" } else { "change_material" });
        let kind = hygienic(if *is_of_run { "of_run" } else { "lasting" });
        let place = code!(cga_rt::ChangePlace::#kind(#number));
        let reads = params.iter().map(|(number, ty)| {
            let (variant, name) = (types::variant(*ty), self.param(*number as usize));
            let value = if matches!(ty, Type::Float | Type::Bool) { code!(#name) } else { code!(&#name) };
            code!(cga_rt::Read::#variant(#value))
        });
        code! {
            let mut own = ::core::option::Option::None;
            let shape = cga_rt::slim::#function(
                cx.env,
                shape,
                &bases,
                &mut own,
                #place,
                &[#(#reads),*],
                &|env, shape| #code,
            );
        }
    }

    /// The number of a change without parameters, and a call of its function. Equal ones have one.
    fn shared_change(&self, sites: u32, change: TokenStream) -> (u32, TokenStream) {
        let key = (change.to_string(), sites);
        let known = self.material_changes.borrow().known.get(&key).map(|(number, _)| *number);
        let number = known.unwrap_or_else(|| {
            let number = self.change_number(sites);
            self.material_changes.borrow_mut().known.insert(key, (number, change));
            number
        });
        let (name, values) =
            (local("material_", number as usize), if sites == 0 { code!(g) } else { code!(&(g, site)) });
        (number, code!(CgaValues::#name(#values, env, shape)))
    }

    /// The first number of a change that depends on `sites`.
    fn change_number(&self, sites: u32) -> u32 {
        let next = &mut self.material_changes.borrow_mut().next;
        let number = *next;
        *next += sites.max(1);
        number
    }

    /// One function for each such change. The rules come first.
    pub(super) fn material_changes(&self) -> TokenStream {
        let mut changes: Vec<(u32, u32, TokenStream)> = self
            .material_changes
            .take()
            .known
            .into_iter()
            .map(|((_, count), (number, change))| (count, number, change))
            .collect();
        changes.sort_by_key(|(_, number, _)| *number);
        let functions = changes.into_iter().map(|(count, number, change)| {
            let name = local("material_", number as usize);
            let values = match count {
                0 => code!(g: &CgaValues),
                _ => code!(&(g, site): &(&CgaValues, ::core::primitive::u32)),
            };
            // The expressions of the step ask for `cx`.
            code! {
                fn #name(#values, env: &mut cga_rt::Env, shape: &mut cga_rt::Shape) {
                    let cx = cga_rt::MaterialCx { env };
                    #change
                }
            }
        });
        functions.collect()
    }
}
