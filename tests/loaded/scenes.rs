//! The scenes of the gallery give the same bytes, compiled and loaded.

use std::collections::BTreeSet;

use cga::{Grammar, RuleFile, Settings};
use cga_tests::inline;
use cga_tests::outcome::{bytes, outcome};
use cga_tests::scenes::{Scene, scenes};

/// The rules of a scene, loaded.
fn loaded(scene: &Scene) -> RuleFile {
    let rules = format!("cga! {{\n{}\n}}", scene.rules);
    let grammar = inline::grammars(&rules).swap_remove(0);
    let loaded = RuleFile::loader().named(scene.grammar.name()).text(&grammar.rules);
    loaded.unwrap_or_else(|error| panic!("{}: {error}", scene.name))
}

#[test]
fn scenes_give_the_same() {
    for scene in scenes() {
        let loaded = loaded(&scene);
        let mut rules = BTreeSet::new();
        // One shape of each start rule; the whole scene follows.
        for start in scene.shapes.iter().filter(|start| rules.insert(start.rule)) {
            let settings = Settings { start: Some(start.rule.to_owned()), ..Settings::default() };
            let [a, b] = [&*scene.grammar as &dyn Grammar, &loaded].map(|it| outcome(it, &start.shape, &settings));
            assert_eq!(a, b, "{} from {}", scene.name, start.rule);
        }
        let compiled = scene.model().expect("a model");
        let grammar: Box<dyn Grammar + Send + Sync> = Box::new(loaded);
        let scene = Scene { grammar, ..scene };
        let model = scene.model().unwrap_or_else(|error| panic!("{}: {error}", scene.name));
        assert_eq!(bytes(&compiled), bytes(&model), "{}", scene.name);
    }
}

#[test]
fn the_tables_of_scenes_are_the_same() {
    for scene in scenes() {
        let loaded = loaded(&scene);
        assert_eq!(scene.grammar.attributes(), loaded.attributes(), "{}", scene.name);
        assert_eq!(scene.grammar.start_rules(), loaded.start_rules(), "{}", scene.name);
        assert_eq!((scene.grammar.name(), scene.grammar.about()), (loaded.name(), loaded.about()), "{}", scene.name);
    }
}
