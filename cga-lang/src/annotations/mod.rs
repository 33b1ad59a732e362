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
use crate::resolve::globals::Declared;
use crate::resolve::info::{Hidden, ImportInfo, RuleInfo};
use crate::span::Span;
use crate::suggest::nearest;
use crate::syntax::ast::{Annotation, Ast, Body, Decl, Import, Role};
use crate::syntax::words::ANNOTATIONS;
use arguments::wrong;
use notes::Notes;
use std::collections::HashMap;

/// The target of annotations.
#[derive(Clone, Copy)]
enum Annotated<'a> {
    Import(&'a Import),
    Decl(&'a Decl),
    /// The file or a style.
    Other,
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
        for (decl, mut info) in file(cx, &instance.file.ast, import.group) {
            let Some(&index) = by_name.get(&(id, decl.name.id())) else { continue };
            info.hidden |=
                hidden[id] || matches!(&import.hidden, Hidden::Names(names) if names.contains(&decl.name.text));
            cx.tables.attrs[index] = info;
        }
        if program.roots.contains(&id) {
            let start = start_rule(cx);
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

/// Reads the annotations of a file and returns the annotations of its attributes. `group` is the group at the place of its import.
fn file<'a>(cx: &mut Context, ast: &'a Ast, mut group: AttrGroup) -> Vec<(&'a Decl, AttrInfo)> {
    let mut attrs = Vec::new();
    // The head comes first.
    let mut places: Vec<(Span, &[Annotation], Annotated<'_>)> = vec![(Span::default(), &ast.head, Annotated::Other)];
    places.extend(ast.imports.iter().map(|own| (own.span, &*own.annotations, Annotated::Import(own))));
    places.extend(ast.styles.iter().map(|own| (own.name.span, &*own.annotations, Annotated::Other)));
    places.extend(ast.decls.iter().map(|own| (own.span, &*own.annotations, Annotated::Decl(own))));
    places.sort_by_key(|(span, ..)| *span);
    for (_, annotations, place) in places {
        let mut notes = Notes::default();
        for annotation in annotations {
            let (Some(name), Some(args)) = (known(cx, annotation), &annotation.args) else { continue };
            notes.read(cx, name, annotation.name.span, args, &mut group);
        }
        let is_rule = matches!(place, Annotated::Decl(Decl { body: Body::Rule(_), .. }));
        if let Some(span) = notes.start.filter(|_| !is_rule) {
            wrong(cx, span, "only a rule can be the start rule").help("move it before the rule that begins a model");
        }
        if let Some(span) = notes.names.filter(|_| !matches!(place, Annotated::Import(_))) {
            wrong(cx, span, "`@Hidden` takes names before an import only");
        }
        match place {
            Annotated::Import(import) => {
                let info = ImportInfo { hidden: notes.hidden, group: group.clone() };
                cx.tables.imports.insert((cx.at, import.id.id()), info);
            }
            Annotated::Decl(decl) => match &decl.body {
                Body::Attr(_) => {
                    let info = notes.attribute(cx, decl, &group);
                    attrs.push((decl, info));
                }
                Body::Rule(_) => {
                    if let Some(span) = notes.start.filter(|_| !decl.params.is_empty()) {
                        no_start(cx, decl, span);
                    }
                    let info = RuleInfo {
                        doc: notes.doc(decl),
                        marked: notes.start.is_some() || decl.role == Role::Start,
                        hidden: notes.hidden == Hidden::All,
                    };
                    cx.tables.rules.insert((cx.at, decl.name.id()), info);
                }
                _ => {}
            },
            Annotated::Other => {}
        }
    }
    attrs
}

/// Reports `@StartRule` before a rule with parameters.
fn no_start(cx: &mut Context, decl: &Decl, span: Span) {
    let name = &decl.name.text;
    let values = vec!["…"; decl.params.len()].join(", ");
    let outer = if name == "Lot" { "Site" } else { "Lot" };
    wrong(cx, span, format!("`{name}` has parameters, so a run cannot begin with it"))
        .help(format!("mark a rule that calls it, such as `{outer} --> {name}({values})`"));
}

/// The rule marked with `start`, otherwise the first annotated rule of the nearest style, otherwise the first rule. It
/// has no parameters.
fn start_rule(cx: &mut Context) -> Option<u32> {
    let (root, styles) = (cx.at, &cx.globals.program.instances[cx.at].styles);
    let own = |item: &Declared| item.instance == root && item.home == root && !item.decl.name.text.contains('.');
    let rules: Vec<(usize, &Declared)> = cx.globals.rules.iter().enumerate().filter(|(_, item)| own(item)).collect();
    let free = || rules.iter().filter(|(_, item)| item.decl.params.is_empty());
    let is_marked = |item: &Declared| cx.tables.rules.get(&item.key()).is_some_and(|info| info.marked);
    let found = free()
        .find(|(_, item)| item.decl.role == Role::Start)
        .or_else(|| free().filter(|(_, item)| is_marked(item)).min_by_key(|(_, item)| styles.rank(item.decl.style)))
        .or_else(|| free().next())
        .map(|(index, _)| *index as u32);
    if let (None, Some((_, first))) = (found, rules.first()) {
        let name = &first.decl.name;
        let message = format!("`{}` has parameters, and so has every rule: no run can begin", name.text);
        let values = vec!["…"; first.decl.params.len()].join(", ");
        cx.diags
            .report(Code::NoStartRule, name.span, message)
            .help(format!("write a rule without any, such as `Lot --> {}({values})`", name.text));
    }
    found
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
        cx.diags.report(Code::UnknownAnnotation, span, message).help(format!("write `@{known}`"));
        return Some(known);
    }
    cx.diags
        .report(Code::UnknownAnnotation, span, format!("unknown annotation `@{name}`"))
        .suggest(nearest(name, ANNOTATIONS.iter().copied()).map(|near| format!("@{near}")));
    None
}

#[cfg(test)]
mod tests {
    use crate::compile::{compile, compile_text};
    use crate::link::tests::{Library, unit};

    #[test]
    fn what_stands_before_an_import_is_said_of_it() {
        for (before, expected) in
            [("", [false, false]), ("@Hidden", [true, true]), ("@Hidden(b, \"c\")", [false, true])]
        {
            let text = format!(
                "@Group(\"A\") attr x = 1 {before} @Group(\"B\") import lib : \"lib.cga\" attr y = 1 Lot --> lib.Lot"
            );
            let library = "attr a = 1  attr b = 2  @Group(\"C\") attr c = 3  Lot --> t(a, b, c)";
            let compiled = compile(unit("a.cga", &text), &mut Library(library), &[]);
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
