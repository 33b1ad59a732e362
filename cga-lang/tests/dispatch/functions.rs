//! Functions of the language.

use std::collections::BTreeMap;

use cga_lang::ir::Type;
use cga_lang::ops::{Function, Needs, Uses, all_functions};

use super::{Arguments, arguments, check};

/// The file of a function's code.
fn file(row: &Function) -> (&'static str, &'static str) {
    match row.needs {
        _ if row.name == "setElems" => match row.ty {
            Type::Texts => ("functions/set_texts.rs", "Calls of `setElems` on arrays of texts."),
            Type::Bools => ("functions/set_bools.rs", "Calls of `setElems` on arrays of truth values."),
            _ => ("functions/set_floats.rs", "Calls of `setElems` on arrays of numbers."),
        },
        Needs::Nothing => ("functions/plain.rs", "Calls of functions of their arguments alone."),
        Needs::Env if row.ty.is_array() => {
            ("functions/arrays.rs", "Calls of functions that read the run and make an array.")
        }
        Needs::Env => ("functions/run.rs", "Calls of functions that read the run and make a single value."),
        Needs::Shape | Needs::Both | Needs::Component => {
            ("functions/shape.rs", "Calls of functions that read the current shape.")
        }
    }
}

/// The name of the type of a value, in names of functions.
pub(crate) fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Float => "float",
        Type::Bool => "bool",
        Type::Text => "text",
        Type::Floats => "floats",
        Type::Bools => "bools",
        Type::Texts => "texts",
    }
}

/// A call with the shape in the form that its uses need.
pub(crate) fn on_shape(needs: Needs, uses: Uses, call: &dyn Fn(&str) -> String) -> String {
    let form = if uses.has(Uses::BODY) { "whole" } else { "view" };
    match needs {
        Needs::Nothing => call(""),
        Needs::Env => call("env,"),
        Needs::Shape => format!("{form}!(env, current, |shape| {})", call("shape,")),
        Needs::Both => format!("{form}!(env, current, |shape| {})", call("env, shape,")),
        Needs::Component => format!("candidate!(current, |candidate| {})", call("candidate,")),
    }
}

#[test]
fn functions_are_up_to_date() {
    let mut files: BTreeMap<(&str, &str), BTreeMap<String, String>> = BTreeMap::new();
    for row in all_functions() {
        let (name, key) = (row.run, row.key());
        let Arguments { known, taken, passed } = arguments(row.params, "func");
        let value = on_shape(row.needs, row.uses, &|needs| format!("func::{name}({needs} {passed})"));
        let (env, current) = match row.needs {
            Needs::Nothing => ("_", "_"),
            Needs::Env => ("env", "_"),
            Needs::Component => ("_", "current"),
            Needs::Shape | Needs::Both => ("env", "current"),
        };
        let ty = type_name(row.ty);
        let run = format!("{taken} let value = {value}; stack.push_{ty}(value);");
        let code = format!("{key:?} => {{ {known} FunctionCall::new(move |stack, {env}, {current}| {{ {run} }}) }}");
        files.entry(file(row)).or_default().insert(key, code);
    }
    for ((file, about), arms) in files {
        let arms: String = arms.into_values().collect();
        let body = format!(
            "use cga_lang::ir::Expr;
            use cga_runtime::rt::func;
            use crate::dispatch::{{FunctionCall, Known as _, words}};
            use crate::current::{{candidate, view, whole}};

            /// The call of a function of this group, by the key of its row.
            pub(super) fn call(key: &str, known: &[Expr]) -> Option<FunctionCall> {{
                Some(match key {{ {arms} _ => return None, }})
            }}"
        );
        check(file, about, &without_unused(&body));
    }
}

/// The code without imports that it does not use.
pub(crate) fn without_unused(body: &str) -> String {
    let mut body = body.to_owned();
    for (name, used, import) in [
        ("candidate, ", "candidate!", "candidate, "),
        ("view, ", "view!", "view, "),
        (", whole}", "whole!", ", whole}"),
        (", words}", "words::", ", words}"),
        ("Known as _", "known.", ", Known as _"),
    ] {
        if body.contains(name) && !body.contains(used) {
            let kept = if import.ends_with('}') { "}" } else { "" };
            body = body.replacen(import, kept, 1);
        }
    }
    body = body.replace("use crate::current::{view};", "use crate::current::view;");
    if !body.contains("view!") && !body.contains("whole!") && !body.contains("candidate!") {
        body = body.lines().filter(|line| !line.contains("use crate::current::")).collect::<Vec<_>>().join("\n");
    }
    if !body.contains("known.") {
        body = body.replacen("known: &[", "_: &[", 1);
    }
    body
}
