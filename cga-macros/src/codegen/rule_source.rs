//! The rules that a grammar was compiled from, for programs that follow them: the feature `live`.

use std::collections::BTreeSet;

use cga_lang::diag::Level;
use cga_lang::ir::{Expr, ExprKind, HostId, StepKind, Type, walk};
use cga_source::rust::{Header, shown};
use proc_macro2::TokenStream;
use quote::quote_spanned;

use super::{Generator, inner_type, types};
use crate::output::{HostType, conversion, convert};

impl Generator<'_> {
    /// The method that names the source of a grammar.
    pub(super) fn rule_source(&self, header: &Header) -> TokenStream {
        let (Some((path, is_rust)), name) = (self.source.origin(header), header.label()) else {
            return TokenStream::new();
        };
        let levels = header.levels.iter().map(|(code, level)| {
            let level = match level {
                Level::Allow => "allow",
                Level::Warning => "warn",
                Level::Error => "deny",
            };
            let code = code.name();
            code!((#code, #level))
        });
        let (imported, calls) = (self.source.imported(), self.rust_calls());
        code! {
            fn rule_source(&self) -> ::core::option::Option<cga_rt::RuleSource> {
                #[allow(unused, deprecated, clippy::all, clippy::pedantic, clippy::nursery)]
                const CALLS: &[cga_rt::RustCall] = &[#calls];
                ::core::option::Option::Some(cga_rt::RuleSource {
                    folder: ::core::env!("CARGO_MANIFEST_DIR"),
                    path: #path,
                    is_rust: #is_rust,
                    files: &[#path, #(#imported),*],
                    name: #name,
                    levels: &[#(#levels),*],
                    calls: CALLS,
                })
            }
        }
    }

    /// The Rust values and functions in the rules, each once for its types.
    fn rust_calls(&self) -> TokenStream {
        let mut seen = BTreeSet::new();
        let mut calls = TokenStream::new();
        let mut add = |name: String, args: &[Expr], result: &str, code: &dyn Fn() -> TokenStream| {
            let params: Vec<_> = args.iter().map(|arg| types::variant(arg.ty)).collect();
            let key = (name.clone(), params.iter().map(ToString::to_string).collect::<Vec<_>>(), result.to_owned());
            if seen.insert(key) {
                let code = code();
                calls.extend(code! {
                    cga_rt::RustCall { name: #name, params: &[#(cga_rt::ValueType::#params),*], code: cga_rt::RustCode::#code },
                });
            }
        };
        walk::exprs(self.grammar, &mut |expr| match &expr.kind {
            ExprKind::Host(HostId(id)) => {
                let host = &self.source.hosts()[self.grammar.hosts[*id as usize].handle as usize];
                let ty = self.hosts[*id as usize];
                let result = match ty {
                    HostType::Is(ty) => types::variant(ty).to_string(),
                    HostType::Shown => "shown".to_owned(),
                };
                add(format!("#{}", shown(&host.expr)), &[], &result, &|| {
                    let value = convert(&code!(cga_rt), ty, host);
                    let value = code!(|_| cga_rt::Value::from(#value));
                    match ty {
                        HostType::Is(ty) => valued(ty, &value),
                        HostType::Shown => code!(Shown(#value)),
                    }
                });
            }
            ExprKind::Rust(path, args) => {
                let name = spelling(path);
                add(name, args, &types::variant(expr.ty).to_string(), &|| {
                    let path = self.source.path(expr.span.first, path);
                    let here = self.at_path(expr.span);
                    let convert = conversion(HostType::Is(expr.ty), here);
                    let (lets, passed) = self.arguments(args);
                    let call = quote_spanned!(here=> cga_rt::host::#convert(&#path(#(#passed),*)));
                    valued(expr.ty, &code!(|args| { #lets cga_rt::Value::from(#call) }))
                });
            }
            _ => {}
        });
        for rule in &self.grammar.rules {
            walk::steps(&rule.body, &mut |step| {
                let StepKind::Rust(path, args) = &step.kind else { return };
                add(spelling(path), args, "operation", &|| {
                    let path = self.source.path(step.span.first, path);
                    let here = self.at_path(step.span);
                    let (lets, passed) = self.arguments(args);
                    let call =
                        quote_spanned!(here=> cga_rt::host::operate(env, shape, |shape| #path(shape, #(#passed),*)));
                    code!(Operation(|env, shape, args| { #lets #call; }))
                });
            });
        }
        calls
    }

    /// Arguments as locals, and as Rust functions take them.
    fn arguments(&self, args: &[Expr]) -> (TokenStream, Vec<TokenStream>) {
        let (names, passed) = self.passed(args);
        let lets = names.iter().zip(args).enumerate().map(|(number, (name, arg))| {
            let ty = inner_type(arg.ty);
            code!(let #name: #ty = cga_rt::host::argument(args, #number);)
        });
        (lets.collect(), passed)
    }
}

/// The variant for code that gives a value.
fn valued(ty: Type, code: &TokenStream) -> TokenStream {
    let ty = types::variant(ty);
    code!(Value(cga_rt::ValueType::#ty, #code))
}

/// A path without spaces.
fn spelling(path: &str) -> String {
    path.chars().filter(|character| !character.is_whitespace()).collect()
}
