//! Declarations, imports, styles, annotations.

use super::Printer;
use super::push_quoted;
use cga_lang::syntax::ast::{Annotation, Body, Decl, Import, Name, Override, Role, StyleDecl};

impl Printer<'_> {
    pub(super) fn annotation(&mut self, annotation: &Annotation) {
        self.word("@");
        self.word(&annotation.name.text);
        match &annotation.args {
            Some(args) if args.is_empty() => {}
            Some(args) => {
                self.word("(");
                self.list(args, ", ", |own, arg| {
                    if let Some(name) = &arg.name {
                        own.word(&name.text);
                        own.word(" = ");
                    }
                    own.expr(&arg.value);
                });
                self.word(")");
            }
            // Reads as arguments that cannot be read.
            None => self.word("({})"),
        }
        self.word("\n");
    }

    pub(super) fn import(&mut self, import: &Import) {
        for annotation in &import.annotations {
            self.annotation(annotation);
        }
        self.word("import ");
        self.word(&import.id.text);
        if let Some(styles) = &import.styles {
            self.word(" (");
            self.names(styles);
            self.word(")");
        }
        self.word(" : ");
        push_quoted(&mut self.out, &import.path);
        if let Some(overrides) = &import.overrides {
            self.word(" ");
            self.overrides(overrides);
        }
        self.word("\n");
    }

    /// Overrides in parentheses.
    pub(super) fn overrides(&mut self, overrides: &[Override]) {
        self.word("(");
        self.list(overrides, ", ", |own, one| match one {
            Override::Keep(name) => own.word(&name.text),
            Override::Value(name, value) => {
                own.word(&name.text);
                own.word(" = ");
                own.expr(value);
            }
            Override::Rule(decl) => own.decl(decl),
        });
        self.word(")");
    }

    /// The first mention of a style.
    pub(super) fn style(&mut self, style: &StyleDecl) {
        for annotation in &style.annotations {
            self.annotation(annotation);
        }
        self.word("style ");
        self.word(&style.name.text);
        if let Some(base) = &style.base {
            self.word(" extends ");
            self.word(&base.text);
        }
        self.word("\n");
    }

    fn names(&mut self, names: &[Name]) {
        self.list(names, ", ", |own, name| own.word(&name.text));
    }

    pub(super) fn decl(&mut self, decl: &Decl) {
        for doc in &decl.docs {
            self.word("/// ");
            self.word(doc);
            self.word("\n");
        }
        for annotation in &decl.annotations {
            self.annotation(annotation);
        }
        match &decl.body {
            Body::Attr(_) => self.word("attr "),
            Body::Const(_) => self.word("const "),
            Body::Function(_) | Body::Rule(_) => {}
        }
        match decl.role {
            Role::Plain => {}
            Role::Start => self.word("start "),
            Role::Extension => self.word("extension "),
        }
        self.word(&decl.name.text);
        if !decl.params.is_empty() {
            self.word("(");
            self.names(&decl.params);
            self.word(")");
        }
        if !decl.locals.is_empty() {
            self.word(" with ( ");
            self.list(&decl.locals, " ", |own, (name, value)| {
                own.word(&name.text);
                own.word(" := ");
                own.expr(value);
            });
            self.word(" )");
        }
        match &decl.body {
            Body::Attr(value) | Body::Const(value) | Body::Function(value) => {
                self.word(" = ");
                self.expr(value);
            }
            Body::Rule(ops) => {
                self.word(" -->");
                self.ops(ops);
            }
        }
    }
}
