//! Attributes of shapes.

use cga_lang::ops::{Needs, all_shape_attrs};

use super::check;
use super::functions::{on_shape, type_name, without_unused};

#[test]
fn attributes_are_up_to_date() {
    let (mut gets, mut material, mut sets) = (String::new(), String::new(), String::new());
    for row in all_shape_attrs() {
        let value = on_shape(row.needs, row.uses, &|needs| format!("get::{}({needs})", row.get));
        let (env, current) = match row.needs {
            Needs::Env => ("env", "_"),
            _ => ("env", "current"),
        };
        let (key, ty) = (row.name, type_name(row.ty()));
        let gets = if key.starts_with("material.") { &mut material } else { &mut gets };
        *gets += &format!(
            "{key:?} => FunctionCall::new(|stack, {env}, {current}| {{ let value = {value}; stack.push_{ty}(value); }}),"
        );
        if let Some(name) = row.set {
            sets += &format!(
                "{key:?} => Change::new(|stack, env, shape, _| {{ let value = stack.{ty}(); set::{name}(env, shape, value); }}),"
            );
        }
    }
    for (file, about, gets) in [
        ("get/shape.rs", "Reads of attributes of the current shape.", gets),
        ("get/material.rs", "Reads of attributes of the material.", material),
    ] {
        let body = format!(
            "use cga_runtime::rt::get;
        use crate::dispatch::FunctionCall;
        use crate::current::{{view, whole}};

        /// The read of an attribute, by its name.
        pub(crate) fn call(name: &str) -> Option<FunctionCall> {{
            Some(match name {{ {gets} _ => return None, }})
        }}"
        );
        check(file, about, &without_unused(&body));
    }
    let body = format!(
        "use cga_runtime::rt::set;
        use crate::dispatch::Change;

        /// The change of an attribute, by its name.
        pub(crate) fn call(name: &str) -> Option<Change> {{
            Some(match name {{ {sets} _ => return None, }})
        }}"
    );
    check("set.rs", "Changes of attributes of the current shape.", &body);
}
