//! The same rules from three sources (Rust tokens, a string, a file) give the same model.

use cga::{Grammar, Model, Shape, cga};

cga! {
    grammar Inline;

    /// Height of the building.
    @Range(min = 3, max = 60)
    attr height = 12
    attr wall = "#d9cdb8"
    const floor = 3
    bay = case height > 10 : 2 else : 1.5

    @StartRule
    Lot --> extrude(height) split(y) { ^0.25 : Shop | { ~floor : Floor(split.index) }* | 0.5 : NIL }
    Shop --> color(wall) comp(f) { side : Front | top = Roof. | all : X. }
    Front --> split(x) { { ~bay : Tile | ^(0.1 / 2) : Pier. }* }
    Tile --> 40% : Glass. 30% : [ s(^0.5, ^0.5, 0) center(xy) Sign. ] Wall. else : Wall.
    Floor(n) --> case n % 2 == 0 && n >= 0 : Floor else : s(^1.1, ^1, ^1.1) center(xz) Slab.
    Floor --> comp(f) { front : Front | back : Front | 4 : Roof. | all : t(0, 0, -0.1) Wall. }
}

cga! {
    grammar Text = r##"
        # The same in verbatim CGA.
        /// Height of the building.
        @Range(min = 3, max = 60)
        attr height = 12
        attr wall = "#d9cdb8"
        const floor = 3
        bay = case height > 10 : 2 else : 1.5

        @StartRule
        Lot --> extrude(height) split(y) { '0.25 : Shop | { ~floor : Floor(split.index) }* | 0.5 : NIL }
        Shop --> color(wall) comp(f) { side : Front | top = Roof. | all : X. }
        Front --> split(x) { { ~bay : Tile | '(0.1 / 2) : Pier. }* }
        Tile --> 40% : Glass. 30% : [ s('0.5, '0.5, 0) center(xy) Sign. ] Wall. else : Wall.
        Floor(n) --> case n % 2 == 0 && n >= 0 : Floor else : s('1.1, '1, '1.1) center(xz) Slab.
        Floor --> comp(f) { front : Front | back : Front | 4 : Roof. | all : t(0, 0, -0.1) Wall. }
    "##;
}

cga! { grammar File in "rules/house.cga"; }

// With escapes, and in several literals.
cga! {
    grammar Escaped = concat!(
        "attr height = 12 attr wall = \"\x23d9cdb8\" const floor = 3\nbay = case height > 10 : 2 else : 1.5
        @StartRule\tLot --> extrude(height) split(y) \u{7b} '0.25 : Shop | { ~floor : Floor(split.index) }* \
            | 0.5 : NIL }",
        "Shop --> color(wall) comp(f) { side : Front | top = Roof. | all : X. }",
        r"Front --> split(x) { { ~bay : Tile | '(0.1 / 2) : Pier. }* }
        Tile --> 40% : Glass. 30% : [ s('0.5, '0.5, 0) center(xy) Sign. ] Wall. else : Wall.",
        "Floor(n) --> case n % 2 == 0 && n >= 0 : Floor else : s('1.1, '1, '1.1) center(xz) Slab.",
        "Floor --> comp(f) { front : Front | back : Front | 4 : Roof. | all : t(0, 0, -0.1) Wall. }",
    );
}

fn lot(seed: u64) -> Shape {
    Shape::rectangle(12.0, 7.0).seed(seed)
}

/// All that a model says: leaves, scopes, materials, geometry.
fn print(model: &Model) -> String {
    let leaves = model.leaves();
    leaves
        .map(|leaf| format!("{} {:?} {:?} {:?}\n", leaf.rule(), leaf.scope(), leaf.material(), leaf.geometry()))
        .collect()
}

#[test]
fn three_sources_give_one_model() {
    for seed in 0..20 {
        let inline = Inline::default().generate(&lot(seed)).expect("no limit");
        assert_eq!(inline.faults(), []);
        assert!(40 < inline.len(), "{}", inline.len());
        let sources: [&dyn Grammar; 3] = [&Text::default(), &File::default(), &Escaped::default()];
        for source in sources {
            let other = source.generate(&lot(seed)).expect("no limit");
            assert!(print(&inline) == print(&other), "seed {seed}, {}", source.name());
        }
    }
}

#[test]
fn three_sources_give_one_table_of_attributes() {
    assert_eq!(Inline::default().attributes(), Text::default().attributes());
    assert_eq!(Inline::default().attributes(), File::default().attributes());
    assert_eq!(Inline::default().start_rules(), File::default().start_rules());
}

#[test]
fn the_expression_form_gives_the_same_model() {
    let (floor, colour) = (3u8, String::from("#d9cdb8"));
    let mut rules = cga! {
        attr height = 8
        bay = case height > 10 : 2 else : 1.5
        @StartRule
        Lot --> extrude(height) split(y) { ^0.25 : Shop | { ~#floor : Floor(split.index) }* | 0.5 : NIL }
        Shop --> color(#colour) comp(f) { side : Front | top = Roof. | all : X. }
        Front --> split(x) { { ~bay : Tile | ^(0.1 / 2) : Pier. }* }
        Tile --> 40% : Glass. 30% : [ s(^0.5, ^0.5, 0) center(xy) Sign. ] Wall. else : Wall.
        Floor(n) --> case n % 2 == 0 && n >= 0 : Floor else : s(^1.1, ^1, ^1.1) center(xz) Slab.
        Floor --> comp(f) { front : Front | back : Front | 4 : Roof. | all : t(0, 0, -0.1) Wall. }
    };
    rules.height = 12.0;
    let (one, other) =
        (rules.generate(&lot(3)).expect("no limit"), Inline::default().generate(&lot(3)).expect("no limit"));
    assert_eq!(print(&one), print(&other));
}

mod text_is_compatible {
    use super::*;

    cga! { @Allow(undefined_rule) grammar Loose = "Lot --> split(x) { 1 : Wall | ~1 : Window(3) }"; }

    #[test]
    fn a_call_without_a_rule_is_a_leaf() {
        let model = Loose::default().generate(&lot(0)).expect("no limit");
        assert_eq!(model.counts(), [("Wall", 1), ("Window", 1)]);
    }
}

mod paths_in_text {
    use super::*;

    fn double(x: f64) -> f64 {
        2.0 * x
    }

    fn paint(shape: &mut Shape, grey: f64) {
        shape.set_color(cga::Color::new(grey, grey, grey));
    }

    cga! {
        grammar Calls = "Lot --> crate::sources::paths_in_text::paint(self::double(0.25)) s(self::double(scope.sx), 1, 1) Wall.";
    }
    cga! { grammar FromFile in "rules/calls.cga"; }

    #[test]
    fn are_resolved_where_the_macro_is_called() {
        for rules in [&Calls::default() as &dyn Grammar, &FromFile::default()] {
            let model = rules.generate(&lot(0)).expect("no limit");
            let leaf = model.leaves().next().expect("a leaf");
            assert_eq!((leaf.size().x, leaf.material().color().r), (24.0, 0.5));
        }
    }
}

mod values {
    use super::*;

    cga! {
        grammar ValuesInline;
        import roof : "rules/import/inner.cga" (h = low[1] * 2, Roof(n) --> Top(n, low))
        attr low = [1, 2; 3, 4]
        attr names = ["a", "b"; "c", "d"]
        attr open = [true, false]
        const steps = [0 : 0.5 : size(low)]
        both(a, b) with ( sum := a .+ b  half := sum ./ 2 ) = half[sum .> 3 .&& sum .< 100]
        pick(list, i) = case i >= size(list) : "none" else : list[i]

        @StartRule
        Lot with ( widths := both(low[0, 0:1], [3, 4])  n := size(widths) ) -->
            extrude(n + 1) report("width", sum(widths)) print(names .+ "!") print(steps[-1 : 1] .- .-[1, 2, 3])
            split(y) { ^0.5 : Floor(widths, 0) | { ~widths[0] : Floor(low[1, 0:1], split.index) }* }
        Floor(list, i) --> set(low, [low; i, i]) print(pick(names, i)) print(list == [1, 2] || open[0])
            [ case size(list) > i : s(^1, list[i], ^1) center(y) Slab. else : color("#ff0000") Thin. ] roof.Lot roof(h = i + 1).Say
        Top(n, list) --> print(n * list[1, 0]) Roof.

        style Odd extends Even
        attr names = ["x"]
        pick(list, i) = list[i] + "?"
        style Even
        Floor(list, i) --> 50% : Slab. else : NIL
    }

    cga! {
        grammar ValuesText = r##"
            import roof : "rules/import/inner.cga" (h = low[1] * 2, Roof(n) --> Top(n, low))
            attr low = [1, 2; 3, 4]
            attr names = ["a", "b"; "c", "d"]
            attr open = [true, false]
            const steps = [0 : 0.5 : size(low)]
            both(a, b) with ( sum := a .+ b  half := sum ./ 2 ) = half[sum .> 3 .&& sum .< 100]
            pick(list, i) = case i >= size(list) : "none" else : list[i]

            @StartRule
            Lot with ( widths := both(low[0, 0:1], [3, 4])  n := size(widths) ) -->
                extrude(n + 1) report("width", sum(widths)) print(names .+ "!") print(steps[-1 : 1] .- .-[1, 2, 3])
                split(y) { '0.5 : Floor(widths, 0) | { ~widths[0] : Floor(low[1, 0:1], split.index) }* }
            Floor(list, i) --> set(low, [low; i, i]) print(pick(names, i)) print(list == [1, 2] || open[0])
                [ case size(list) > i : s('1, list[i], '1) center(y) Slab. else : color("#ff0000") Thin. ] roof.Lot roof(h = i + 1).Say
            Top(n, list) --> print(n * list[1, 0]) Roof.

            style Odd extends Even
            attr names = ["x"]
            pick(list, i) = list[i] + "?"
            style Even
            Floor(list, i) --> 50% : Slab. else : NIL
        "##;
    }

    cga! { grammar ValuesFile in "rules/values.cga"; }

    #[test]
    fn three_sources_agree_on_arrays_locals_styles_and_imports() {
        let sources: [&dyn Grammar; 3] = [&ValuesInline::default(), &ValuesText::default(), &ValuesFile::default()];
        assert_eq!(sources[0].attributes(), sources[1].attributes());
        assert_eq!(sources[0].attributes(), sources[2].attributes());
        assert!(sources[0].start_rules().iter().any(|start| start.name == "Odd$Lot"));
        for start in sources[0].start_rules() {
            let settings = cga::Settings { start: Some(start.name.to_string()), ..cga::Settings::default() };
            let models = sources.map(|source| source.generate_with(&lot(3), &settings).expect("no limit"));
            let [one, two, three] = models.each_ref().map(|model| {
                assert_eq!(model.faults(), []);
                format!("{}{:?}{:?}", print(model), model.prints(), model.reports())
            });
            assert!(one == two && two == three, "{}", start.name);
        }
        let model = sources[0].generate(&lot(3)).expect("no limit");
        assert!(5 < model.len() && 5 < model.prints().len(), "{:?}", model.counts());
    }
}
