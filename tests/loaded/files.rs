//! Loading: files, imports, styles, Rust functions, messages.

use std::fs;
use std::ops::ControlFlow;

use cga::{Error, Grammar, Model, RuleFile, RuleFileError, Session, Settings, Shape, Value, Watch, cga};
use cga_tests::outcome::outcome;
use cga_tests::tree::root;

cga! { grammar Outer in "rules/import/outer.cga"; }
cga! { grammar Styles in "rules/import/styles.cga"; }
cga! { grammar Site in "rules/import/site.cga"; }
cga! { grammar Annotated in "rules/import/annotated.cga"; }
cga! { grammar Drawn in "rules/import/drawn.cga"; }
cga! { grammar Lazy in "rules/import/lazy.cga"; }

/// A rule file of the tests.
fn open(name: &str, file: &str) -> RuleFile {
    let loader = RuleFile::loader().named(name).root(root().join("tests"));
    loader.open(format!("rules/import/{file}")).unwrap_or_else(|error| panic!("{error}"))
}

fn error(text: &str) -> String {
    RuleFile::from_text(text).expect_err("an error").to_string()
}

#[test]
fn files_with_imports_and_styles_give_the_same() {
    let pairs: [(Box<dyn Grammar>, &str, &str); 6] = [
        (Box::new(Outer::default()), "Outer", "outer.cga"),
        (Box::new(Styles::default()), "Styles", "styles.cga"),
        (Box::new(Site::default()), "Site", "site.cga"),
        (Box::new(Annotated::default()), "Annotated", "annotated.cga"),
        (Box::new(Drawn::default()), "Drawn", "drawn.cga"),
        (Box::new(Lazy::default()), "Lazy", "lazy.cga"),
    ];
    for (compiled, name, file) in pairs {
        let loaded = open(name, file);
        assert_eq!(compiled.attributes(), loaded.attributes(), "{file}");
        assert_eq!(compiled.start_rules(), loaded.start_rules(), "{file}");
        for start in loaded.start_rules() {
            let settings = Settings { start: Some(start.name.to_string()), ..Settings::default() };
            for seed in 0..5 {
                let shape = Shape::rectangle(12.0, 9.0).seed(seed);
                let [a, b] = [&*compiled as &dyn Grammar, &loaded].map(|grammar| outcome(grammar, &shape, &settings));
                assert_eq!(a, b, "{file} from {}, seed {seed}", start.name);
            }
        }
    }
}

#[test]
fn rules_import_files_in_memory() {
    let loader = RuleFile::loader().with_file("lib/walls.cga", "attr tint = \"#ff0000\"  Wall --> color(tint) Brick.");
    let rules = loader.text("import walls : \"lib/walls.cga\"  Lot --> walls.Wall").expect("good rules");
    assert_eq!(rules.attributes()[0].name, "walls.tint");
    assert_eq!(rules.generate(&Shape::rectangle(3.0, 2.0)).expect("no limit").counts(), [("Brick", 1)]);
    let error = loader.text("import walls : \"lib/wall.cga\"  Lot --> walls.Wall").expect_err("no such file");
    assert_eq!(
        error.to_string(),
        "error[cannot_import]: cannot import `lib/wall.cga`: no file in memory has this name; add it with `with_file`\n \
         --> rules.cga:1:16\n  |\n1 | import walls : \"lib/wall.cga\"  Lot --> walls.Wall\n  |                ^^^^^^^^^^^^^^\n  = \
         help: did you mean `lib/walls.cga`?"
    );
}

#[test]
fn errors_are_shown_as_the_compiler_shows_them() {
    assert_eq!(
        error("Lot --> extrude(hieght)\nattr height = 3"),
        "error[unknown_name]: unknown name `hieght`\n --> rules.cga:1:17\n  |\n1 | Lot --> extrude(hieght)\n  |                 \
         ^^^^^^\n  = help: did you mean `height`?"
    );
    let warnings = RuleFile::from_text("Lot --> Wal\nWall --> X.").expect("good rules").warnings().join("\n");
    assert!(warnings.contains("did you mean `Wall`?"), "{warnings}");
    let denied = RuleFile::loader().deny("undefined_rule").text("Lot --> Wal").expect_err("an error");
    assert!(denied.to_string().starts_with("error[undefined_rule]: there is no rule `Wal`"), "{denied}");
    let unknown = RuleFile::loader().allow("no_such_code").text("Lot --> X.").expect_err("an error");
    assert!(unknown.to_string().starts_with("`no_such_code` is not the name of a diagnostic"), "{unknown}");
}

