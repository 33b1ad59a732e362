//! Expressions. What needs the current shape gets it mutably, because random draws use up its numbers; arguments are
//! evaluated first and one by one, so that the borrows never overlap.

use cga_lang::ir::{Binary, EachUnary, Expr, ExprKind, Global, Type, Value};
use cga_lang::ops::{Function, Param, ParamKind, Words};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{quote, quote_spanned};

use super::access::{Access, asked};
use super::public::captured;
use super::types::{self, cloned, value};
use super::{Generator, hygienic, local, site};
use crate::location;
use crate::output::{HostType, conversion, convert};

impl Generator<'_> {
    /// An expression on a slim shape. It gets the whole shape if it reads more than the slim one has.
    fn on_slim(&self, expr: &Expr, at: &Access) -> TokenStream {
        if !self.plan.needs_whole(expr) {
            return self.value(expr, &Access { is_slim: false, ..at.clone() });
        }
        let (env, slim, code) = (&at.env, &at.shape, self.value(expr, &Access::whole()));
        code! { {
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

    /// An expression.
    pub(super) fn expr(&self, expr: &Expr, at: &Access) -> TokenStream {
        self.at(expr.span, || if at.is_slim { self.on_slim(expr, at) } else { self.value(expr, at) })
    }

    /// An expression at the current location.
    fn value(&self, expr: &Expr, at: &Access) -> TokenStream {
        match &expr.kind {
            ExprKind::Value(known) => value(known),
            ExprKind::Param(number) => {
                let name = self.param(*number as usize);
                cloned(expr.ty, code!(#name))
            }
            ExprKind::Global(id) => match self.grammar.global(*id) {
                Global { attr: None, known: Some(known), .. } => value(known),
                _ => self.global(*id, at),
            },
            ExprKind::Host(id) if self.captured => {
                let name = captured(id.0 as usize);
                cloned(self.hosts[id.0 as usize].inside(), code!(g.#name))
            }
            ExprKind::Host(id) => {
                let host = &self.grammar.hosts[id.0 as usize];
                let ty = self.hosts[id.0 as usize];
                convert(&code!(cga_rt), ty, &self.source.hosts()[host.handle as usize])
            }
            ExprKind::Call(id, sites, args) => {
                let name = self.names.function(*id, self.source.token(expr.span.first));
                let (env, shape, site) = (&at.env, &at.shape, site::passed(sites));
                let site = site.map(|site| code!(#site,));
                let call = |args: &[TokenStream]| code!(CgaRules::#name(g, #env, #shape, #site #(#args),*));
                self.with_args(args, at, call)
            }
            ExprKind::Builtin(function, args) => {
                let name = hygienic(function.run);
                let needs = at.needs(function.needs);
                let call = |args: &[TokenStream]| {
                    // Words are part of the call.
                    let mut values = args.iter();
                    let args = function.params.iter().zip(words(function, expr)).map(|(param, word)| match word {
                        Some(word) => word_variant(&param.kind, word, &code!(func::)),
                        None => values.next().cloned().unwrap_or_default(),
                    });
                    code!(cga_rt::func::#name(#needs #(#args),*))
                };
                let values = args.iter().zip(words(function, expr)).filter(|(_, word)| word.is_none());
                self.with_args(values.map(|(arg, _)| arg), at, call)
            }
            ExprKind::Rust(path, args) => {
                let path = self.source.path(expr.span.first, path);
                let here = self.at_path(expr.span);
                let convert = conversion(HostType::Is(expr.ty), here);
                let call = |args: &[TokenStream]| {
                    let value = quote_spanned!(here=> cga_rt::host::#convert(&#path(#(#args),*)));
                    let env = &at.env;
                    match expr.ty {
                        Type::Float | Type::Bool => value,
                        _ => code!(cga_rt::host::counted(#env, #value)),
                    }
                };
                self.with_rust_args(args, at, call)
            }
            ExprKind::Shape(attr) => {
                let (get, needs) = (hygienic(attr.get), at.needs(attr.needs));
                code!(cga_rt::get::#get(#needs))
            }
            ExprKind::Comp(comp) => self.comp_value(comp, at),
            ExprKind::Word(word) => asked(word),
            ExprKind::Style(styles) => is_one_of(styles, &code!(g.style)),
            ExprKind::Site(sites) => is_one_of(sites, &code!(site)),
            ExprKind::Array(rows) => self.array(rows, at),
            ExprKind::Range(..) => self.function_call("range_by", expr, at),
            ExprKind::Index(_, indices) => {
                let many = indices.iter().any(|index| index.ty.is_array());
                let name = match (indices.len(), many) {
                    (1, false) => "element",
                    (1, true) => "elements",
                    (_, false) => "element_at",
                    (_, true) => "elements_at",
                };
                self.function_call(name, expr, at)
            }
            ExprKind::EachUnary(EachUnary::Neg, _) => self.function_call("each_minus", expr, at),
            ExprKind::EachUnary(EachUnary::Not, _) => self.function_call("each_not", expr, at),
            ExprKind::Each(operator, ..) => {
                self.function_call(&format!("each_{}", function_name(*operator, expr.ty)), expr, at)
            }
            ExprKind::Neg(inner) => {
                let inner = self.expr(inner, at);
                code!((-(#inner)))
            }
            ExprKind::Not(inner) => {
                let inner = self.expr(inner, at);
                code!((!(#inner)))
            }
            ExprKind::Binary(operator @ (Binary::Lt | Binary::Le), left, right) if left.ty == Type::Float => {
                // NaN is less than anything; see `func::compare`.
                let (left, right) = (self.expr(left, at), self.expr(right, at));
                let opposite = operator_of(if *operator == Binary::Lt { Binary::Ge } else { Binary::Gt });
                code!((!(#left #opposite #right)))
            }
            ExprKind::Binary(operator, left, right) if left.ty.is_array() => {
                let name = hygienic(function_name(*operator, expr.ty));
                let call = |args: &[TokenStream]| code!(cga_rt::func::#name(#(#args),*));
                self.with_args([&**left, &**right], at, call)
            }
            ExprKind::Binary(operator @ (Binary::Eq | Binary::Ne), left, right) if left.ty == Type::Text => {
                let not = (*operator == Binary::Ne).then(|| code!(!));
                // A literal is compared as it is.
                let (left, right) = if matches!(left.kind, ExprKind::Value(_)) { (right, left) } else { (left, right) };
                let (text, other) = (self.text(left, at), self.text(right, at));
                match &right.kind {
                    ExprKind::Value(Value::Text(other)) => code!((#not #text.is(#other))),
                    _ => code!((#not #text.is(#other.as_str()))),
                }
            }
            // Joined text can end the run.
            ExprKind::Binary(..) if expr.ty == Type::Text => self.function_call("concat", expr, at),
            ExprKind::Binary(operator, left, right) => {
                let (left, operator, right) = (self.expr(left, at), operator_of(*operator), self.expr(right, at));
                code!((#left #operator #right))
            }
            ExprKind::Chain(first, links) => {
                let (env, all, next) = (&at.env, hygienic("so_far"), hygienic("operand"));
                let first = self.expr(first, at);
                let links = links.iter().map(|(operator, operand)| {
                    let (operand, operator) = (self.expr(operand, at), operator_of(*operator));
                    match expr.ty {
                        // Joined text can end the run.
                        Type::Text => code!({ let #next = #operand; #all = cga_rt::func::concat(#env, #all, #next); }),
                        _ => code!(#all = #all #operator #operand;),
                    }
                });
                // One variable for all results: each further one would nest the scopes of the debugger.
                code!({ let mut #all = #first; #(#links)* #all })
            }
            ExprKind::File(name, folder) => {
                let (is_array, name) = (name.ty.is_array(), self.expr(name, at));
                if is_array {
                    code!(cga_rt::Files::new(#name, cga_rt::Text::fixed(#folder)))
                } else {
                    code!(cga_rt::File::new(#name, cga_rt::Text::fixed(#folder)))
                }
            }
            // It came in as text.
            ExprKind::ToText(inner) if matches!(inner.kind, ExprKind::Host(_)) => self.expr(inner, at),
            // Long arrays end the run.
            ExprKind::ToText(inner) if inner.ty.is_array() => self.function_call("array_to_text", expr, at),
            ExprKind::ToText(inner) => {
                let convert = types::function(inner.ty, "to_text");
                let inner = self.expr(inner, at);
                code!(cga_rt::func::#convert(#inner))
            }
            ExprKind::Case(arms, otherwise) => {
                let values = arms.iter().map(|(_, value)| self.expr(value, at));
                let otherwise = self.expr(otherwise, at);
                if let Some((number, lists)) = by_number(arms) {
                    return code!((match #number { #(#lists => #values,)* _ => #otherwise }));
                }
                let conditions = arms.iter().map(|(condition, _)| self.expr(condition, at));
                code!((#(if #conditions { #values } else)* { #otherwise }))
            }
            ExprKind::Chance { percent, before } => {
                let (shape, percent, before) =
                    (&at.shape, value(&Value::Float(*percent)), value(&Value::Float(*before)));
                code!(cga_rt::branch(#shape, #percent, #before))
            }
        }
    }

    /// A function of the runtime that gets the run and the parts of an expression.
    fn function_call(&self, name: &str, expr: &Expr, at: &Access) -> TokenStream {
        let (name, env) = (hygienic(name), &at.env);
        self.with_args(expr.parts(), at, |args| code!(cga_rt::func::#name(#env, #(#args),*)))
    }

    /// The name of an image, as text.
    pub(super) fn image(&self, expr: &Expr, at: &Access) -> TokenStream {
        let env = &at.env;
        match &expr.kind {
            // Nothing is looked for.
            ExprKind::File(name, folder) if folder.is_empty() => self.expr(name, at),
            ExprKind::File(..) => {
                let file = self.expr(expr, at);
                code!({ let file = #file; cga_rt::image(#env, file) })
            }
            _ => self.expr(expr, at),
        }
    }

    /// `[a, b; c, d]`.
    fn array(&self, rows: &[Vec<Expr>], at: &Access) -> TokenStream {
        let env = &at.env;
        let call = |args: &[TokenStream]| {
            let mut args = args.iter();
            let rows = rows.iter().map(|row| {
                let parts = args.by_ref().take(row.len());
                code!(&[#(cga_rt::func::ArrayPart::from(#parts)),*])
            });
            code!(cga_rt::func::array(#env, &[#(#rows),*]))
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
        let values: Vec<TokenStream> = args.clone().into_iter().map(|arg| self.expr(arg, at)).collect();
        if args.into_iter().all(|arg| self.is_plain(arg)) {
            return call(&values);
        }
        let names: Vec<TokenStream> =
            (0..values.len()).map(|number| local("a", number)).map(|name| quote!(#name)).collect();
        let call = call(&names);
        code!({ #(let #names = #values;)* #call })
    }

    /// Returns true if an argument needs neither the shape nor the run.
    fn is_plain(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Value(_) | ExprKind::Param(_) => true,
            ExprKind::Global(id) => self.grammar.global(*id).attr.is_none() && !self.is_lazy(*id),
            ExprKind::Neg(inner) | ExprKind::Not(inner) | ExprKind::File(inner, _) => self.is_plain(inner),
            ExprKind::Binary(..) if expr.ty == Type::Text => false,
            ExprKind::Binary(_, left, right) => self.is_plain(left) && self.is_plain(right),
            _ => false,
        }
    }

    /// A text to borrow: parameters, attributes and constants are not copied.
    fn text(&self, expr: &Expr, at: &Access) -> TokenStream {
        self.stored(expr).unwrap_or_else(|| self.expr(expr, at))
    }

    /// A number or a truth value, or a reference to another value: parameters, attributes and constants are not copied.
    pub(super) fn borrowed(&self, expr: &Expr, at: &Access) -> TokenStream {
        let value = self.text(expr, at);
        if matches!(expr.ty, Type::Float | Type::Bool) { value } else { code!(&#value) }
    }

    /// The place of a parameter, an attribute or a constant.
    fn stored(&self, expr: &Expr) -> Option<TokenStream> {
        let is_stored =
            |global: &Global| !global.is_set && !global.lazy && (global.attr.is_some() || global.known.is_none());
        match expr.kind {
            ExprKind::Param(number) => {
                let name = self.param(number as usize);
                Some(code!(#name))
            }
            ExprKind::Global(id) if is_stored(self.grammar.global(id)) => {
                let name = self.global_name(id);
                Some(code!(g.#name))
            }
            _ => None,
        }
    }

    /// The span of a call of Rust, where rustc shows a wrong signature: the last name of the path.
    pub(super) fn at_path(&self, span: cga_lang::span::Span) -> Span {
        let path = cga_lang::span::Span::one(span.first);
        Span::mixed_site().located_at(self.source.span(path).1)
    }

    /// A call of a Rust function of the user with its arguments.
    pub(super) fn with_rust_args(
        &self,
        args: &[Expr],
        at: &Access,
        call: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let values = args.iter().map(|arg| self.expr(arg, at));
        let (names, passed) = self.passed(args);
        let call = call(&passed);
        code!({ #(let #names = #values;)* #call })
    }

    /// The locals of arguments of a Rust function of the user, and how it takes them: text arrives as `&str`, and each argument keeps its
    /// span.
    pub(super) fn passed(&self, args: &[Expr]) -> (Vec<Ident>, Vec<TokenStream>) {
        let place = location::current();
        let names: Vec<Ident> = (0..args.len()).map(|number| local("a", number)).collect();
        let passed = names.iter().zip(args).map(|(name, arg)| {
            let here = place.located_at(self.source.token(arg.span.first));
            let name = Ident::new(&name.to_string(), here);
            match arg.ty {
                Type::Text => quote_spanned!(here=> cga_rt::host::as_str(&#name)),
                ty if ty.is_array() => quote_spanned!(here=> &#name),
                _ => quote!(#name),
            }
        });
        let passed = passed.collect();
        (names, passed)
    }
}

/// The style or the site with the pattern of each branch, if a `case` chooses by the style alone or by the site alone.
fn by_number(arms: &[(Expr, Expr)]) -> Option<(TokenStream, Vec<TokenStream>)> {
    let number = match arms.first()?.0.kind {
        ExprKind::Style(_) => code!(g.style),
        ExprKind::Site(_) => code!(site),
        _ => return None,
    };
    let first = &arms[0].0.kind;
    let lists = arms.iter().map(|(test, _)| match (first, &test.kind) {
        (ExprKind::Style(_), ExprKind::Style(list)) | (ExprKind::Site(_), ExprKind::Site(list)) => Some(one_of(list)),
        _ => None,
    });
    Some((number, lists.collect::<Option<_>>()?))
}

/// A pattern for the numbers of a list.
fn one_of(list: &[u32]) -> TokenStream {
    let list = list.iter().map(|number| Literal::u32_suffixed(*number));
    code!(#(#list)|*)
}

/// Returns true if a style or site is in a list.
pub(super) fn is_one_of(list: &[u32], number: &TokenStream) -> TokenStream {
    let list = one_of(list);
    code!(::core::matches!(#number, #list))
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
    let ParamKind::Word(words @ Words { rust, .. }) = kind else { return TokenStream::new() };
    let (rust, variant) = (hygienic(rust), hygienic(&words.variant(word)));
    code!(cga_rt::#module #rust::#variant)
}

/// The function that compares two arrays. With `each_` before it, the function for their elements, with a result of that type.
fn function_name(operator: Binary, ty: Type) -> &'static str {
    match operator {
        Binary::Add if ty == Type::Texts => "concat",
        Binary::Add => "add",
        Binary::Sub => "subtract",
        Binary::Mul => "multiply",
        Binary::Div => "divide",
        Binary::Rem => "remainder",
        Binary::Eq => "equal",
        Binary::Ne => "unequal",
        Binary::Lt => "less",
        Binary::Le => "less_equal",
        Binary::Gt => "greater",
        Binary::Ge => "greater_equal",
        Binary::And => "and",
        Binary::Or => "or",
    }
}

/// Rust's operator.
fn operator_of(operator: Binary) -> TokenStream {
    match operator {
        Binary::Add => code!(+),
        Binary::Sub => code!(-),
        Binary::Mul => code!(*),
        Binary::Div => code!(/),
        Binary::Rem => code!(%),
        Binary::Eq => code!(==),
        Binary::Ne => code!(!=),
        Binary::Lt => code!(<),
        Binary::Le => code!(<=),
        Binary::Gt => code!(>),
        Binary::Ge => code!(>=),
        // Both sides are always evaluated.
        Binary::And => code!(&),
        Binary::Or => code!(|),
    }
}
