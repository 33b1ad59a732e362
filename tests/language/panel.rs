//! A panel of sliders from `dyn Grammar` alone: what a user interface needs, and how it sets what a person types.

use std::fmt::Write;

use cga::{Attribute, AttributeKind, ChoiceValues, Error, Grammar, Shape, cga};

cga! {
    grammar House = r##"
        @Allow(unused_attribute)
        @RuleFileDescription("A house, *one* storey or more.")
        version "2025.1"

        @Group("Size", 1) @Order(2)
        @Range(min = 3, max = 60, stepsize = 0.5) @Distance @DisplayName("Height of the house")
        attr height = 12
        @Order(1) @Range(1, 20)
        # Old files count places.
        attr storeys = 4
        @Percent @Description("How much of the front is glass.")
        attr glass = 0.4
        @Group("Size", "Roof", 3) @Angle
        attr pitch = 30
        @Range(few = 1, some = 3, many = 9)
        attr dormers = 3

        @Group("Look", 2)
        @Color
        attr wall = "#d9cdb8"
        @Enum("plain", "ornate", "ruined")
        attr style = "plain"
        @Enum(valuesAttr = uses)
        attr use = uses[0]
        @Hidden
        attr uses = ["flats", "shops", "offices"]
        @Enum("flats", "shops", "offices")
        attr floors = ["shops", "flats"]
        @Range(min = 2.5, max = 7)
        attr floorHeights = [4, 3; 3, 3]
        @File("jpg", "png")
        attr texture = ""
        @Directory
        attr folder = "assets"
        @MaterialFile
        attr material = "brick.cgamat"

        @Group
        attr lit = true
        attr seedling = rint(rand(1, 6))
        @Range(min = 0, max = 10)
        attr old = 99

        /// Begins with a lot.
        @StartRule
        Lot --> extrude(height) Mass
        @StartRule @Description("Begins with a volume.")
        Mass --> print(use) print(floors) print(style) X.
        @Hidden
        Debug --> print("debug") X.
        Floor --> X.
    "##;
}

/// Attributes as a user interface shows them: by order, those without one last, in the order of the rules.
fn by_order(mut list: Vec<&Attribute>) -> Vec<&Attribute> {
    let number = |attribute: &Attribute| attribute.order.unwrap_or(f64::INFINITY);
    list.sort_by(|a, b| number(a).total_cmp(&number(b)));
    list
}

fn panel(grammar: &dyn Grammar) -> String {
    let mut out = format!("{}: {}\n", grammar.name(), grammar.about());
    for start in grammar.start_rules().iter().filter(|start| start.marked && !start.hidden) {
        writeln!(out, "start {} ({})", start.name, start.about.trim()).unwrap();
    }
    let shown: Vec<&Attribute> = grammar.attributes().iter().filter(|attribute| !attribute.hidden).collect();
    group(grammar, &mut out, &shown, 0);
    out
}

/// Writes a group: its own attributes, then the groups in it.
fn group(grammar: &dyn Grammar, out: &mut String, list: &[&Attribute], depth: usize) {
    let (own, inner): (Vec<&Attribute>, Vec<&Attribute>) = list.iter().partition(|it| it.group.len() == depth);
    for attribute in by_order(own) {
        let name = if attribute.display_name.is_empty() { &attribute.name } else { &attribute.display_name };
        let value =
            grammar.get(&attribute.name).map_or("(computed)".into(), |value| value.to_string().replace('\n', " "));
        let about = if attribute.about.is_empty() { String::new() } else { format!(" -- {}", attribute.about) };
        writeln!(out, "{}{name}: {}{}{about}", "  ".repeat(depth), value, control(grammar, attribute)).unwrap();
    }
    let mut groups: Vec<(&str, Vec<&Attribute>)> = Vec::new();
    for attribute in inner {
        match groups.iter_mut().find(|(name, _)| attribute.group[depth].is(name)) {
            Some((_, list)) => list.push(attribute),
            None => groups.push((&attribute.group[depth], vec![attribute])),
        }
    }
    // The number belongs to the innermost group.
    let number = |list: &[&Attribute]| {
        let own = list.iter().filter(|it| it.group.len() == depth + 1);
        own.filter_map(|it| it.group_order).next().unwrap_or(f64::INFINITY)
    };
    groups.sort_by(|a, b| number(&a.1).total_cmp(&number(&b.1)));
    for (name, list) in groups {
        writeln!(out, "{}[{name}]", "  ".repeat(depth)).unwrap();
        group(grammar, out, &list, depth + 1);
    }
}

