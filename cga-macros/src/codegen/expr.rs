//! Expressions. What needs the current shape gets it mutably, because random draws use up its numbers; arguments are
//! evaluated first and one by one, so that the borrows never overlap.

use cga_lang::ir::{Binary, EachUnary, Expr, ExprKind, Global, Type, Value};
use cga_lang::ops::{Function, Param, ParamKind, Words};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::access::{Access, asked};
use super::public::captured;
use super::types::{self, cloned, value};
use super::{Generator, local, site};
use crate::output::{HostType, conversion, convert};

impl Generator<'_> {
    /// An expression in a rule, on a slim shape. It gets the whole shape if it reads more than the slim one has.
    pub(super) fn asked(&self, expr: &Expr, at: &Access) -> TokenStream {
        if !self.facts.expr(expr).whole {
            return self.expr(expr, at);
        }
        let (place, env, slim, code) = (Span::mixed_site(), &at.env, &at.shape, self.expr(expr, &Access::whole()));
        quote_spanned! { place=> {
            let slim = #slim;
            let mut whole = #env.whole(slim);
            let value = {
                let shape = &mut whole;
                #code
            };
            slim.drawn(&whole);
            value
        } }
    }

    pub(super) fn expr(&self, expr: &Expr, at: &Access) -> TokenStream {
        let place = Span::mixed_site();
        match &expr.kind {
            ExprKind::Value(known) => value(known),
            ExprKind::Param(number) => {
                let name = local("p", *number as usize);
                cloned(expr.ty, quote_spanned!(place=> #name))
            }
            ExprKind::Global(id) => match self.grammar.global(*id) {
                Global { attr: None, known: Some(known), .. } => value(known),
                _ => self.global(*id, at),
            },
            ExprKind::Host(id) if self.captured => {
                let name = captured(id.0 as usize);
                cloned(self.hosts[id.0 as usize].inside(), quote_spanned!(place=> g.#name))
            }
            ExprKind::Host(id) => {
                let host = &self.grammar.hosts[id.0 as usize];
                let ty = self.hosts[id.0 as usize];
                convert(&quote_spanned!(place=> cga_rt), ty, &self.source.hosts()[host.handle as usize])
            }
            ExprKind::Call(id, sites, args) => {
                let name = self.names.function(*id, self.source.token(expr.span.first));
                let (env, shape, site) = (&at.env, &at.shape, site::passed(sites));
                let site = site.map(|site| quote_spanned!(place=> #site,));
                let call =
                    |args: &[TokenStream]| quote_spanned!(place=> CgaRules::#name(g, #env, #shape, #site #(#args),*));
                self.with_args(args, at, call)
            }
            ExprKind::Builtin(function, args) => {
                let name = Ident::new(function.run.now().unwrap_or(function.name), place);
                let needs = at.needs(function.needs);
                let call = |args: &[TokenStream]| {
                    // Words are part of the call.
                    let mut values = args.iter();
                    let args = function.params.iter().zip(words(function, expr)).map(|(param, word)| match word {
                        Some(word) => word_variant(&param.kind, word, &quote_spanned!(place=> func::)),
                        None => values.next().cloned().unwrap_or_default(),
                    });
                    quote_spanned!(place=> cga_rt::func::#name(#needs #(#args),*))
                };
                let values = args.iter().zip(words(function, expr)).filter(|(_, word)| word.is_none());
                self.with_args(values.map(|(arg, _)| arg), at, call)
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
            ExprKind::Comp(comp) => self.comp_value(comp, at),
            ExprKind::Word(word) => asked(word),
            ExprKind::Style(styles) => is_one_of(styles, &quote_spanned!(place=> g.style)),
            ExprKind::Site(sites) => is_one_of(sites, &quote_spanned!(place=> site)),
            ExprKind::Later(what) => {
                let (later, env) = (types::later(expr.ty), &at.env);
                quote_spanned!(place=> cga_rt::later::#later(#env, #what))
            }
            ExprKind::Array(rows) => self.array(rows, at),
            ExprKind::Range(base, step, limit) => {
                let env = &at.env;
                let call = |args: &[TokenStream]| quote_spanned!(place=> cga_rt::func::range_by(#env, #(#args),*));
                self.with_args([&**base, &**step, &**limit], at, call)
            }
            ExprKind::Index(array, indices) => {
                let many = indices.iter().any(|index| index.ty.is_array());
                let name = match (indices.len(), many) {
                    (1, false) => "element",
                    (1, true) => "elements",
                    (_, false) => "element_at",
                    (_, true) => "elements_at",
                };
                let (name, env) = (Ident::new(name, place), &at.env);
                let call = |args: &[TokenStream]| quote_spanned!(place=> cga_rt::func::#name(#env, #(#args),*));
                self.with_args([&**array].into_iter().chain(indices), at, call)
            }
            ExprKind::EachUnary(operator, inner) => {
                let name = match operator {
                    EachUnary::Neg => quote_spanned!(place=> each_minus),
                    EachUnary::Not => quote_spanned!(place=> each_not),
                };
                let inner = self.expr(inner, at);
                quote_spanned!(place=> cga_rt::func::#name(#inner))
            }
            ExprKind::Each(operator, left, right) => {
                let (name, env) = (Ident::new(each(*operator), place), &at.env);
                let call = |args: &[TokenStream]| quote_spanned!(place=> cga_rt::func::#name(#env, #(#args),*));
                self.with_args([&**left, &**right], at, call)
            }
            ExprKind::Neg(inner) => {
                let inner = self.expr(inner, at);
                quote_spanned!(place=> (-(#inner)))
            }
            ExprKind::Not(inner) => {
                let inner = self.expr(inner, at);
                quote_spanned!(place=> (!(#inner)))
            }
            ExprKind::Binary(operator @ (Binary::Lt | Binary::Le), left, right) if left.ty == Type::Float => {
                // NaN is less than anything; see `func::compare`.
                let (left, right) = (self.expr(left, at), self.expr(right, at));
                let opposite = operator_of(if *operator == Binary::Lt { Binary::Ge } else { Binary::Gt });
                quote_spanned!(place=> (!(#left #opposite #right)))
            }
            ExprKind::Binary(operator, left, right) if left.ty.is_array() => {
                let name = Ident::new(compare(*operator), place);
                let call = |args: &[TokenStream]| quote_spanned!(place=> cga_rt::func::#name(#(#args),*));
                self.with_args([&**left, &**right], at, call)
            }
            ExprKind::Binary(operator, left, right) => match operator_of(*operator) {
                Some(operator) => {
                    let (left, right) = (self.expr(left, at), self.expr(right, at));
                    quote_spanned!(place=> (#left #operator #right))
                }
                None => {
                    let env = &at.env;
                    let concat = |args: &[TokenStream]| quote_spanned!(place=> cga_rt::func::concat(#env, #(#args),*));
                    self.with_args([&**left, &**right], at, concat)
                }
            },
            ExprKind::File(name, folder) => {
                let name = self.expr(name, at);
                quote_spanned!(place=> cga_rt::File::new(#name, #folder))
            }
            // It came in as text.
            ExprKind::ToText(inner) if matches!(inner.kind, ExprKind::Host(_)) => self.expr(inner, at),
            // Long arrays end the run.
            ExprKind::ToText(inner) if inner.ty.is_array() => {
                let env = &at.env;
                let call = |args: &[TokenStream]| quote_spanned!(place=> cga_rt::func::array_to_text(#env, #(#args),*));
                self.with_args([&**inner], at, call)
            }
            ExprKind::ToText(inner) => {
                let convert = types::function(inner.ty, "to_text");
                let inner = self.expr(inner, at);
                quote_spanned!(place=> cga_rt::func::#convert(#inner))
            }
            ExprKind::Case(arms, otherwise) if are_styles(arms) => {
                self.by_number(&quote_spanned!(place=> g.style), arms, otherwise, at)
            }
            ExprKind::Case(arms, otherwise) if are_sites(arms) => {
                self.by_number(&quote_spanned!(place=> site), arms, otherwise, at)
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

    /// The value of the style or of the site.
    fn by_number(&self, number: &TokenStream, arms: &[(Expr, Expr)], otherwise: &Expr, at: &Access) -> TokenStream {
        let place = Span::mixed_site();
        let arms = arms.iter().map(|(test, value)| {
            let (ExprKind::Style(list) | ExprKind::Site(list)) = &test.kind else { return TokenStream::new() };
            let (list, value) = (numbers(list), self.expr(value, at));
            quote_spanned!(place=> #(#list)|* => #value,)
        });
        let otherwise = self.expr(otherwise, at);
        quote_spanned!(place=> (match #number { #(#arms)* _ => #otherwise }))
    }

    /// The name of an image, as text.
    pub(super) fn image(&self, expr: &Expr, at: &Access) -> TokenStream {
        let (place, env) = (Span::mixed_site(), &at.env);
        match &expr.kind {
            // Nothing is looked for.
            ExprKind::File(name, folder) if folder.is_empty() => self.expr(name, at),
            ExprKind::File(..) => {
                let file = self.expr(expr, at);
                quote_spanned!(place=> { let file = #file; cga_rt::image(#env, file) })
            }
            _ => self.expr(expr, at),
        }
    }

    /// `[a, b; c, d]`.
    fn array(&self, rows: &[Vec<Expr>], at: &Access) -> TokenStream {
        let (place, env) = (Span::mixed_site(), &at.env);
        let call = |args: &[TokenStream]| {
            let mut args = args.iter();
            let rows = rows.iter().map(|row| {
                let parts = args.by_ref().take(row.len());
                quote_spanned!(place=> &[#(cga_rt::func::ArrayPart::from(#parts)),*])
            });
            quote_spanned!(place=> cga_rt::func::array(#env, &[#(#rows),*]))
        };
        self.with_args(rows.iter().flatten(), at, call)
    }

    /// Arguments first, one by one, then the call.
    pub(super) fn with_args<'e>(
        &self,
        args: impl IntoIterator<Item = &'e Expr> + Clone,
        at: &Access,
        call: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let place = Span::mixed_site();
        let values: Vec<TokenStream> = args.clone().into_iter().map(|arg| self.expr(arg, at)).collect();
        if args.into_iter().all(|arg| self.is_plain(arg)) {
            return call(&values);
        }
        let names: Vec<TokenStream> =
            (0..values.len()).map(|number| local("a", number)).map(|name| quote!(#name)).collect();
        let call = call(&names);
        quote_spanned!(place=> { #(let #names = #values;)* #call })
    }

    /// Returns true if an argument needs neither the shape nor the run.
    fn is_plain(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Value(_) | ExprKind::Param(_) => true,
            ExprKind::Global(id) => self.grammar.global(*id).attr.is_none() && !self.is_lazy(*id),
            ExprKind::Neg(inner) | ExprKind::Not(inner) | ExprKind::File(inner, _) => self.is_plain(inner),
            ExprKind::Binary(Binary::Concat, ..) => false,
            ExprKind::Binary(_, left, right) => self.is_plain(left) && self.is_plain(right),
            _ => false,
        }
    }

    /// The span of a call of Rust, where rustc shows a wrong signature: the last name of the path.
    pub(super) fn at_path(&self, span: cga_lang::span::Span) -> Span {
        let path = cga_lang::span::Span::one(span.first);
        Span::mixed_site().located_at(self.source.span(path).1)
    }

    /// The arguments of a Rust function of the user: text arrives as `&str`, and each argument keeps its span.
    pub(super) fn with_rust_args(
        &self,
        args: &[Expr],
        at: &Access,
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
                    ty if ty.is_array() => quote_spanned!(here=> &#name),
                    _ => quote!(#name),
                }
            })
            .collect();
        let call = call(&passed);
        quote_spanned!(place=> { #(let #names = #values;)* #call })
    }
}

/// Returns true if a `case` chooses by style alone.
fn are_styles(arms: &[(Expr, Expr)]) -> bool {
    !arms.is_empty() && arms.iter().all(|(test, _)| matches!(test.kind, ExprKind::Style(_)))
}

/// Returns true if a `case` chooses by site alone.
fn are_sites(arms: &[(Expr, Expr)]) -> bool {
    !arms.is_empty() && arms.iter().all(|(test, _)| matches!(test.kind, ExprKind::Site(_)))
}

fn numbers(list: &[u32]) -> impl Iterator<Item = Literal> {
    list.iter().map(|number| Literal::u32_suffixed(*number))
}

/// Returns true if a style or site is in a list.
pub(super) fn is_one_of(list: &[u32], number: &TokenStream) -> TokenStream {
    let list = numbers(list);
    quote_spanned!(Span::mixed_site()=> ::core::matches!(#number, #(#list)|*))
}

/// The conditions of a stochastic block.
pub(super) fn draws(percents: impl Iterator<Item = f64>, at: &Access) -> Vec<TokenStream> {
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

/// The words among the arguments of a call.
fn words<'e>(function: &'static Function, call: &'e Expr) -> Vec<Option<&'e str>> {
    let ExprKind::Builtin(_, args) = &call.kind else { return Vec::new() };
    let word = |(param, arg): (&Param, &'e Expr)| match (&param.kind, &arg.kind) {
        (ParamKind::Word(_), ExprKind::Value(Value::Text(word))) => Some(word.as_str()),
        _ => None,
    };
    function.params.iter().zip(args).map(word).collect()
}

/// A word as the runtime's enum has it.
pub(super) fn word_variant(kind: &ParamKind, word: &str, module: &TokenStream) -> TokenStream {
    let ParamKind::Word(words @ Words { rust: Some(rust), .. }) = kind else { return TokenStream::new() };
    let place = Span::mixed_site();
    let (rust, variant) = (Ident::new(rust, place), Ident::new(&words.variant(word), place));
    quote_spanned!(place=> cga_rt::#module #rust::#variant)
}

/// The function of an operator that goes over elements.
fn each(operator: Binary) -> &'static str {
    match operator {
        Binary::Add => "each_add",
        Binary::Sub => "each_subtract",
        Binary::Mul => "each_multiply",
        Binary::Div => "each_divide",
        Binary::Rem => "each_remainder",
        Binary::Concat => "each_concat",
        Binary::Eq => "each_equal",
        Binary::Ne => "each_unequal",
        Binary::Lt => "each_less",
        Binary::Le => "each_less_equal",
        Binary::Gt => "each_greater",
        Binary::Ge => "each_greater_equal",
        Binary::And => "each_and",
        Binary::Or => "each_or",
    }
}

/// The function that compares two arrays.
fn compare(operator: Binary) -> &'static str {
    match operator {
        Binary::Ne => "unequal",
        Binary::Lt => "less",
        Binary::Le => "less_equal",
        Binary::Gt => "greater",
        Binary::Ge => "greater_equal",
        _ => "equal",
    }
}

/// Rust's operator. Text has none: making it can end the run.
fn operator_of(operator: Binary) -> Option<TokenStream> {
    let place = Span::mixed_site();
    Some(match operator {
        Binary::Add => quote_spanned!(place=> +),
        Binary::Sub => quote_spanned!(place=> -),
        Binary::Mul => quote_spanned!(place=> *),
        Binary::Div => quote_spanned!(place=> /),
        Binary::Rem => quote_spanned!(place=> %),
        Binary::Concat => return None,
        Binary::Eq => quote_spanned!(place=> ==),
        Binary::Ne => quote_spanned!(place=> !=),
        Binary::Lt => quote_spanned!(place=> <),
        Binary::Le => quote_spanned!(place=> <=),
        Binary::Gt => quote_spanned!(place=> >),
        Binary::Ge => quote_spanned!(place=> >=),
        // Both sides are always evaluated.
        Binary::And => quote_spanned!(place=> &),
        Binary::Or => quote_spanned!(place=> |),
    })
}
