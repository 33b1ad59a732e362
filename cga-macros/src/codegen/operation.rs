//! Calls of operations that change the current shape.

use cga_lang::ir::{Arg, Prefix};
use cga_lang::ops::{Changes, Operation, ParamKind};
use proc_macro2::{Ident, TokenStream};

use super::access::Access;
use super::expr::word_variant;
use super::split::prefixed;
use super::{Generator, hygienic, local};

impl Generator<'_> {
    /// An operation on the whole shape. The watch is asked before those that have no slim form.
    pub(super) fn operation(&self, operation: &Operation, args: &[Arg]) -> TokenStream {
        let (lets, call) = self.operation_on(operation, args, &Access::whole(), &TokenStream::new());
        let ask = (operation.changes == Changes::Whole).then(|| code!(cx.env.ask()?;));
        let bake = operation.reshapes().then(|| code!(cga_rt::bake(shape);));
        code!({ #lets #ask #bake cga_rt::op::#call; })
    }

    /// The arguments of an operation, and its call without the module. `further` comes after the shape.
    pub(super) fn operation_on(
        &self,
        operation: &Operation,
        args: &[Arg],
        at: &Access,
        further: &TokenStream,
    ) -> (TokenStream, TokenStream) {
        let name = hygienic(operation.run);
        let names: Vec<Ident> = (0..args.len()).map(|number| local("a", number)).collect();
        let values = self.args(operation, args, at, &code!(op::));
        let base = operation.uses_base.then(|| code!(&base,));
        (code!(#(let #names = #values;)*), code!(#name(cx.env, shape, #further #base #(#names),*)))
    }

    /// The values of an operation's arguments. Words are variants of enums in `module`.
    pub(super) fn args(
        &self,
        operation: &Operation,
        args: &[Arg],
        at: &Access,
        module: &TokenStream,
    ) -> Vec<TokenStream> {
        let values = args.iter().zip(operation.params).map(|(arg, param)| match (arg, &param.kind) {
            (Arg::Value(value), ParamKind::Length) => {
                let value = self.expr(value, at);
                code!(cga_rt::Length::Absolute(#value))
            }
            (Arg::Value(value), ParamKind::Size) => prefixed(Prefix::Absolute, &self.expr(value, at)),
            (Arg::Value(value), ParamKind::Image(_)) => self.image(value, at),
            (Arg::Value(value), _) => self.expr(value, at),
            (Arg::Length(size), ParamKind::Size) => prefixed(size.prefix, &self.expr(&size.value, at)),
            (Arg::Length(size), _) => {
                let value = self.expr(&size.value, at);
                match size.prefix {
                    Prefix::Relative => code!(cga_rt::Length::Relative(#value)),
                    Prefix::Absolute | Prefix::Floating => code!(cga_rt::Length::Absolute(#value)),
                }
            }
            (Arg::Word(word), kind) => word_variant(kind, word, module),
        });
        values.collect()
    }
}
