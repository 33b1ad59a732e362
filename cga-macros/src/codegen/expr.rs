//! Expressions. What needs the current shape gets it mutably, because random draws use up its numbers; arguments are
//! evaluated first and one by one, so that the borrows never overlap.

use cga_lang::ir::{Binary, Expr, ExprKind, Type, Value};
use cga_lang::ops::Needs;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::public::captured;
use super::types::{self, cloned, value};
use super::{Cx, local};
use crate::header::{HostType, conversion, convert};

/// Where an expression is evaluated: how it gets at the run and at the current shape, both borrowed mutably.
pub(super) struct Place {
    pub(super) env: TokenStream,
    pub(super) shape: TokenStream,
}

impl Place {
    /// In a rule, on the current shape.
    pub(super) fn rule() -> Self {
        let place = Span::mixed_site();
        Place { env: quote_spanned!(place=> &mut cx.env), shape: quote_spanned!(place=> shape) }
    }

    /// In a rule, on a part of a split or comp.
    pub(super) fn part() -> Self {
        let place = Span::mixed_site();
        Place { env: quote_spanned!(place=> &mut cx.env), shape: quote_spanned!(place=> part) }
    }

    /// In a function, an attribute or a constant.
    pub(super) fn function() -> Self {
        let place = Span::mixed_site();
        Place { env: quote_spanned!(place=> env), shape: quote_spanned!(place=> shape) }
    }
}

