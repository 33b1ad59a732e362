//! The trees of loaded rules have the arguments of the rules.

use cga_eval::RuleFile;
use cga_runtime::grammar::Grammar;
use cga_runtime::run::settings::Settings;
use cga_runtime::shape::Shape;
use cga_runtime::value::Value;

#[test]
fn shapes_have_the_arguments_of_their_rules() {
    let text = "Lot --> extrude(6) split(y) { ~3 : Floor(split.index, \"f\" + split.index, split.index == 1) }*\n\
                Floor(number, name, isTop) with ( half := number / 2 ) --> Part([number, half]) Cap.\n\
                Part(list) --> case size(list) < 3 : X. else : Part(list)";
    let rules = RuleFile::from_text(text).expect("the rules are right");
    let settings = Settings { tree: true, ..Settings::default() };
    let model = rules.generate_with(&Shape::rectangle(4.0, 5.0), &settings).expect("a model");
    let tree = model.buildings().next().and_then(|(building, _)| building.tree.clone()).expect("a tree");
    let shown = |key: &str| {
        let node = tree.find(key).expect("a shape");
        let values: Vec<String> = node.arguments().iter().map(Value::to_string).collect();
        format!("{}({})", node.rule(), values.join(", "))
    };
    assert_eq!(shown("0;"), "Lot()");
    assert_eq!([shown("0;0;"), shown("0;1;")], ["Floor(0, f0, false)", "Floor(1, f1, true)"]);
    assert_eq!([shown("0;1;0;"), shown("0;1;1;")], ["Part((2)[1,0.5])", "Cap()"]);
    assert_eq!(shown("0;1;0;0;"), "X()");
}
