//! Access to the run and to the current shape in generated code.

use cga_lang::ops::{Needs, variant};
use proc_macro2::TokenStream;

use super::hygienic;

/// Where an expression is evaluated: how it gets at the run and at the current shape, both borrowed mutably.
#[derive(Clone)]
pub(super) struct Access {
    pub(super) env: TokenStream,
    pub(super) shape: TokenStream,
    /// True if the shape is slim: an expression that reads more than it has gets the whole shape.
    pub(super) is_slim: bool,
}

impl Access {
    /// In a rule, on the current shape.
    pub(super) fn rule() -> Self {
        Access { env: code!(cx.env), shape: code!((&mut { shape })), is_slim: true }
    }

    /// In a rule, on a part of a split or comp.
    pub(super) fn part() -> Self {
        Access { env: code!(cx.env), shape: code!((&mut { part })), is_slim: true }
    }

    /// In a rule, on the whole of the current shape.
    pub(super) fn whole() -> Self {
        Access { env: code!(cx.env), shape: code!(shape), is_slim: false }
    }

    /// In a value of `comp`, on a component.
    pub(super) fn component() -> Self {
        Access { env: code!(env), shape: code!(part), is_slim: false }
    }

    /// In a selector of `comp`, on the candidate component.
    pub(super) fn candidate() -> Self {
        Access { env: code!(env), shape: code!(candidate.shape()), is_slim: false }
    }

    /// In a function, an attribute or a constant.
    pub(super) fn function() -> Self {
        Access { env: code!(env), shape: code!(shape), is_slim: false }
    }
}

impl Access {
    /// The first arguments of a function of the runtime.
    pub(super) fn needs(&self, needs: Needs) -> TokenStream {
        let (env, shape) = (&self.env, &self.shape);
        match needs {
            Needs::Nothing => TokenStream::new(),
            Needs::Shape => code!(#shape,),
            Needs::Env => code!(#env,),
            Needs::Both => code!(#env, #shape,),
            Needs::Component => code!(candidate,),
        }
    }
}

/// A selector's word, inside a condition.
pub(super) fn asked(word: &str) -> TokenStream {
    let word = hygienic(&variant(word));
    code!(candidate.is(cga_rt::Word::#word))
}