impl Place {
    /// What a function of the runtime gets before its arguments.
    fn needs(&self, needs: Needs) -> TokenStream {
        let (place, env, shape) = (Span::mixed_site(), &self.env, &self.shape);
        match needs {
            Needs::Nothing => TokenStream::new(),
            Needs::Shape => quote_spanned!(place=> #shape,),
            Needs::Env => quote_spanned!(place=> #env,),
            Needs::Both => quote_spanned!(place=> #env, #shape,),
        }
    }
}

impl Cx<'_> {
    pub(super) fn expr(&self, expr: &Expr, at: &Place) -> TokenStream {
        let place = Span::mixed_site();
        match &expr.kind {
            ExprKind::Value(known) => value(known),
            ExprKind::Param(number) => {
                let name = local("p", *number as usize);
                cloned(expr.ty, quote_spanned!(place=> #name))
            }
            ExprKind::Attr(id) => {
                let (attr, name) = (&self.grammar.attrs[id.0 as usize], local("attr_", id.0 as usize));
                if !attr.is_set {
                    return cloned(attr.ty, quote_spanned!(place=> g.#name));
                }
                let (shape, number) = (&at.shape, Literal::u32_suffixed(id.0));
                let get = types::function(attr.ty, "attribute");
                match attr.ty {
                    Type::Float | Type::Bool => quote_spanned!(place=> cga_rt::get::#get(#shape, #number, g.#name)),
                    _ => quote_spanned!(place=> cga_rt::get::#get(#shape, #number, &g.#name)),
                }
            }
            ExprKind::Const(id) => {
                let constant = &self.grammar.consts[id.0 as usize];
                match &constant.known {
                    Some(known) => value(known),
                    None => {
                        let name = local("const_", id.0 as usize);
                        cloned(constant.ty, quote_spanned!(place=> g.#name))
                    }
                }
            }
            ExprKind::Host(id) if self.captured => {
                let name = captured(id.0 as usize);
                cloned(self.hosts[id.0 as usize].inside(), quote_spanned!(place=> g.#name))
            }
            ExprKind::Host(id) => {
                let host = &self.grammar.hosts[id.0 as usize];
                let ty = self.hosts[id.0 as usize];
                convert(&quote_spanned!(place=> cga_rt), ty, &self.source.hosts()[host.handle as usize])
            }
            ExprKind::Call(id, args) => {
                let name = self.names.function(*id, self.source.token(expr.span.first));
                let (env, shape) = (&at.env, &at.shape);
                self.with_args(args, at, |args| quote_spanned!(place=> CgaRules::#name(g, #env, #shape, #(#args),*)))
            }
            ExprKind::Builtin(function, args) => {
                let name = Ident::new(function.run.now().unwrap_or(function.name), place);
                let needs = at.needs(function.needs);
                self.with_args(args, at, |args| quote_spanned!(place=> cga_rt::func::#name(#needs #(#args),*)))
            }
            ExprKind::Rust(path, args) => {
                let path = self.source.path(expr.span.first, path);
                let here = self.at_path(expr.span);
                let convert = conversion(HostType::Is(expr.ty), here);
                self.with_rust_args(args, at, |args| quote_spanned!(here=> cga_rt::host::#convert(&#path(#(#args),*))))
            }
            ExprKind::Shape(attr) => {
                let (get, needs) = (Ident::new(attr.get.now().unwrap_or(attr.name), place), at.needs(attr.needs));
                quote_spanned!(place=> cga_rt::get::#get(#needs))
            }
            ExprKind::Neg(inner) => {
                let inner = self.expr(inner, at);
                quote_spanned!(place=> (-(#inner)))
            }
            ExprKind::Not(inner) => {
                let inner = self.expr(inner, at);
                quote_spanned!(place=> (!(#inner)))
            }
            ExprKind::Binary(operator, left, right) => {
                let (left, right) = (self.expr(left, at), self.expr(right, at));
                binary(*operator, &left, &right)
            }
            // It came in as text.
            ExprKind::ToText(inner) if matches!(inner.kind, ExprKind::Host(_)) => self.expr(inner, at),
            ExprKind::ToText(inner) => {
                let convert = types::function(inner.ty, "to_text");
                let inner = self.expr(inner, at);
                quote_spanned!(place=> cga_rt::func::#convert(#inner))
            }
            ExprKind::Case(arms, otherwise) => {
                let conditions = arms.iter().map(|(condition, _)| self.expr(condition, at));
                let values = arms.iter().map(|(_, value)| self.expr(value, at));
                let otherwise = self.expr(otherwise, at);
                quote_spanned!(place=> (#(if #conditions { #values } else)* { #otherwise }))
            }
            ExprKind::Chance(arms, otherwise) => {
                let draws = draws(arms.iter().map(|(percent, _)| *percent), at);
                let values = arms.iter().map(|(_, value)| self.expr(value, at));
                let otherwise = self.expr(otherwise, at);
                quote_spanned!(place=> (#(if #draws { #values } else)* { #otherwise }))
            }
        }
    }

    /// Arguments first, one by one, then the call.
    pub(super) fn with_args(
        &self,
        args: &[Expr],
        at: &Place,
        call: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let place = Span::mixed_site();
        let values: Vec<TokenStream> = args.iter().map(|arg| self.expr(arg, at)).collect();
        if args.iter().all(is_plain) {
            return call(&values);
        }
        let names: Vec<TokenStream> =
            (0..args.len()).map(|number| local("a", number)).map(|name| quote!(#name)).collect();
        let call = call(&names);
        quote_spanned!(place=> { #(let #names = #values;)* #call })
    }

    /// Where all of a call of Rust stands, so that a wrong signature is shown there: the last name of the path.
    pub(super) fn at_path(&self, span: cga_lang::span::Span) -> Span {
        let path = cga_lang::span::Span::one(span.first);
        Span::mixed_site().located_at(self.source.span(path).1)
    }

    /// The same for a function of the user: text arrives as `&str`, and each argument stands where it was written.
    pub(super) fn with_rust_args(
        &self,
        args: &[Expr],
        at: &Place,
        call: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let place = Span::mixed_site();
        let values = args.iter().map(|arg| self.expr(arg, at));
        let names: Vec<Ident> = (0..args.len()).map(|number| local("a", number)).collect();
        let passed: Vec<TokenStream> = names
            .iter()
            .zip(args)
            .map(|(name, arg)| {
                let here = place.located_at(self.source.token(arg.span.first));
                let name = Ident::new(&name.to_string(), here);
                match arg.ty {
                    Type::Text => quote_spanned!(here=> cga_rt::host::as_str(&#name)),
                    _ => quote!(#name),
                }
            })
            .collect();
        let call = call(&passed);
        quote_spanned!(place=> { #(let #names = #values;)* #call })
    }
}

/// The conditions of a stochastic block.
pub(super) fn draws(percents: impl Iterator<Item = f64>, at: &Place) -> Vec<TokenStream> {
    let place = Span::mixed_site();
    let shape = &at.shape;
    let mut before = 0.0;
    percents
        .map(|percent| {
            let (share, sum) = (value(&Value::Float(percent)), value(&Value::Float(before)));
            before += percent;
            quote_spanned!(place=> cga_rt::branch(#shape, #share, #sum))
        })
        .collect()
}

/// Whether an argument needs neither the shape nor the run.
fn is_plain(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Value(_) | ExprKind::Param(_) | ExprKind::Const(_) => true,
        ExprKind::Neg(inner) | ExprKind::Not(inner) => is_plain(inner),
        ExprKind::Binary(_, left, right) => is_plain(left) && is_plain(right),
        _ => false,
    }
}

fn binary(operator: Binary, left: &TokenStream, right: &TokenStream) -> TokenStream {
    let place = Span::mixed_site();
    match operator {
        Binary::Add => quote_spanned!(place=> (#left + #right)),
        Binary::Sub => quote_spanned!(place=> (#left - #right)),
        Binary::Mul => quote_spanned!(place=> (#left * #right)),
        Binary::Div => quote_spanned!(place=> (#left / #right)),
        Binary::Rem => quote_spanned!(place=> (#left % #right)),
        Binary::Concat => quote_spanned!(place=> cga_rt::func::concat(#left, #right)),
        Binary::Eq => quote_spanned!(place=> (#left == #right)),
        Binary::Ne => quote_spanned!(place=> (#left != #right)),
        Binary::Lt => quote_spanned!(place=> (#left < #right)),
        Binary::Le => quote_spanned!(place=> (#left <= #right)),
        Binary::Gt => quote_spanned!(place=> (#left > #right)),
        Binary::Ge => quote_spanned!(place=> (#left >= #right)),
        // Both sides are always evaluated.
        Binary::And => quote_spanned!(place=> (#left & #right)),
        Binary::Or => quote_spanned!(place=> (#left | #right)),
    }
}
