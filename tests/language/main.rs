//! The language beyond splits and comps. Rules are text unless a test says otherwise; `sources.rs` compares inline rules,
//! text and files.
//!
//! The runtime tests the table of reports.
#![allow(deprecated, reason = "rules at the edges of what makes sense: findings are warnings of this kind")]

mod arrays;
mod attributes;
mod chance;
mod context;
mod deep;
mod defaults;
mod district;
mod dynamic;
mod facts;
mod failed_booleans;
mod functions;
mod geo_coord;
mod grammar;
mod host;
mod hygiene;
mod imports;
mod inline;
#[cfg(feature = "serde")]
mod json;
mod lazy;
mod locals;
mod lots;
mod occluders;
mod occlusion;
mod old_names;
mod old_spellings;
mod operations;
mod operators;
mod overloads;
mod panel;
mod party_walls;
mod prints;
mod queries;
mod recompose;
mod reconnected;
mod run;
mod scene;
mod scene_facts;
mod scene_hostile;
mod scene_laws;
mod scene_session;
mod scene_shared;
mod scene_streams;
mod set_by_name;
mod shape_tree;
mod shared;
mod sources;
mod stopping;
mod styles;
mod text;
mod tiny;
mod tree_keys;
mod values;

use cga::{Array, Grammar, Model, Shape, Text, Value};

/// A lot of 2 by 2.
fn lot() -> Shape {
    Shape::rectangle(2.0, 2.0)
}

/// The model of the default start rule; nothing went wrong.
fn model(grammar: &dyn Grammar) -> Model {
    clean(grammar.generate(&lot()).expect("a model"))
}

/// The model of a start rule by name; nothing went wrong.
fn model_of(grammar: &dyn Grammar, start: &str) -> Model {
    let settings = cga::Settings { start: Some(start.to_owned()), ..cga::Settings::default() };
    clean(grammar.generate_with(&lot(), &settings).expect("a model"))
}

fn clean(model: Model) -> Model {
    assert_eq!(model.faults(), []);
    model
}

/// The sum of the reports under a key.
fn sum(model: &Model, key: &str) -> Option<f64> {
    model.reported(key).map(|it| it.summary().sum)
}

/// The rules of the leaves.
fn leaves(model: &Model) -> Vec<&str> {
    model.leaves().map(|leaf| leaf.rule()).collect()
}

/// The texts of all prints.
fn lines(model: &Model) -> Vec<String> {
    model.prints().iter().map(|line| line.to_string()).collect()
}

/// The printed values, as rules would write them: `[1,2;3,4]`, `"text"`.
fn written(model: &Model) -> Vec<String> {
    model.prints().iter().map(|line| write(&line.value)).collect()
}

fn write(value: &Value) -> String {
    fn rows<T: Clone + Into<Value>>(array: &Array<T>) -> String {
        let rows =
            array.iter_rows().map(|row| row.iter().map(|entry| write(&entry.clone().into())).collect::<Vec<_>>());
        format!("[{}]", rows.map(|row| row.join(",")).collect::<Vec<_>>().join(";"))
    }
    let quoted = |text: &Text| format!("{:?}", text.as_str());
    match value {
        Value::Text(text) => quoted(text),
        Value::Floats(array) => rows(array),
        Value::Bools(array) => rows(array),
        Value::Texts(array) => rows(array),
        single => single.to_string(),
    }
}

/// Expressions and what each is, as rules would write it; declarations they need come first. An attribute of the shape
/// stands between them and the compiler where something could be computed beforehand: `one` is 1, `zero` is 0.
macro_rules! each_is {
    ($declarations:tt $($expression:tt => $value:tt,)*) => {{
        cga::cga! {
            grammar Values = concat!(
                "one = scope.sx / 2 zero = scope.sx - 2 ", $declarations,
                " Lot --> ", $("print(", $expression, ") ",)* " X."
            );
        }
        let model = crate::model(&Values::default());
        let expressions: &[&str] = &[$($expression),*];
        let expected: &[&str] = &[$($value),*];
        let found = crate::written(&model);
        assert_eq!(found.len(), expected.len());
        for ((expression, expected), found) in expressions.iter().zip(expected).zip(&found) {
            assert_eq!(found, expected, "{expression}");
        }
    }};
}
use each_is;

/// Rules that a test only runs, as text: they are loaded when the test runs, because compiled rules take the compiler a tenth of a second a grammar. The
/// name has the function `default` alone. The feature `compiled` compiles them.
#[cfg(not(feature = "compiled"))]
macro_rules! rules {
    ($(@Allow($finding:ident))? grammar $name:ident = $rules:expr;) => {
        struct $name;

        impl $name {
            fn default() -> cga::RuleFile {
                static RULES: std::sync::LazyLock<cga::RuleFile> =
                    std::sync::LazyLock::new(|| crate::loaded(stringify!($name), $rules));
                RULES.clone()
            }
        }
    };
}
#[cfg(feature = "compiled")]
use cga::cga as rules;
#[cfg(not(feature = "compiled"))]
use rules;

/// A grammar that is loaded. Its files are in the folder of the tests.
#[cfg(not(feature = "compiled"))]
fn loaded(name: &str, rules: &str) -> cga::RuleFile {
    let loader = cga::RuleFile::loader().named(name).root(env!("CARGO_MANIFEST_DIR"));
    loader.text(rules).unwrap_or_else(|error| panic!("{name}: {error}"))
}