/// The control that shows and changes an attribute.
fn control(grammar: &dyn Grammar, attribute: &Attribute) -> String {
    let mut out = match &attribute.kind {
        AttributeKind::Plain => String::new(),
        AttributeKind::Color => " colour".into(),
        AttributeKind::File(endings) => format!(" file {}", endings.join("|")),
        AttributeKind::Directory => " folder".into(),
        AttributeKind::MaterialFile => " material".into(),
        AttributeKind::Angle => " °".into(),
        AttributeKind::Percent => " %".into(),
        AttributeKind::Distance => " m".into(),
        _ => String::new(),
    };
    if let Some(range) = attribute.range {
        let free = if range.restricted { "" } else { " or any" };
        write!(out, " {}..{} by {}{free}", range.min, range.max, range.step).unwrap();
    }
    if let Some(choices) = &attribute.choices {
        let values: Vec<String> =
            choices.of(grammar).unwrap_or_default().iter().map(|value| value.to_string()).collect();
        let from =
            if let ChoiceValues::Attribute(name) = &choices.values { format!(" ({name})") } else { String::new() };
        let labels =
            if choices.labels.is_empty() { String::new() } else { format!(" as {}", choices.labels.join("|")) };
        write!(out, " one of {}{labels}{from}", values.join("|")).unwrap();
    }
    out
}

#[test]
fn a_panel_needs_nothing_but_the_trait() {
    let grammar: Box<dyn Grammar> = Box::new(House::default());
    assert_eq!(
        panel(grammar.as_ref()),
        "\
House: A house, *one* storey or more.
start Lot (Begins with a lot.)
start Mass (Begins with a volume.)
lit: true
seedling: (computed)
old: 99 0..10 by 0
[Size]
  storeys: 4 1..20 by 0
  Height of the house: 12 m 3..60 by 0.5
  glass: 0.4 % 0..1 by 0 or any -- How much of the front is glass.
  [Roof]
    pitch: 30 ° 0..360 by 0 or any
    dormers: 3 one of 1|3|9 as few|some|many
[Look]
  wall: #d9cdb8 colour
  style: plain one of plain|ornate|ruined
  use: (computed) one of flats|shops|offices (uses)
  floors: (2)[shops,flats] one of flats|shops|offices
  floorHeights: (2x2)    4   3    3   3 2.5..7 by 0
  texture:  file jpg|png
  folder: assets folder
  material: brick.cgamat material
"
    );
}

