//! Attributes and constants that shapes hold: values that some rule sets, and values that a renewal of an import computes again.

use std::collections::{BTreeSet, HashMap, HashSet};

use cga_lang::ir::{ExprKind, Global, GlobalId, Grammar, Renew, Type};
use proc_macro2::{Ident, Literal, TokenStream};

use super::access::Access;
use super::fields::AttrField;
use super::types::{self, cloned};
use super::{Generator, inner_type, local};

/// The largest number of attributes and constants that one function computes again.
const PIECE: usize = 32;

impl Generator<'_> {
    /// The value of an attribute or constant of the run. If rules may set it, the shape's own value comes first.
    pub(super) fn global(&self, id: GlobalId, at: &Access) -> TokenStream {
        let (name, global) = (self.global_name(id), self.grammar.global(id));
        let g = code!(g);
        let held = if global.lazy { self.lazy_value(id, &g, &at.env) } else { code!(g.#name) };
        match (global.is_set, global.lazy) {
            (true, _) => self.of_shape(id, &at.shape, &held),
            (false, true) => held,
            (false, false) => cloned(global.ty, held),
        }
    }

    /// The value that a shape has of its own, else the one given.
    fn of_shape(&self, global: GlobalId, shape: &TokenStream, held: &TokenStream) -> TokenStream {
        let ty = self.grammar.global(global).ty;
        let (number, get) = (number(global), types::function(ty, "attribute"));
        match ty {
            Type::Float | Type::Bool => code!(cga_rt::get::#get(#shape, #number, #held)),
            _ => code!(cga_rt::get::#get(#shape, #number, &#held)),
        }
    }

    /// Gives the current shape a value of its own, from the local `value`.
    pub(super) fn set(&self, global: GlobalId, ty: Type, value: &Ident) -> TokenStream {
        let (number, kind) = (number(global), types::variant(ty));
        code!(cga_rt::set::attribute(shape, #number, cga_rt::Value::#kind(#value));)
    }

    /// The given values, and the copy on which all others are computed again.
    pub(super) fn renew(&self, call: &Renew, number: &Literal) -> (TokenStream, TokenStream) {
        let at = Access::rule();
        let names: Vec<Ident> = (0..call.given.len()).map(|number| local("given_", number)).collect();
        let values = call.given.iter().map(|(_, value)| self.expr(value, &at));
        let given = code!(#(let #names = #values;)*);
        let set = call.given.iter().zip(&names).map(|((id, value), name)| self.set(*id, value.ty, name));
        let mut ids: Vec<GlobalId> = call.given.iter().map(|(id, _)| *id).collect();
        ids.sort_unstable();
        let numbers = ids.into_iter().map(|id| Literal::u32_suffixed(id.0));
        let renew = local("renew_", call.renewal.0 as usize);
        (
            given,
            code! {
                let mut whole = cx.env.whole(&cga_rt::push(shape, #number));
                {
                    let shape = &mut whole;
                    #(#set)*
                    CgaValues::#renew(g, cx.env, shape, &[#(#numbers),*]);
                }
                let renewed = cx.env.base(whole);
                let shape = &renewed.shape();
            },
        )
    }

    /// One function for each renewal: it sets all values except the given ones, on the copy.
    pub(super) fn renewals(&self) -> TokenStream {
        self.grammar
            .renewals
            .iter()
            .enumerate()
            .map(|(number, renewal)| {
                let name = local("renew_", number);
                // In pieces, because compilers take long over long functions, and without optimisation they take much of
                // the stack.
                let steps: Vec<TokenStream> = renewal
                    .globals
                    .chunk_by(|a, b| self.is_lazy(*a) && self.is_lazy(*b))
                    .map(|globals| match globals {
                        [global] if !self.is_lazy(*global) => self.renewed_global(*global),
                        _ => self.renewed_lazy(globals),
                    })
                    .collect();
                let pieces = steps.chunks(PIECE).enumerate().map(|(piece, steps)| {
                    let name = local(&format!("renew_{number}_"), piece);
                    code! {
                        fn #name(
                            g: &CgaValues,
                            env: &mut cga_rt::Env,
                            shape: &mut cga_rt::Shape,
                            given: &[::core::primitive::u32],
                        ) {
                            #(#steps)*
                        }
                    }
                });
                let names = (0..steps.len().div_ceil(PIECE)).map(|piece| local(&format!("renew_{number}_"), piece));
                code! {
                    fn #name(
                        g: &CgaValues,
                        env: &mut cga_rt::Env,
                        shape: &mut cga_rt::Shape,
                        given: &[::core::primitive::u32],
                    ) {
                        #(CgaValues::#names(g, env, shape, given);)*
                    }
                    #(#pieces)*
                }
            })
            .collect()
    }

    /// Computes one attribute or constant again. The numbers in `given` are sorted; constants cannot be given.
    fn renewed_global(&self, id: GlobalId) -> TokenStream {
        let (global, number) = (self.grammar.global(id), number(id));
        let value = &local("value_", 0);
        let (code, set) = (self.renewed_value(global), self.set(id, global.value.ty, value));
        match global.attr {
            Some(_) => code!(if !given.binary_search(&#number).is_ok() { let #value = #code; #set }),
            None => code!(let #value = #code; #set),
        }
    }

    /// Computes lazy attributes and constants again, on a copy of the run's values in which they are open.
    fn renewed_lazy(&self, globals: &[GlobalId]) -> TokenStream {
        let mut numbers: Vec<u32> = globals.iter().map(|id| id.0).collect();
        numbers.sort_unstable();
        let numbers = numbers.into_iter().map(Literal::u32_suffixed);
        let open = globals.iter().map(|&id| {
            let (name, global, number) = (self.global_name(id), self.grammar.global(id), number(id));
            let none = code!(::core::default::Default::default());
            if global.attr.is_none() {
                return code!(own.#name = #none;);
            }
            let given = self.of_shape(id, &code!(shape), &none);
            let host = self.renewed.binary_search(&global.name).ok().map_or(none, |field| {
                let field = local("field_", field);
                code!(cga_rt::Lazy::given(::core::clone::Clone::clone(&g.#field)))
            });
            code! {
                own.#name = if given.binary_search(&#number).is_ok() { cga_rt::Lazy::known(#given) } else { #host };
            }
        });
        let set = globals.iter().map(|&id| {
            let value = local("value_", 0);
            let computed = self.lazy_value(id, &code!(&own), &code!(env));
            let set = self.set(id, self.grammar.global(id).ty, &value);
            code!(let #value = #computed; #set)
        });
        code! {
            let mut own = ::core::clone::Clone::clone(g);
            own.origin = cga_rt::Origin::renewed(shape, &[#(#numbers),*]);
            #(#open)*
            #(#set)*
        }
    }

    /// The renewed value of an attribute or constant: the one from the host program, else it is computed, with random
    /// numbers of its own.
    fn renewed_value(&self, global: &Global) -> TokenStream {
        let code = self.expr(&global.value, &Access::function());
        let code = match global.value.kind {
            ExprKind::Value(_) => code,
            _ => {
                let number = Literal::u32_suffixed(global.stream());
                code!(cga_rt::renew(shape, #number, |shape| #code))
            }
        };
        let field = self.renewed.binary_search(&global.name).ok().filter(|_| global.attr.is_some());
        let Some(field) = field else { return code };
        let field = local("field_", field);
        let (held, given) = match global.ty {
            Type::Float | Type::Bool => (code!(g.#field), code!(given)),
            _ => (code!(&g.#field), code!(::core::clone::Clone::clone(given))),
        };
        code! {
            match #held {
                ::core::option::Option::Some(given) => #given,
                ::core::option::Option::None => #code,
            }
        }
    }

    /// The values that the host program gave to attributes of renewals: names and types of values of the run.
    pub(super) fn held_fields(&self) -> Vec<(Ident, TokenStream)> {
        let attrs = self.grammar.globals.iter().filter(|global| global.attr.is_some());
        let types: HashMap<&String, Type> = attrs.map(|attr| (&attr.name, attr.ty)).collect();
        let held = self.renewed.iter().enumerate().filter_map(|(number, name)| Some((number, *types.get(name)?)));
        held.map(|(number, ty)| {
            let ty = inner_type(ty);
            (local("field_", number), code!(::core::option::Option<#ty>))
        })
        .collect()
    }

    /// Fills them.
    pub(super) fn hold_fields(&self, fields: &HashMap<&str, &AttrField<'_>>) -> TokenStream {
        let held = self.renewed.iter().enumerate().filter_map(|(number, name)| {
            let (own, field) = (local("field_", number), fields.get(name.as_str())?);
            let value = field.value();
            Some(match field.known {
                Some(_) => code!(g.#own = ::core::option::Option::Some(#value);),
                None => code!(g.#own = #value;),
            })
        });
        held.collect()
    }
}

/// The names of attributes of renewals that have a field.
pub(super) fn renewed(grammar: &Grammar) -> Vec<String> {
    let globals = grammar.renewals.iter().flat_map(|renewal| &renewal.globals).map(|id| grammar.global(*id));
    let names: BTreeSet<&String> = globals.filter(|global| global.attr.is_some()).map(|global| &global.name).collect();
    let public: HashSet<&String> =
        grammar.globals.iter().filter(|global| global.public).map(|global| &global.name).collect();
    names.into_iter().filter(|name| public.contains(name)).cloned().collect()
}

/// The number of an attribute or constant in a shape.
fn number(id: GlobalId) -> Literal {
    Literal::u32_suffixed(id.0)
}
