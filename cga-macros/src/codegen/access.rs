//! Access to the run and to the current shape in generated code.

use cga_lang::ops::{Needs, variant};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

/// Where an expression is evaluated: how it gets at the run and at the current shape, both borrowed mutably.
pub(super) struct Access {
    pub(super) env: TokenStream,
    pub(super) shape: TokenStream,
}

impl Access {
    /// In a rule, on the current shape.
    pub(super) fn rule() -> Self {
        let place = Span::mixed_site();
        Access { env: quote_spanned!(place=> cx.env), shape: quote_spanned!(place=> (&mut { shape })) }
    }

    /// In a rule, on a part of a split or comp.
    pub(super) fn part() -> Self {
        let place = Span::mixed_site();
        Access { env: quote_spanned!(place=> cx.env), shape: quote_spanned!(place=> (&mut { part })) }
    }

    /// In a rule, on the whole of the current shape.
    pub(super) fn whole() -> Self {
        let place = Span::mixed_site();
        Access { env: quote_spanned!(place=> cx.env), shape: quote_spanned!(place=> shape) }
    }

    /// In a value of `comp`, on a component.
    pub(super) fn component() -> Self {
        let place = Span::mixed_site();
        Access { env: quote_spanned!(place=> env), shape: quote_spanned!(place=> part) }
    }

    /// In a selector of `comp`, on the candidate component.
    pub(super) fn candidate() -> Self {
        let place = Span::mixed_site();
        Access { env: quote_spanned!(place=> env), shape: quote_spanned!(place=> candidate.shape()) }
    }

    /// In a function, an attribute or a constant.
    pub(super) fn function() -> Self {
        let place = Span::mixed_site();
        Access { env: quote_spanned!(place=> env), shape: quote_spanned!(place=> shape) }
    }
}

impl Access {
    /// The first arguments of a function of the runtime.
    pub(super) fn needs(&self, needs: Needs) -> TokenStream {
        let (place, env, shape) = (Span::mixed_site(), &self.env, &self.shape);
        match needs {
            Needs::Nothing => TokenStream::new(),
            Needs::Shape => quote_spanned!(place=> #shape,),
            Needs::Env => quote_spanned!(place=> #env,),
            Needs::Both => quote_spanned!(place=> #env, #shape,),
            Needs::Component => quote_spanned!(place=> candidate,),
        }
    }
}

/// A selector's word, inside a condition.
pub(super) fn asked(word: &str) -> TokenStream {
    let place = Span::mixed_site();
    let word = Ident::new(&variant(word), place);
    quote_spanned!(place=> candidate.is(cga_rt::Word::#word))
}