#[test]
fn files_that_cannot_be_read_have_a_reason() {
    let missing = RuleFile::open("no/such/file.cga").expect_err("no file");
    assert!(missing.to_string().starts_with("cannot read `no/such/file.cga`: "), "{missing}");
    let folder: Result<RuleFile, RuleFileError> = RuleFile::open(root().join("tests"));
    assert!(folder.expect_err("a folder").to_string().ends_with("it is a folder; name a rule file in it"));
    // A path that leads out of the folder of the rules.
    let loader = RuleFile::loader().root(root().join("tests/rules/import"));
    let outside = loader.open("../house.cga").expect_err("outside");
    assert!(outside.to_string().contains("paths and links that lead out of it are not followed"), "{outside}");
}

#[test]
fn rust_functions_are_registered_by_their_paths() {
    let text = "Lot --> extrude(crate::height(split.index, \"a\")) crate::paint(0.5) Wall.";
    assert_eq!(
        error(text),
        "error[unknown_function]: the Rust function `crate::height` is not registered, so rules that are loaded cannot \
         call it\n --> rules.cga:1:17\n  |\n1 | Lot --> extrude(crate::height(split.index, \"a\")) crate::paint(0.5) \
         Wall.\n  |                 ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^\n  = help: register it with \
         `with_function(\"crate::height\", …)` before the rules are loaded\n\nerror[unknown_function]: the Rust operation \
         `crate::paint` is not registered, so rules that are loaded cannot call it\n --> rules.cga:1:50\n  |\n1 | Lot --> \
         extrude(crate::height(split.index, \"a\")) crate::paint(0.5) Wall.\n  |                                          \
         \u{20}       ^^^^^^^^^^^^^^^^^\n  = help: register it with `with_operation(\"crate::paint\", …)` before the rules are \
         loaded"
    );
    let loader = RuleFile::loader().with_operation("crate::paint", |shape, args| {
        assert_eq!(args, [Value::Float(0.5)]);
        shape.set_color(cga::Color::new(1.0, 0.0, 0.0));
    });
    let run = |value: fn(&[Value]) -> Value| {
        let rules = loader.clone().with_function("crate::height", value).text(text).expect("good rules");
        rules.generate(&Shape::rectangle(3.0, 2.0)).expect("no limit")
    };
    let model = run(|args| {
        assert_eq!(args, [Value::Float(-1.0), Value::from("a")]);
        Value::Float(7.0)
    });
    assert_eq!(model.volume(), 42.0);
    assert_eq!(model.leaves().next().expect("a leaf").material().color, Some(cga::Color::new(1.0, 0.0, 0.0)));
    let faults = run(|_| Value::from("seven")).faults().to_vec();
    assert_eq!(
        faults[0].message,
        "`crate::height` returned text, but the rules need a number; it counts as 0 or empty"
    );
}

#[test]
fn compiled_and_loaded_grammars_are_side_by_side() {
    let loaded = open("Outer", "outer.cga");
    let list: Vec<Box<dyn Grammar + Send + Sync>> = vec![Box::new(Outer::default()), Box::new(loaded)];
    let shapes: Vec<Shape> = (0..20).map(|seed| Shape::rectangle(9.0, 7.0).seed(seed)).collect();
    let models: Vec<Vec<u8>> = list
        .iter()
        .map(|grammar| {
            let models = cga::parallel::generate_all(&**grammar, &shapes, &Settings::default()).expect("no limit");
            models.to_model().to_glb().expect("a file")
        })
        .collect();
    assert_eq!(models[0], models[1]);
}

#[test]
fn a_watch_stops_loaded_rules() {
    let rules =
        RuleFile::from_text("Lot --> split(x) { { 0.001 : X }* }  X --> 50% : Y. else : Z.").expect("good rules");
    let watch = Watch::every(100, |_| ControlFlow::Break(()));
    let settings = Settings { watch: Some(watch), ..Settings::default() };
    let mut session: Session<'_, RuleFile> = rules.session(&settings).expect("no attributes");
    let mut model = Model::new();
    let report = session.run(&Shape::rectangle(100.0, 100.0), &mut model).expect("no error");
    assert!(report.stopped && report.shapes < 100_000, "{}", report.shapes);
}

