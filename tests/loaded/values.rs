//! Values that Rust functions return count for the limit of bytes.

use cga::{Array, Error, Grammar, LimitKind, Limits, Model, RuleFile, Settings, Shape, Text, Value};

/// Each rule calls a function a hundred times, and all calls hold their values at once.
const RULES: &str = r#"
@StartRule
Text --> Text(0)
@StartRule
List --> List(0)
@StartRule
Texts --> Texts(0)
@StartRule
Short --> Short(0)
Text(n) --> case n < 100 : HeldText(crate::long_text(100000), n) else : X.
HeldText(text, n) --> [ Text(n + 1) ] Told(text)
List(n) --> case n < 100 : HeldList(crate::long_list(6250), n) else : X.
HeldList(list, n) --> [ List(n + 1) ] Told("" + list[0])
Texts(n) --> case n < 100 : HeldTexts(crate::long_texts(50000), n) else : X.
HeldTexts(texts, n) --> [ Texts(n + 1) ] Told(texts[0])
Short(n) --> case n < 100 : HeldShort(crate::long_text(200), n) else : X.
HeldShort(text, n) --> [ Short(n + 1) ] Told(text)
Told(text) --> case text == "" : Y. else : X.
"#;

fn rules() -> RuleFile {
    fn length(arguments: &[Value]) -> usize {
        let [Value::Float(length)] = arguments else { panic!("a number") };
        *length as usize
    }
    let text = |length: usize| Text::from("x".repeat(length));
    let list = |length: usize| Value::Floats(Array::from(vec![1.0; length]));
    RuleFile::loader()
        .with_function("crate::long_text", move |arguments| Value::Text(text(length(arguments))))
        .with_function("crate::long_list", move |arguments| list(length(arguments)))
        .with_function("crate::long_texts", move |arguments| {
            Value::Texts(Array::from(vec![text(length(arguments)), text(length(arguments))]))
        })
        .text(RULES)
        .unwrap_or_else(|error| panic!("{error}"))
}

fn run(rules: &RuleFile, start: &str, bytes: u64) -> Result<Model, Error> {
    let limits = Limits { bytes, ..Limits::default() };
    let settings = Settings { start: Some(start.to_owned()), limits, ..Settings::default() };
    rules.generate_with(&Shape::rectangle(1.0, 1.0), &settings)
}

/// The limits are the ones of compiled rules in `tests/language/stopping.rs`.
#[test]
fn results_of_rust_functions_have_a_limit_in_all() {
    let rules = rules();
    for start in ["Text", "List", "Texts"] {
        assert!(run(&rules, start, 11_000_000).is_ok(), "{start}");
        let error = run(&rules, start, 9_000_000).expect_err("10 MB of values");
        assert!(matches!(error, Error::Limit { what: LimitKind::Bytes, .. }), "{start}: {error}");
    }
    // 200 bytes a call do not count.
    assert!(run(&rules, "Short", 100_000).is_ok());
}