#[test]
fn what_a_person_types_is_set_or_refused_with_a_reason() {
    let mut grammar: Box<dyn Grammar> = Box::new(House::default());
    for (name, text) in [
        ("height", "20"),
        ("glass", "7"),
        ("style", "ornate"),
        ("use", "shops"),
        ("floors", r#"["offices"; "shops"]"#),
        ("floorHeights", "[3.5, 4]"),
        ("dormers", "9"),
        ("wall", "#000000"),
        ("lit", "false"),
        ("seedling", "3"),
        ("old", "99"),
        ("old", "5"),
        ("uses", r#"["barns"]"#),
    ] {
        assert_eq!(grammar.set_text(name, text), Ok(()), "{name}");
    }
    let refused = [
        ("height", "61", "attribute `height`: 61 is outside of 3 to 60"),
        ("height", "tall", "attribute `height` is a number, and `tall` is not"),
        ("style", "gothic", "attribute `style`: `gothic` is not one of plain, ornate, ruined"),
        ("use", "flats", "attribute `use`: `flats` is not one of barns"),
        ("floors", r#"["shops", "barns"]"#, "attribute `floors`: `barns` is not one of flats, shops, offices"),
        ("floorHeights", "[3, 8, 9]", "attribute `floorHeights`: 8 is outside of 2.5 to 7"),
        ("floorHeights", "[3, [4]]", "attribute `floorHeights` is an array of numbers, and `[3, [4]]` is not"),
        ("dormers", "2", "attribute `dormers`: `2` is not one of 1, 3, 9"),
        ("lit", "yes", "attribute `lit` is true or false, and `yes` is not"),
        ("hieght", "3", "unknown attribute `hieght`; did you mean `height`?"),
    ];
    let before = panel(grammar.as_ref());
    for (name, text, why) in refused {
        assert_eq!(grammar.set_text(name, text).map_err(|error| error.to_string()), Err(why.to_owned()));
    }
    assert_eq!(panel(grammar.as_ref()), before, "what is refused changes nothing");
    assert!(before.contains("floors: (2x1)    offices      shops"), "{before}");
}

#[test]
fn a_run_checks_what_the_fields_hold() {
    let lot = Shape::rectangle(5.0, 5.0);
    let run = |change: fn(&mut House)| {
        let mut house = House::default();
        change(&mut house);
        house.generate(&lot).map(|model| model.prints().len())
    };
    // A default outside of its own range, which old files have, is no mistake.
    assert_eq!(run(|_| {}), Ok(3));
    assert_eq!(run(|house| house.r#use = Some("shops".into())), Ok(3));
    type Change = fn(&mut House);
    let refused: [(Change, &str, &str); 6] = [
        (|house| house.old = 98.0, "old", "98 is outside of 0 to 10"),
        (|house| house.floorHeights = [3.0, f64::NAN].into(), "floorHeights", "NaN is outside of 2.5 to 7"),
        (|house| house.style = String::new(), "style", "`` is not one of plain, ornate, ruined"),
        (
            |house| house.floors = ["shops", "x"].map(cga::Text::from).into(),
            "floors",
            "`x` is not one of flats, shops, offices",
        ),
        (|house| house.r#use = Some("x".into()), "use", "`x` is not one of flats, shops, offices"),
        (|house| house.dormers = 2.0, "dormers", "`2` is not one of 1, 3, 9"),
    ];
    for (change, name, message) in refused {
        assert_eq!(run(change), Err(Error::Attribute { name: name.into(), message: message.into() }));
    }
    // Values that rules compute or set are not checked.
    cga! { grammar Sets = "@Range(min = 0, max = 1) attr a = scope.sx  @Enum(1, 2) attr b = 1  Lot --> set(b, 7) print(a + b) X."; }
    assert_eq!(Sets::default().generate(&lot).expect("a model").prints()[0].to_string(), "12");
}

#[test]
fn a_run_can_start_with_a_hidden_rule_though_nobody_offers_it() {
    let house = House::default();
    let hidden: Vec<&str> =
        house.start_rules().iter().filter(|start| start.hidden).map(|start| start.name.as_str()).collect();
    assert_eq!(hidden, ["Debug"]);
    let model = house.generate_from("Debug", &Shape::rectangle(1.0, 1.0)).expect("a model");
    assert_eq!(model.prints()[0].to_string(), "debug");
    let error = house.generate_from("Nowhere", &Shape::rectangle(1.0, 1.0)).expect_err("no such rule");
    assert_eq!(error.to_string(), "`Nowhere` is not a start rule; the start rules are Lot, Mass, Floor");
}

#[test]
fn attributes_of_imports_are_in_the_table_with_what_they_say() {
    cga! {
        grammar Importing = r#"
            @Group("Own") attr mine = 1
            import annotated : "rules/import/annotated.cga"
            @Hidden(height)
            import some : "rules/import/annotated.cga"
            @Hidden
            import none : "rules/import/annotated.cga"
            Lot --> annotated.Lot some.Lot none.Lot
        "#;
    }
    let mut rules = Importing::default();
    let table: Vec<(&str, String, bool)> =
        rules.attributes().iter().map(|row| (row.name.as_str(), row.group.join("/"), row.hidden)).collect();
    assert_eq!(
        table,
        [
            ("mine", "Own", false),
            ("annotated.height", "Own", false),
            ("annotated.colour", "Look", false),
            ("annotated.colours", "Look", true),
            ("some.height", "Own", true),
            ("some.colour", "Look", false),
            ("some.colours", "Look", true),
            ("none.height", "Own", true),
            ("none.colour", "Look", true),
            ("none.colours", "Look", true),
        ]
        .map(|(name, group, hidden)| (name, group.to_owned(), hidden))
    );
    let range = rules.attributes()[1].range.expect("a range");
    assert_eq!((range.min, range.max), (1.0, 5.0));
    assert_eq!(rules.set_text("some.height", "4"), Ok(()));
    assert_eq!(rules.set_text("some.colours", r##"["#000000"]"##), Ok(()));
    let refused = rules.set_text("some.colour", "#ff0000").expect_err("none of the import's own");
    assert_eq!(refused.to_string(), "attribute `some.colour`: `#ff0000` is not one of #000000");
    assert!(rules.set_text("annotated.height", "6").is_err());
    let model = rules.generate(&Shape::rectangle(1.0, 1.0)).expect("a model");
    assert_eq!(model.prints().iter().map(|line| line.to_string()).collect::<Vec<_>>(), ["2", "4", "2"]);
}
