//! Definitions that several sites share: a file that is imported several times. Each gets the number of its site from its
//! caller.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};

use super::{Generator, hygienic, local};

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
    /// A step that changes the material in the same way in the whole run, or at a site: it depends on
    /// `sites`, `change` is its code, and `function` the function of the runtime that applies it. `is_of_run` is true if it may differ
    /// between runs.
    pub(super) fn change_material(
        &self,
        sites: u32,
        is_of_run: bool,
        function: &str,
        change: TokenStream,
    ) -> TokenStream {
        let changes = &mut *self.material_changes.borrow_mut();
        let next = changes.next;
        // Equal steps are one.
        let number = changes.known.entry((change.to_string(), sites)).or_insert((next, change)).0;
        if number == next {
            changes.next += sites.max(1);
        }
        let (name, number) = (local("material_", number as usize), Literal::u32_unsuffixed(number));
        let function = hygienic(function);
        let (number, values) = match sites {
            0 => (code!(#number), code!(g)),
            _ => (code!(#number + site), code!(&(g, site))),
        };
        let kind = hygienic(if is_of_run { "of_run" } else { "lasting" });
        let place = code!(cga_rt::ChangePlace::#kind(#number));
        code! {
            let mut own = ::core::option::Option::None;
            let shape = cga_rt::slim::#function(cx.env, shape, &bases, &mut own, #place, #values, CgaValues::#name);
        }
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
