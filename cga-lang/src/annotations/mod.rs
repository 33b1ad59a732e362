//! Annotations of attributes, imports and rules (*annotations*).
//!
//! Annotations describe and generate nothing. Unclear annotations are reported and ignored.

mod arguments;
mod limits;
mod notes;

use crate::diag::code::Code;
use crate::ir::{AttrGroup, AttrInfo};
use crate::link::{InstanceId, Key, Program};
use crate::resolve::context::Context;
use crate::resolve::globals::Item;
use crate::resolve::info::{Hidden, ImportInfo, RuleInfo};
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{Annotation, Ast, Body, Decl, Import, Role, Style};
use crate::syntax::words::ANNOTATIONS;
use arguments::wrong;
use notes::Notes;
use std::collections::HashMap;

/// The possible places of annotations.
enum Annotated<'a> {
    Head(&'a [Annotation]),
    Import(&'a Import),
    Style(&'a Style),
    Decl(&'a Decl),
}

impl<'a> Annotated<'a> {
    fn annotations(&self) -> &'a [Annotation] {
        match self {
            Annotated::Head(annotations) => annotations,
            Annotated::Import(import) => &import.annotations,
            Annotated::Style(style) => &style.annotations,
            Annotated::Decl(decl) => &decl.annotations,
        }
    }

    fn span(&self) -> Span {
        match self {
            // Before all other places.
            Annotated::Head(_) => Span::default(),
            Annotated::Import(import) => import.span,
            Annotated::Style(style) => style.name.span,
            Annotated::Decl(decl) => decl.span,
        }
    }
}

pub(crate) fn read(cx: &mut Context) {
    let program = cx.globals.program;
    cx.tables.attrs = vec![AttrInfo::default(); cx.globals.attrs.len()];
    let by_name: HashMap<Key, usize> =
        cx.globals.attrs.iter().enumerate().map(|(index, item)| (item.key(), index)).collect();
    let mut hidden = vec![false; program.instances.len()];
    // Importing files come before imported files.
    for (id, instance) in program.instances.iter().enumerate() {
        cx.at = id;
        let import = instance.parent.and_then(|parent| from(program, parent, id));
        let import = import.and_then(|import| cx.tables.imports.get(&import).cloned()).unwrap_or_default();
        hidden[id] = import.hidden == Hidden::All || instance.parent.is_some_and(|parent| hidden[parent]);
        let start = file(cx, &instance.file.ast, import.group, &mut |cx, decl, mut info: AttrInfo| {
            let Some(&index) = by_name.get(&(id, decl.name.id())) else { return };
            info.hidden |=
                hidden[id] || matches!(&import.hidden, Hidden::Names(names) if names.contains(&decl.name.text));
            cx.tables.attrs[index] = info;
        });
        if program.roots.contains(&id) {
            let start = start.rule_of(cx);
            cx.tables.starts.push(start);
        }
    }
}

/// The import that an instance comes from.
fn from(program: &Program, parent: InstanceId, id: InstanceId) -> Option<Key> {
    let instance = &program.instances[parent];
    let mut imports = instance.file.ast.imports.iter();
    let import = imports.find(|import| instance.imports.get(&import.id.text) == Some(&Some(id)))?;
    Some((parent, import.id.id()))
}

/// Reads the annotations of a file. `group` is the group at the place of its import.
fn file<'a>(
    cx: &mut Context,
    ast: &'a Ast,
    mut group: AttrGroup,
    keep: &mut dyn FnMut(&mut Context, &'a Decl, AttrInfo),
) -> Starts {
    let mut places: Vec<Annotated<'_>> = vec![Annotated::Head(&ast.head)];
    places.extend(ast.imports.iter().map(Annotated::Import));
    places.extend(ast.styles.iter().map(Annotated::Style));
    places.extend(ast.decls.iter().map(Annotated::Decl));
    places.sort_by_key(Annotated::span);
    let mut starts = Starts::default();
    for place in places {
        let mut notes = Notes::default();
        for annotation in place.annotations() {
            let (Some(name), Some(args)) = (known(cx, annotation), &annotation.args) else { continue };
            notes.read(cx, name, annotation.name.span, args, &mut group);
        }
        let is_rule = matches!(place, Annotated::Decl(Decl { body: Body::Rule(_), .. }));
        if let Some(span) = notes.start.filter(|_| !is_rule) {
            wrong(cx, span, "only a rule can be the start rule".into())
                .help("move it before the rule that begins a model");
        }
        if let Some(span) = notes.names.filter(|_| !matches!(place, Annotated::Import(_))) {
            wrong(cx, span, "`@Hidden` takes names before an import only".into());
        }
        match place {
            Annotated::Import(import) => {
                let info = ImportInfo { hidden: notes.hidden, group: group.clone() };
                cx.tables.imports.insert((cx.at, import.id.id()), info);
            }
            Annotated::Decl(decl) => match &decl.body {
                Body::Attr(_) => {
                    let info = notes.attribute(cx, decl, &group);
                    keep(cx, decl, info);
                }
                Body::Rule(_) => {
                    starts.rule(cx, decl, notes.start);
                    let info = RuleInfo {
                        doc: notes.doc(decl),
                        marked: notes.start.is_some() || decl.role == Role::Start,
                        hidden: notes.hidden == Hidden::All,
                    };
                    cx.tables.rules.insert((cx.at, decl.name.id()), info);
                }
                _ => {}
            },
            Annotated::Head(_) | Annotated::Style(_) => {}
        }
    }
    starts
}

/// The search for the start rule.
#[derive(Default)]
struct Starts {
    /// The id of the name of the first `@StartRule` rule, by style.
    first: HashMap<u32, u32>,
}

impl Starts {
    fn rule(&mut self, cx: &mut Context, decl: &Decl, start: Option<Span>) {
        let Some(span) = start else { return };
        if !decl.params.is_empty() {
            let message = format!("`{}` has parameters, so a run cannot begin with it", decl.name.text);
            let name = &decl.name.text;
            let values = vec!["…"; decl.params.len()].join(", ");
            let outer = if name == "Lot" { "Site" } else { "Lot" };
            wrong(cx, span, message).help(format!("mark a rule that calls it, such as `{outer} --> {name}({values})`"));
            return;
        }
        // All annotated rules can be started. A run begins with the first one, or with the first one of its style.
        self.first.entry(decl.style).or_insert(decl.name.id());
    }

    /// The rule marked with `start`, otherwise the annotated rule of the nearest style, otherwise the first rule. It
    /// has no parameters.
    fn rule_of(self, cx: &mut Context) -> Option<u32> {
        let (root, styles) = (cx.at, &cx.globals.program.instances[cx.at].styles);
        let own = |item: &Item| item.instance == root && item.home == root && !item.decl.name.text.contains('.');
        let rules = cx.globals.rules.iter().enumerate().filter(|(_, item)| own(item));
        let rules: Vec<(usize, &Item)> = rules.collect();
        let free = || rules.iter().filter(|(_, item)| item.decl.params.is_empty());
        let annotated = |item: &Item| {
            let name = self.first.get(&item.decl.style)?;
            (*name == item.decl.name.id()).then(|| styles.rank(item.decl.style)).flatten()
        };
        let found = free()
            .find(|(_, item)| item.decl.role == Role::Start)
            .or_else(|| {
                free()
                    .filter_map(|found| Some((annotated(found.1)?, found)))
                    .min_by_key(|(rank, _)| *rank)
                    .map(|(_, found)| found)
            })
            .or_else(|| free().next())
            .map(|(index, _)| *index as u32);
        if let (None, Some((_, first))) = (found, rules.first()) {
            let message = format!("`{}` has parameters, and so has every rule: no run can begin", first.decl.name.text);
            let diag = cx.diags.report(Code::NoStartRule, first.decl.name.span, message);
            let values = vec!["…"; first.decl.params.len()].join(", ");
            diag.help(format!("write a rule without any, such as `Lot --> {}({values})`", first.decl.name.text));
        }
        found
    }
}

/// The official name of an annotation.
fn known(cx: &mut Context, annotation: &Annotation) -> Option<&'static str> {
    let name = annotation.name.text.as_str();
    if let Some(known) = ANNOTATIONS.iter().find(|&&known| known == name) {
        return Some(known);
    }
    let span = annotation.name.span;
    // *CGA changelog 2019.1*: other capitals are a warning, and the annotation counts.
    if let Some(known) = ANNOTATIONS.iter().find(|known| known.eq_ignore_ascii_case(name)) {
        let message = format!("annotation `@{name}` is written `@{known}`");
        cx.diags.report(Code::UnknownAnnotation, span, message);
        return Some(known);
    }
    cx.diags
        .report(Code::UnknownAnnotation, span, format!("unknown annotation `@{name}`"))
        .suggest(nearest(name, ANNOTATIONS.iter().copied()).map(|near| format!("@{near}")));
    None
}

#[cfg(test)]
mod tests {
    use crate::compile::{Dialect, compile, compile_text};
    use crate::link::{Files, Unit};
    use crate::syntax::lex::lex;

    /// A provider with one library for all paths.
    struct Library(&'static str);

    impl Files for Library {
        fn open(&mut self, path: &str, _: &str) -> Result<Unit, String> {
            let lexed = lex(self.0);
            Ok(Unit { name: path.into(), tokens: lexed.tokens, dialect: Dialect::Text, found: lexed.diags })
        }
    }

    #[test]
    fn what_stands_before_an_import_is_said_of_it() {
        for (before, expected) in
            [("", [false, false]), ("@Hidden", [true, true]), ("@Hidden(b, \"c\")", [false, true])]
        {
            let text = format!(
                "@Group(\"A\") attr x = 1 {before} @Group(\"B\") import lib : \"lib.cga\" attr y = 1 Lot --> lib.Lot"
            );
            let lexed = lex(&text);
            let root = Unit { name: "a.cga".into(), tokens: lexed.tokens, dialect: Dialect::Text, found: lexed.diags };
            let library = "attr a = 1  attr b = 2  @Group(\"C\") attr c = 3  Lot --> t(a, b, c)";
            let compiled = compile(root, &mut Library(library), &[]);
            assert_eq!(compiled.diags, []);
            let grammar = compiled.grammar.expect("no error");
            let shown: Vec<(&str, &str, bool)> = grammar
                .globals
                .iter()
                .filter_map(|global| Some((global, global.attr.as_ref()?)))
                .map(|(global, attr)| (global.name.as_str(), attr.group.names[0].as_str(), attr.hidden))
                .collect();
            // The group continues after the import.
            let [first, second] = expected;
            let imported = [("lib.a", "B", first), ("lib.b", "B", second), ("lib.c", "C", second)];
            assert_eq!(shown, [[("x", "A", false), ("y", "B", false)].as_slice(), &imported].concat());
        }
    }

    #[test]
    fn each_style_may_have_a_start_rule() {
        for style in ["", "style S"] {
            let source = compile_text(&format!("@StartRule A --> NIL {style} @StartRule B --> NIL"));
            assert_eq!(source.compiled.diags, []);
            let grammar = source.compiled.grammar.expect("no error");
            let default = |style| grammar.starts.iter().find(|start| start.style == style).map(|start| &*start.name);
            assert_eq!(default(0), Some("A"));
            assert_eq!(default(1), (!style.is_empty()).then_some("S$B"));
        }
    }
}
