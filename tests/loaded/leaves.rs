//! Leaves of rules that make no child.

use cga::{Grammar, RuleFile, Settings, Shape, cga};

const RULES: &str = "
    @StartRule Whole --> split(v, uvSpace, 1) { ~1 : Wall. }
    @StartRule Bracket --> [ split(v, uvSpace, 1) { ~1 : Wall. } ]
    @StartRule Branch --> [ case scope.sx > 1 : split(v, uvSpace, 1) { ~1 : Wall. } else : Wall. ]
    @StartRule Both --> [ split(v, uvSpace, 1) { ~1 : Wall. } ] [ Wall. ]
";

cga! {
    @Allow(split_without_uv)
    grammar Compiled = "
        @StartRule Whole --> split(v, uvSpace, 1) { ~1 : Wall. }
        @StartRule Bracket --> [ split(v, uvSpace, 1) { ~1 : Wall. } ]
        @StartRule Branch --> [ case scope.sx > 1 : split(v, uvSpace, 1) { ~1 : Wall. } else : Wall. ]
        @StartRule Both --> [ split(v, uvSpace, 1) { ~1 : Wall. } ] [ Wall. ]
    ";
}

/// A split without texture coordinates makes no part. A random grammar found the difference.
#[test]
fn a_bracket_is_a_child_if_its_steps_make_one() {
    let (compiled, loaded) = (Compiled::default(), RuleFile::from_text(RULES).expect("good rules"));
    for (start, leaf) in [("Whole", "Whole"), ("Bracket", "Bracket"), ("Branch", "Branch"), ("Both", "Wall")] {
        for grammar in [&compiled as &dyn Grammar, &loaded] {
            let settings = Settings { start: Some(start.to_owned()), ..Settings::default() };
            let model = grammar.generate_with(&Shape::rectangle(3.0, 2.0), &settings).expect("no limit");
            assert_eq!(model.counts(), [(leaf, 1)], "{start}");
        }
    }
}
