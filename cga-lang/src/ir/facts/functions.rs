//! Uses of functions, attributes and constants.

use super::closure::closure;
use super::{Facts, Uses};
use crate::ir::{Grammar, walk};

impl Facts {
    /// Finds uses of functions, and of reading attributes and constants. These are values of the run, lazy ones too: they are
    /// computed before the first rule. The shape that reads them only counts where shapes may hold values of their own.
    pub(super) fn find_functions(&mut self, grammar: &Grammar) {
        let held = |is_held: bool| if is_held { Uses::STATE } else { Uses::NONE };
        self.globals = grammar.globals.iter().map(|it| held(it.is_set)).collect();
        // Until they are known, calls add nothing.
        self.functions = vec![Uses::NONE; grammar.functions.len()];
        let own = grammar.functions.iter().map(|function| {
            // The run counts the calls of recursive functions.
            let counted = if function.recursive { Uses::SAYS } else { Uses::NONE };
            self.exprs(function.locals.iter().chain([&function.body])) | counted
        });
        let own: Vec<Uses> = own.collect();
        let calls: Vec<Vec<usize>> = grammar.functions.iter().map(walk::called_functions).collect();
        self.functions = closure(&calls, &own);
    }
}
