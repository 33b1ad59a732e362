//! Declarations: rules, attributes, constants, functions.

use super::layout::Head;
use super::type_words::is_type;
use super::{Parsed, Parser, Reported};
use crate::diag::code::Code;
use crate::ops;
use crate::suggest::nearest;
use crate::syntax::ast::{Annotation, Ast, Body, Decl, Expr, ExprKind, Name, Op, OpKind, Role};
use crate::syntax::token::{Sym, Tok};

/// Words that cannot be names.
const KEYWORDS: &[&str] = &["attr", "const", "case", "else", "true", "false", "NIL", "split", "comp"];

/// Words that begin a declaration.
const DECLARATIONS: &[&str] = &["attr", "const", "import", "style", "version", "start", "extension"];

/// The one attribute with a parameter (*changelog*, 2019.1).
const STREET_WIDTH: &str = "streetWidth";

/// Returns true if the name cannot be declared.
pub(super) fn is_keyword(name: &str) -> bool {
    KEYWORDS.contains(&name)
}

impl Parser<'_> {
    pub(super) fn grammar(&mut self) -> Ast {
        let mut ast = Ast::default();
        let mut style = 0;
        while self.at < self.layout.len() && self.tick() {
            let start = self.at;
            self.depth = 0;
            self.deep = false;
            // After a missing `{`, an arm looks like a function: `| all = Wall`.
            let is_arm = self.lacks_brace && self.before(1).is_some_and(|token| token.is(Sym::Bar));
            if is_arm {
                self.bump();
                self.skip_to_border();
                continue;
            }
            self.lacks_brace = false;
            if self.item(&mut ast, &mut style).is_ok() && !self.at_border() && !self.lacks_brace {
                self.leftover(&ast);
            }
            if self.at == start {
                self.bump();
            }
            self.skip_to_border();
        }
        ast.lost = std::mem::take(&mut self.lost);
        ast
    }

    /// Skips to the next declaration. Skipped names that appear to be declared are recorded as lost.
    fn skip_to_border(&mut self) {
        while !self.at_border() {
            if let (Some(_), Some(name)) = (self.layout.head(self.at), self.peek().and_then(Tok::ident)) {
                self.lost.push(name.to_owned());
            }
            self.bump();
        }
    }

    fn item(&mut self, ast: &mut Ast, style: &mut u32) -> Parsed<()> {
        let docs_from = self.at;
        let mut annotations = Vec::new();
        while self.is(Sym::At) && self.tick() {
            annotations.extend(self.annotation()?);
        }
        let docs = self.docs_between(docs_from, self.at);
        let next_is_name = self.nth_is_name(1);
        match self.peek().and_then(Tok::ident).unwrap_or_default() {
            "version" => {
                if let Some(Tok::Str(text)) = self.nth(1) {
                    if ast.version.is_some() || !ast.imports.is_empty() || !ast.decls.is_empty() || *style != 0 {
                        self.syntax(self.at, "`version` must be the first statement of a file")
                            .help("move it to the first line");
                    }
                    ast.version = Some(text.clone());
                    ast.head.append(&mut annotations);
                    self.bump();
                    self.bump();
                    return Ok(());
                }
            }
            "import" if next_is_name => {
                let id = self.nth(1).and_then(Tok::ident).map(str::to_owned);
                ast.imports.push(self.import(annotations).inspect_err(|_| self.lost.extend(id))?);
                if self.nth_is_name(0) && self.nth_is(1, Sym::Colon) && !self.at_border() {
                    let diag = self.syntax(self.at, "every import begins with `import`");
                    return Err(diag.help("write `import` before the prefix").into());
                }
                return Ok(());
            }
            "import" if matches!(self.nth(1), Some(Tok::Str(_))) => return self.import_without_prefix(),
            "style" if next_is_name && self.layout.head(self.at + 1).is_none() => {
                *style = self.style(ast, annotations)?;
                return Ok(());
            }
            _ => {}
        }
        let decl = self.declaration(annotations, docs)?;
        // *CGA changelog 2023.0*.
        if *style != 0 && matches!(decl.body, Body::Rule(_)) && decl.name.text.contains('.') {
            let message = "a rule of an import can be declared in the style `Default` only";
            self.diags.report(Code::Syntax, decl.name.span, message).help("move it before the first `style`");
        }
        ast.decls.push(Decl { style: *style, ..decl });
        Ok(())
    }

    fn declaration(&mut self, annotations: Vec<Annotation>, docs: Vec<String>) -> Parsed<Decl> {
        let start = self.at;
        let word = self.peek().and_then(Tok::ident).unwrap_or_default();
        let next_is_name = self.nth_is_name(1);
        let keyword = matches!(word, "attr" | "const") && next_is_name;
        let role = match word {
            "start" if next_is_name && self.layout.head(self.at + 1).is_some_and(Head::is_sure) => Role::Start,
            "extension" if next_is_name && self.layout.head(self.at + 1).is_some_and(Head::is_sure) => Role::Extension,
            _ => Role::Plain,
        };
        if keyword || role != Role::Plain {
            self.bump();
        }
        if keyword {
            self.type_before_name(word);
        }
        let head = self.layout.head(self.at);
        if !keyword && head.is_none() {
            return self.no_declaration();
        }
        let Some(name) = self.take_dotted(self.layout.name_end(self.at)) else { return self.fail("a name") };
        self.not_a_keyword(&name);
        let lose = |parser: &mut Self| parser.lost.push(name.text.clone());
        let params = self.params().inspect_err(|_| lose(self))?;
        let locals = self.locals().inspect_err(|_| lose(self))?;
        let body = match head.filter(|_| !keyword) {
            None => {
                let known = self.value_name(&name, if word == "attr" { "an attribute" } else { "a constant" }, &params);
                self.type_behind_name(|| format!("{word} {} = …", name.text));
                if !self.eat(Sym::Assign) {
                    lose(self);
                    let help = format!("write `{word} {} = …`: its type follows from the value", name.text);
                    return Err(self.expected("`=`").help(help).into());
                }
                let value = self.body_expr();
                if !known {
                    lose(self);
                    return Err(Reported);
                }
                match word {
                    // The attribute has a value for each edge, which can only be read by the number of the edge.
                    "attr" if !params.is_empty() => Body::Function(value),
                    "attr" => Body::Attr(value),
                    _ => Body::Const(value),
                }
            }
            Some(Head::Function) => {
                self.bump();
                self.function(&name)
            }
            Some(head) => {
                self.rule_name(&name);
                self.arrow(head);
                Body::Rule(self.body_ops())
            }
        };
        let span = self.span_from(start);
        Ok(Decl { annotations, docs, name, style: 0, role, params, locals, body, span })
    }

    pub(super) fn not_a_keyword(&mut self, name: &Name) {
        if is_keyword(&name.text) {
            let message = format!("`{}` is a keyword and cannot be declared", name.text);
            self.diags.report(Code::Syntax, name.span, message);
        }
    }

    /// Takes the name of a declaration that is not a rule.
    pub(super) fn plain_name(&mut self, what: &str) -> Parsed<Name> {
        let Some(name) = self.take_name() else { return self.fail(&format!("the name of {what}")) };
        self.no_dollar(&name, what);
        Ok(name)
    }

    /// Reports a `$`, which only names of rules can have (*changelog*, 2021.0, 2023.1).
    pub(super) fn no_dollar(&mut self, name: &Name, what: &str) {
        if name.text.contains('$') {
            let message = format!("the name of {what} has no `$`");
            self.diags.report(Code::Syntax, name.span, message);
        }
    }

    /// Checks the name of an attribute or constant. Returns true if the use of the name is clear.
    fn value_name(&mut self, name: &Name, what: &str, params: &[Name]) -> bool {
        self.no_dollar(name, what);
        self.no_dot(name);
        if let (Some(first), Some(last)) = (params.first(), params.last())
            && !(what == "an attribute" && name.text == STREET_WIDTH && params.len() == 1)
        {
            let word = if what == "an attribute" { "attr" } else { "const" };
            self.diags
                .report(Code::Syntax, first.span.to(last.span), format!("{what} has no parameters"))
                .help(format!("leave out `{word}`: then it is a function"));
            return false;
        }
        true
    }

    fn no_dot(&mut self, name: &Name) {
        if name.text.contains('.') {
            let message = format!("`{}` belongs to an import, it is not declared here", name.text);
            self.diags
                .report(Code::Syntax, name.span, message)
                .help("write `(name = value)` after the path of the import to replace an attribute");
        }
    }

    /// Checks the name of a rule: with one dot it continues a leaf of an import (*changelog*, 2023.0).
    fn rule_name(&mut self, name: &Name) {
        if 1 < name.text.matches('.').count() {
            let message = format!("`{}` has more than one import prefix", name.text);
            self.diags.report(Code::Syntax, name.span, message).help("declare it in the file that imports it");
        }
    }

    fn docs_between(&self, from: usize, to: usize) -> Vec<String> {
        let first = self.docs.partition_point(|(before, _)| *before < from);
        let found = self.docs[first..].iter().take_while(|(before, _)| *before <= to);
        found.map(|(_, text)| (*text).to_owned()).collect()
    }

    fn no_declaration<T>(&mut self) -> Parsed<T> {
        if self.at_border() && 0 < self.at {
            // Annotations without a declaration after them.
            return self.fail("a declaration");
        }
        let word = self.peek().and_then(Tok::ident);
        if word.is_some_and(is_type) && self.layout.head(self.at + 1) == Some(Head::Function) {
            self.type_before_name("attr");
            return Err(Reported);
        }
        let near = word.and_then(|word| nearest(word, DECLARATIONS.iter().copied()).filter(|near| *near != word));
        let help = match word {
            _ if near.is_some() => "",
            Some("style") => "a style has a name: write `style Name`",
            Some("import") => "write `import prefix : \"file.cga\"`",
            Some("version") => "write `version \"2025.1\"`",
            _ => "write `Name --> …`, `attr name = …`, `const name = …` or `name = …`",
        };
        let diag = self.expected("a declaration").suggest(near);
        if near.is_none() {
            diag.help(help);
        }
        Err(Reported)
    }

    /// Passes over `-->` or the symbols written in its place.
    pub(super) fn arrow(&mut self, head: Head) {
        match head {
            Head::Slip(length) => {
                let start = self.at;
                self.at += length;
                let span = self.span_from(start);
                let message = match length {
                    3 => "a rule's arrow is written in one piece",
                    _ => "a rule's arrow has two dashes",
                };
                self.syntax_over(start, span, message).help("write `-->`");
            }
            Head::Leaf => {
                let at = self.at;
                self.at += 2;
                self.syntax(at, "the name of a rule does not end with a dot")
                    .help("leave out the dot; it makes a leaf where no rule is declared");
            }
            Head::Rule | Head::Function => self.bump(),
        }
    }

    pub(super) fn params(&mut self) -> Parsed<Vec<Name>> {
        if !self.is(Sym::LParen) {
            return Ok(Vec::new());
        }
        self.between_commas(|parser| {
            parser.type_before_parameter();
            let Some(name) = parser.take_name() else { return parser.fail("the name of a parameter") };
            parser.type_behind_name(|| name.text.clone());
            parser.not_a_keyword(&name);
            parser.no_dollar(&name, "a parameter");
            Ok(name)
        })
    }

    fn body_expr(&mut self) -> Expr {
        let start = self.at;
        self.expr().unwrap_or_else(|Reported| {
            self.skip_to_border();
            Expr::error(self.span_from(start))
        })
    }

    fn body_ops(&mut self) -> Vec<Op> {
        let start = self.at;
        self.ops(false).unwrap_or_else(|Reported| {
            self.skip_to_border();
            vec![Op { kind: OpKind::Error, span: self.span_from(start) }]
        })
    }

    /// Parses the body of a function after its `=`. Operations in the body mean a rule with the wrong arrow.
    fn function(&mut self, name: &Name) -> Body {
        let (start, lost) = (self.at, self.lost.len());
        let (value, found) = self.tried(Self::body_expr);
        let end = self.at;
        if !self.at_border() || !found.is_empty() || is_operation(&value) {
            self.at = start;
            let (steps, wrong) = self.tried(|parser| parser.ops(false));
            if let Ok(steps) = steps
                && wrong.is_empty()
                && self.at_border()
                && any_step(&steps)
            {
                self.lost.truncate(lost);
                self.rule_name(name);
                self.syntax(start - 1, "`=` begins a value, but these are operations").help("write `-->`");
                return Body::Rule(steps);
            }
            self.at = end;
        }
        self.no_dollar(name, "a function");
        self.no_dot(name);
        self.diags.append(found);
        Body::Function(value)
    }
}

/// Returns true if the value is the call of an operation of the tables and not of a function.
fn is_operation(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Name(name) if name.text == "NIL" => true,
        ExprKind::Name(name) | ExprKind::Call(name, _) => {
            ops::operations(&name.text).next().is_some() && ops::functions(&name.text).next().is_none()
        }
        _ => false,
    }
}

fn any_step(steps: &[Op]) -> bool {
    steps.iter().any(is_step)
}

/// Returns true if the step cannot be a value.
fn is_step(step: &Op) -> bool {
    match &step.kind {
        OpKind::Call(name, _) => ops::operations(&name.text).next().is_some(),
        OpKind::Push(_) | OpKind::Case(..) | OpKind::Chance(..) => step.bodies().any(any_step),
        OpKind::Path(..) | OpKind::Error => false,
        _ => true,
    }
}
