//! Declarations: rules, attributes, constants, functions.

use super::layout::{Head, head};
use super::{Parsed, Parser, Reported};
use crate::ast::{Ast, Body, Decl, Expr, ExprKind, Name, Op, OpKind, Role};
use crate::code::Code;
use crate::token::{Sym, Tok};

/// Words that cannot be names.
const KEYWORDS: &[&str] = &["attr", "const", "case", "else", "true", "false", "NIL", "split", "comp"];

impl Parser<'_> {
    pub(super) fn grammar(&mut self) -> Ast {
        let mut ast = Ast::default();
        while self.at < self.view.len() && self.tick() {
            let start = self.at;
            self.depth = 0;
            self.deep = false;
            if self.declaration(&mut ast).is_ok() && !self.at_border() {
                self.leftover();
            }
            if self.at == start {
                self.bump();
            }
            self.skip_to_border();
        }
        ast.lost = std::mem::take(&mut self.lost);
        ast
    }

    fn leftover(&mut self) {
        let (span, found) = (self.span(), self.peek().map_or("nothing".into(), Tok::describe));
        match self.peek() {
            Some(token) if token.ident() == Some("else") => {
                self.diags.report(Code::Syntax, span, "`else` without a `case` or percentage before it")
            }
            Some(Tok::Sym(Sym::RParen | Sym::RBrace | Sym::RBracket)) => {
                self.diags.report(Code::Syntax, span, format!("this {found} closes nothing"))
            }
            _ => self.diags.report(Code::Syntax, span, format!("unexpected {found}")),
        };
    }

    /// Skips to the next declaration. Names that seem to be declared on the way are remembered as lost.
    fn skip_to_border(&mut self) {
        while !self.at_border() {
            let at = |ahead: usize| self.view.get(ahead).map(|&index| &self.tokens[index as usize]);
            if let (Some(_), Some(name)) = (head(&at, self.at), self.peek().and_then(Tok::ident)) {
                let name = name.to_owned();
                self.lost.push(name);
            }
            self.bump();
        }
    }

    fn declaration(&mut self, ast: &mut Ast) -> Parsed<()> {
        let docs_from = self.at;
        let mut annotations = Vec::new();
        while self.is(Sym::At) && self.tick() {
            annotations.extend(self.annotation()?);
        }
        let start = self.at;
        let docs = self.docs_between(docs_from, start);
        let word = self.peek().and_then(Tok::ident).unwrap_or_default();
        let next_is_name = self.nth(1).is_some_and(|token| token.ident().is_some());
        match word {
            "version" if matches!(self.nth(1), Some(Tok::Str(_))) => {
                if let Some(Tok::Str(text)) = self.nth(1) {
                    ast.version = Some(text.clone());
                }
                ast.head.append(&mut annotations);
                self.bump();
                self.bump();
                return Ok(());
            }
            "import" | "style" if next_is_name => return self.later(start, word),
            "start" | "extension" if next_is_name && self.layout.starts[self.at] => {
                self.later::<()>(start, word).ok();
                self.bump();
                return self.declaration(ast);
            }
            _ => {}
        }
        let keyword = matches!(word, "attr" | "const") && next_is_name;
        if keyword {
            self.bump();
        }
        let at = |position: usize| self.view.get(position).map(|&index| &self.tokens[index as usize]);
        let head = head(&at, self.at);
        if !keyword && head.is_none() {
            return self.no_declaration();
        }
        let Some(name) = self.take_name() else { return self.fail("a name") };
        self.not_a_keyword(&name);
        let params = self.params().inspect_err(|_| self.lost.push(name.text.clone()))?;
        if self.is_word("with") && self.nth_is(1, Sym::LParen) {
            self.lost.push(name.text);
            let span = self.span();
            self.unsupported(span, "`with` is");
            return Err(Reported);
        }
        let body = if keyword {
            if let (Some(first), Some(last)) = (params.first(), params.last()) {
                let message = if word == "attr" { "an attribute" } else { "a constant" };
                self.diags
                    .report(Code::Syntax, first.span.to(last.span), format!("{message} has no parameters"))
                    .help(format!("leave out `{word}`: then it is a function"));
            }
            self.expect(Sym::Assign).inspect_err(|_| self.lost.push(name.text.clone()))?;
            let value = self.body_expr();
            if word == "attr" { Body::Attr(value) } else { Body::Const(value) }
        } else if head == Some(Head::Function) {
            self.bump();
            Body::Function(self.body_expr())
        } else {
            self.arrow(head);
            Body::Rule(self.body_ops())
        };
        let span = self.span_from(start);
        ast.decls.push(Decl {
            annotations,
            docs,
            name,
            style: 0,
            role: Role::Plain,
            params,
            locals: Vec::new(),
            body,
            span,
        });
        Ok(())
    }

    fn not_a_keyword(&mut self, name: &Name) {
        if KEYWORDS.contains(&name.text.as_str()) {
            let message = format!("`{}` is a word of the language, it cannot be declared", name.text);
            self.diags.report(Code::Syntax, name.span, message);
        }
    }

    fn docs_between(&self, from: usize, to: usize) -> Vec<String> {
        let first = self.docs.partition_point(|(before, _)| *before < from);
        let found = self.docs[first..].iter().take_while(|(before, _)| *before <= to);
        found.map(|(_, text)| (*text).to_owned()).collect()
    }

    fn later<T>(&mut self, start: usize, word: &str) -> Parsed<T> {
        let span = self.span_at(start);
        self.unsupported(span, &format!("`{word}` is"));
        Err(Reported)
    }

    fn no_declaration<T>(&mut self) -> Parsed<T> {
        if self.at_border() && 0 < self.at {
            // Annotations with nothing behind them.
            return self.fail("a declaration");
        }
        self.expected("a declaration").help("write `Name --> …`, `attr name = …`, `const name = …` or `name = …`");
        Err(Reported)
    }

    fn arrow(&mut self, head: Option<Head>) {
        if let Some(Head::Slip(length)) = head {
            let start = self.at;
            self.at += length;
            let span = self.span_from(start);
            self.diags.report(Code::Syntax, span, "a rule's arrow has two dashes").help("write `-->`");
        } else {
            self.bump();
        }
    }

    fn params(&mut self) -> Parsed<Vec<Name>> {
        let mut params = Vec::new();
        if !self.is(Sym::LParen) {
            return Ok(params);
        }
        let close = self.closing()?;
        self.bump();
        while self.at < close && self.tick() {
            match self.take_name() {
                Some(name) => {
                    self.not_a_keyword(&name);
                    params.push(name);
                }
                None => return self.fail("the name of a parameter"),
            }
            if self.at < close && !self.eat(Sym::Comma) {
                return self.fail("`,` or `)`");
            }
        }
        self.at = close + 1;
        Ok(params)
    }

    fn body_expr(&mut self) -> Expr {
        let start = self.at;
        self.value().unwrap_or_else(|Reported| {
            self.skip_to_border();
            Expr { kind: ExprKind::Error, span: self.span_from(start) }
        })
    }

    fn body_ops(&mut self) -> Vec<Op> {
        let start = self.at;
        self.ops(false).unwrap_or_else(|Reported| {
            self.skip_to_border();
            vec![Op { kind: OpKind::Error, span: self.span_from(start) }]
        })
    }
}
