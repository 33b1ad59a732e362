//! Operations of the language.

use std::collections::BTreeMap;

use cga_lang::ops::{Braces, Changes, Operation, Uses, all_operations};

use super::functions::without_unused;
use super::{Arguments, arguments, check, words};

/// A form of operations with a file of its own.
struct Form {
    file: &'static str,
    about: &'static str,
    /// The type of the calls.
    ty: &'static str,
    /// The arguments of the closure, which has the operation's own arguments.
    closure: &'static str,
    /// The call, with `NAME` for the function and `ARGS` for its arguments.
    call: &'static str,
    has: fn(&Operation) -> bool,
}

/// Operations whose geometry comes from the scope or a file, which have a file of their own because there are many.
fn makes(row: &Operation) -> bool {
    matches!(row.changes, Changes::Whole)
        && (row.name.starts_with("primitive") || row.name.starts_with("roof") || row.name.starts_with("envelope"))
}

const FORMS: &[Form] = &[
    Form {
        file: "operations/made.rs",
        about: "Calls of operations that make primitives, roofs and envelopes.",
        ty: "Change",
        closure: "stack, env, shape, BASE",
        call: "op::NAME(env, shape, FURTHER ARGS)",
        has: |row| row.braces == Braces::None && makes(row),
    },
    Form {
        file: "operations/whole.rs",
        about: "Calls of operations that change a whole shape.",
        ty: "Change",
        closure: "stack, env, shape, BASE",
        call: "op::NAME(env, shape, FURTHER ARGS)",
        has: |row| row.braces == Braces::None && row.changes != Changes::Nothing && !makes(row),
    },
    Form {
        file: "operations/slim.rs",
        about: "Calls of operations that change a slim shape.",
        ty: "SlimCall",
        closure: "stack, env, shape, bases, own",
        call: "slim::NAME(env, shape, bases, own, ARGS)",
        has: |row| row.braces == Braces::None && row.changes == Changes::Scope,
    },
    Form {
        file: "operations/says.rs",
        about: "Calls of operations that give information to the run.",
        ty: "FunctionCall",
        closure: "stack, env, current",
        call: "view!(env, current, |shape| op::NAME(env, shape, ARGS))",
        has: |row| row.braces == Braces::None && row.changes == Changes::Nothing,
    },
    Form {
        file: "operations/arms.rs",
        about: "Calls of operations with arms.",
        ty: "ArmsCall",
        closure: "stack, cx, shape, number, arms, when, visit",
        call: "rt::divide(cx, shape, number, arms, when, |env, arms| op::NAME(env, arms, ARGS), visit)",
        has: |row| matches!(row.braces, Braces::Arms(_)),
    },
    Form {
        file: "operations/sections.rs",
        about: "Calls of operations with sections.",
        ty: "SectionsCall",
        closure: "stack, cx, shape, number, pattern, rest, depth, visit",
        call: "rt::sections(cx, shape, number, pattern, rest, depth, |env, sections| op::NAME(env, sections, ARGS), visit)",
        has: |row| row.braces == Braces::Sections,
    },
    Form {
        file: "operations/each.rs",
        about: "Calls of operations with the same successor for each part.",
        ty: "EachCall",
        closure: "stack, cx, shape, number, visit",
        call: "rt::each(cx, shape, number, |env, shape| op::NAME(env, shape, ARGS), visit)",
        has: |row| row.braces == Braces::Ops,
    },
    Form {
        file: "operations/operands.rs",
        about: "Calls of operations with operands.",
        ty: "OperandsCall",
        closure: "stack, env, shape, operands",
        call: "op::NAME(env, shape, operands.try_into().unwrap_or_default(), ARGS)",
        has: |row| matches!(row.braces, Braces::Operands | Braces::Inline | Braces::Modified),
    },
];

#[test]
fn operations_are_up_to_date() {
    for form in FORMS {
        let mut arms: BTreeMap<String, String> = BTreeMap::new();
        for row in all_operations().filter(|row| (form.has)(row)) {
            let (name, key) = (row.run, row.key());
            let Arguments { known, taken, passed } = arguments(row.params, words::module(row.braces));
            let (base, further) = if row.uses_base { ("base", "base,") } else { ("_", "") };
            let call = form.call.replace("NAME", name).replace("FURTHER", further).replace("ARGS", &passed);
            let is_whole = row.uses.has(Uses::BODY) && row.changes == Changes::Nothing;
            let call = if is_whole && !row.uses.has(Uses::LABELS) { call.replace("view!", "whole!") } else { call };
            let mut closure = form.closure.replace("BASE", base);
            if taken.is_empty() {
                closure = closure.replacen("stack", "_", 1);
            }
            arms.insert(
                key.clone(),
                format!("{key:?} => {{ {known} {}::new(move |{closure}| {{ {taken} {call} }}) }}", form.ty),
            );
        }
        let (arms, ty): (String, &str) = (arms.into_values().collect(), form.ty);
        let mut imports = Vec::new();
        for (word, import) in [("op::", "op"), ("slim::", "slim"), ("rt::", "rt")] {
            if arms.contains(word) && import != "rt" {
                imports.push(import);
            }
        }
        let rt = if arms.contains("rt::") {
            "rt::{self, op}".to_owned()
        } else {
            format!("rt::{}", imports.last().expect("a module"))
        };
        let body = format!(
            "use cga_lang::ir::Arg;
            use cga_runtime::{rt};
            use crate::dispatch::{{{ty}, Known as _, words}};
            use crate::current::{{view}};

            /// The call of an operation of this form, by the key of its row.
            pub(crate) fn call(key: &str, known: &[Arg]) -> Option<{ty}> {{
                Some(match key {{ {arms} _ => return None, }})
            }}"
        );
        check(form.file, form.about, &without_unused(&body));
    }
}
