//! `import id(styles) : "path" (overrides)`, and `id(overrides).Rule(arguments)` in a rule.

use super::head::stem;
use super::layout::Head;
use super::{Parsed, Parser, Reported};
use crate::diag::code::Code;
use crate::syntax::ast::{Annotation, Body, Decl, Import, Name, Op, OpKind, Override, Role};
use crate::syntax::token::{Sym, Tok};

impl Parser<'_> {
    /// Parses an import from the word `import`.
    pub(super) fn import(&mut self, annotations: Vec<Annotation>) -> Parsed<Import> {
        let start = self.at;
        self.bump();
        let Some(id) = self.take_name() else { return self.fail("the prefix of the import") };
        self.no_dollar(&id, "an import");
        let styles =
            if self.is(Sym::LParen) { Some(self.between_commas(|parser| parser.plain_name("a style"))?) } else { None };
        let usage = format!("write `import {} : \"file.cga\"`", id.text);
        if !self.eat(Sym::Colon) {
            return Err(self.expected_only("`:`").help(usage).into());
        }
        let Some(Tok::Str(path)) = self.peek() else {
            return Err(self.expected_only("the path of a rule file in quotes").help(usage).into());
        };
        let path_span = self.span();
        self.bump();
        let overrides = if self.is(Sym::LParen) { Some(self.overrides()?) } else { None };
        let span = self.span_from(start);
        Ok(Import { annotations, id, styles, path: path.clone(), path_span, overrides, span })
    }

    /// Reports an import with a path directly after the word `import`. The name of the file was meant as the prefix.
    pub(super) fn import_without_prefix<T>(&mut self) -> Parsed<T> {
        if let Some(Tok::Str(path)) = self.nth(1) {
            // `import "file.cga" as prefix`.
            let own = self.nth(3).and_then(Tok::ident).filter(|_| self.nth(2).and_then(Tok::ident) == Some("as"));
            let prefix = own.unwrap_or(stem(path));
            let is_name = !prefix.is_empty() && prefix.chars().all(|c| c == '_' || c.is_alphanumeric());
            let shown = if is_name { prefix } else { "prefix" };
            self.lost.push(prefix.to_owned());
            self.syntax(self.at + 1, "this import has no prefix before its path")
                .help(format!("write `import {shown} : \"{path}\"`"));
        }
        self.at += 2;
        Err(Reported)
    }

    /// Parses `(attr, attr = value, Rule(params) --> steps)`. Overrides that cannot be read are left out.
    pub(super) fn overrides(&mut self) -> Parsed<Vec<Override>> {
        let close = self.closing()?;
        self.bump();
        let mut list = Vec::new();
        while self.at < close && self.tick() {
            if let Ok(one) = self.bracketed(true, |parser| parser.one_override(close)) {
                list.push(one);
                if self.at < close && !self.is(Sym::Comma) {
                    let diag = self.expected("`,` or `)`");
                    diag.help("put `,` between the overrides");
                }
            }
            while self.at < close && !self.is(Sym::Comma) {
                self.at = self.layout.close(self.at).unwrap_or(self.at) + 1;
            }
            if self.at < close {
                self.bump();
                if self.at == close {
                    self.expected("an attribute or a rule");
                }
            }
        }
        self.at = close + 1;
        Ok(list)
    }

    fn one_override(&mut self, close: usize) -> Parsed<Override> {
        let (start, head) = (self.at, self.layout.override_head(self.at));
        let Some(name) = self.take_dotted(self.layout.path_end(self.at)) else {
            return self.fail("an attribute or a rule");
        };
        match head {
            Some(head) if head != Head::Function => {
                if name.text.contains('.') {
                    let message = "rules of nested imports cannot be replaced here";
                    self.diags.report(Code::Syntax, name.span, message).help("replace it where it is imported");
                }
                let params = self.params()?;
                let locals = self.locals()?;
                self.arrow(head);
                let from = self.at;
                let ops = self.ops(false).unwrap_or_else(|Reported| {
                    self.at = self.at.min(close);
                    vec![Op { kind: OpKind::Error, span: self.span_from(from) }]
                });
                let span = self.span_from(start);
                let (annotations, docs, body) = (Vec::new(), Vec::new(), Body::Rule(ops));
                let (style, role) = (0, Role::Plain);
                Ok(Override::Rule(Decl { annotations, docs, name, style, role, params, locals, body, span }))
            }
            _ if self.eat(Sym::Assign) => Ok(Override::Value(name, self.expr()?)),
            _ if self.at == close || self.is(Sym::Comma) => Ok(Override::Keep(name)),
            _ => {
                let help = format!("write `{0} = value` or `{0} --> operations`", name.text);
                Err(self.expected("`=`, `-->` or `,`").help(help).into())
            }
        }
    }

    /// Parses a dynamic call after the name of an import: parentheses, a dot and a rule.
    pub(super) fn dynamic(&mut self, import: Name) -> Parsed<OpKind> {
        let overrides = self.overrides()?;
        if !self.eat(Sym::Dot) {
            return self.fail("`.`");
        }
        let Some(rule) = self.take_joined() else { return self.fail("a rule of the import") };
        let args = if self.is(Sym::LParen) { self.args("")? } else { Vec::new() };
        Ok(OpKind::Dynamic { import, overrides, rule, args })
    }
}