#[test]
fn values_are_checked_and_can_be_reset() {
    let mut rules = RuleFile::from_text(
        "@Range(min = 1, max = 5, restricted = true) attr n = 2  attr m = rand(n)  Lot --> s(n, m, 1) X.",
    )
    .expect("good rules");
    assert!(rules.set("n", 7.0.into()).is_err() && rules.set("n", "x".into()).is_err());
    rules.set("n", 3.0.into()).expect("in range");
    let copy = rules.clone();
    rules.reset("n").expect("an attribute");
    assert_eq!((rules.get("n"), copy.get("n")), (Ok(2.0.into()), Ok(3.0.into())));
    assert!(rules.get("m").is_err());
    let wrong = Settings { start: Some("Lott".into()), ..Settings::default() };
    assert!(matches!(rules.generate_with(&Shape::rectangle(1.0, 1.0), &wrong), Err(Error::StartRule { .. })));
}

#[test]
fn a_file_that_has_changed_is_read_again() {
    let folder = std::env::temp_dir().join(format!("cga-loaded-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("tower.cga");
    for (rules, leaves) in [("Lot --> X. X.", 2), ("Lot --> X.", 1)] {
        fs::write(&path, rules).expect("a file");
        let loaded = RuleFile::open(&path).expect("good rules");
        assert_eq!(loaded.name(), "tower");
        assert_eq!(loaded.generate(&Shape::rectangle(1.0, 1.0)).expect("no limit").len(), leaves);
    }
    fs::remove_dir_all(&folder).expect("the folder");
}

/// The file has a rule for each operation.
#[test]
fn every_operation_has_a_call() {
    let loader = RuleFile::loader().root(root().join("tests"));
    let rules = loader.open("rules/one_operation.cga").unwrap_or_else(|error| panic!("{error}"));
    assert!(100 < rules.start_rules().len());
}

#[test]
fn attributes_with_computed_names_are_set() {
    cga! {
        grammar Named = r#"
            channel(name) = "material.color." + name
            Lot --> set(sel(channel("r")), 0.25) set(sel("material." + "name"), "stone") print(material.color.r) print(material.name)
                set(sel("trim." + "vertical"), false) print(trim.vertical) set(sel("lost." + "name"), 1) X.
        "#;
    }
    let loaded = RuleFile::loader()
        .named("Named")
        .text(
            r#"
            channel(name) = "material.color." + name
            Lot --> set(sel(channel("r")), 0.25) set(sel("material." + "name"), "stone") print(material.color.r) print(material.name)
                set(sel("trim." + "vertical"), false) print(trim.vertical) set(sel("lost." + "name"), 1) X.
        "#,
        )
        .unwrap_or_else(|error| panic!("{error}"));
    let model = |grammar: &dyn Grammar| {
        let model = grammar.generate(&Shape::rectangle(2.0, 3.0)).expect("a model");
        let prints: Vec<String> = model.prints().iter().map(ToString::to_string).collect();
        (prints, model.faults().len(), model.to_glb().expect("a file"))
    };
    assert_eq!(model(&loaded), model(&Named::default()));
    assert_eq!(model(&loaded).0, ["0.25", "stone", "false"]);
}

#[test]
fn loaded_rules_have_the_warnings_of_queries_in_vain() {
    let warnings = |rules: &str, lib: &str| {
        let loader = RuleFile::loader().with_file("lib.cga", lib);
        loader.text(rules).expect("good rules").warnings().join("\n")
    };
    let rules = "import lib : \"lib.cga\"\nLot --> print(contextCount(intra, \"towr\")) lib.Lot";
    // A loaded text has the name of a file, and other files may import it. So unknown labels are not reported, although the text is a whole
    // program.
    assert_eq!(warnings(rules, "Lot --> label(\"tower\") X."), "");
    let found = warnings(rules, "Lot --> union { extrude(3) label(\"towr\") X. | extrude(2) Y. } Z.");
    assert!(found.contains("this label is lost below `union`"), "{found}");
    assert_eq!(warnings(rules, "Lot --> label(\"to\" + str(rint(rand(1)))) X."), "");
    let found =
        warnings("import lib : \"lib.cga\"\nattr hidden = touches(intra)\nLot --> print(hidden) lib.Lot", "Lot --> X.");
    assert!(found.contains("always false in the value of an attribute or constant"), "{found}");
    let empty = RuleFile::from_text("Lot --> label(\"\") X.").expect_err("an empty label").to_string();
    assert!(empty.contains("`label` is empty"), "{empty}");
}

#[test]
fn a_single_loaded_run_says_how_to_make_a_scene() {
    let rules = RuleFile::from_text("Lot --> print(touches(inter)) X.").expect("good rules");
    let model = rules.generate(&Shape::rectangle(3.0, 2.0)).expect("a model");
    let faults: Vec<&str> = model.faults().iter().map(|fault| fault.message.as_str()).collect();
    assert!(faults.len() == 1 && faults[0].contains("`Scene::new(&grammar, &lots).generate(&settings)`"), "{faults:?}");
}
