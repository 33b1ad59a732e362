//! Attributes and constants on a cycle that conditions may keep open: a field of the run's values that is filled by a function
//! when it is first read.

use cga_lang::ir::{Global, GlobalId};
use proc_macro2::{Ident, Literal, TokenStream};

use super::access::Access;
use super::fields::AttrField;
use super::{Generator, hygienic, inner_type, local};

impl Generator<'_> {
    /// Returns true if it is computed on its first read.
    pub(super) fn is_lazy(&self, id: GlobalId) -> bool {
        self.grammar.global(id).lazy
    }

    pub(super) fn has_lazy(&self) -> bool {
        self.grammar.globals.iter().any(|global| global.lazy)
    }

    /// Returns true if a renewal has lazy values.
    pub(super) fn renews_lazy(&self) -> bool {
        self.grammar.renewals.iter().flat_map(|renewal| &renewal.globals).any(|global| self.is_lazy(*global))
    }

    /// The field and the function of an attribute or constant.
    pub(super) fn global_name(&self, GlobalId(number): GlobalId) -> Ident {
        match number.checked_sub(self.attrs) {
            None => local("attr_", number as usize),
            Some(number) => local("const_", number as usize),
        }
    }

    /// One function for each, which computes it when it is first read.
    pub(super) fn lazy_functions(&self) -> TokenStream {
        let globals = self.grammar.globals.iter().zip(0..).filter(|(global, _)| global.lazy);
        globals
            .map(|(global @ Global { name, value, ty, .. }, id)| {
                let (function, ty, number) =
                    (self.global_name(GlobalId(id)), inner_type(*ty), Literal::u32_suffixed(global.stream()));
                let stack = Literal::u32_unsuffixed(self.plan.lazy_stack(GlobalId(id)));
                let code = self.expr(value, &Access::function());
                let doc = format!("`{name}`, which may need itself: computed when it is first read.");
                code! {
                    #[doc = #doc]
                    fn #function(g: &CgaValues, env: &mut cga_rt::Env) -> #ty {
                        g.#function.get(env, cga_rt::Text::fixed(#name), #stack, |env| {
                            let shape = &mut g.origin.global(#number);
                            #code
                        })
                    }
                }
            })
            .collect()
    }

    /// Reads one of them.
    pub(super) fn lazy_value(&self, global: GlobalId, g: &TokenStream, env: &TokenStream) -> TokenStream {
        let name = self.global_name(global);
        code!(CgaValues::#name(#g, #env))
    }

    /// The value before any is computed: the one that the host program gave, if it did.
    pub(super) fn lazy_given(&self, global: GlobalId, field: &AttrField<'_>) -> TokenStream {
        let (name, value) = (self.global_name(global), field.value());
        let state = hygienic(if field.known.is_some() { "known" } else { "given" });
        code!(g.#name = cga_rt::Lazy::#state(#value);)
    }
}
