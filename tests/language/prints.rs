//! The order of printed lines: by depth in the tree of shapes, as the reference lists them (*getTreeKey function*).

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::{Limits, Settings, cga};

use crate::{clean, lines, lot, model, rules};

#[test]
fn lines_come_breadth_first() {
    cga! {
        grammar Keys = r#"
            Init-->
                print("Init")
                center(xz)
                extrude(10)
                comp(f) { front: Facade}
            Facade-->
                print("Facade")
                split(y) {'0.5 : Floor }*
            Floor-->
                print("Floor")
                split(x) { '0.1 : Wall | '0.3 : Window | '0.1 : Wall }*
            Wall-->
                print("Wall")
            Window-->
                print("Window")
        "#;
    }
    let row = ["Wall", "Window", "Wall", "Wall", "Window", "Wall"];
    let expected = [&["Init", "Facade", "Floor", "Floor"][..], &row, &row].concat();
    assert_eq!(lines(&model(&Keys::default())), expected);
}

#[test]
fn blocks_have_the_depth_of_their_rule() {
    rules! {
        grammar Blocks = r#"
            Lot --> split(x) { ~1 : A print("first part") | ~1 : split(z) { ~1 : A print("second part") } }
                comp(f) { all : A print("face") } [ A print("bracket") ] print("end")
            A --> print("A") X.
        "#;
    }
    let own = ["first part", "second part", "face", "bracket", "end"];
    assert_eq!(lines(&model(&Blocks::default())), [&own[..], &["A"; 4]].concat());
}

#[test]
fn expressions_print_at_the_depth_of_the_rule_that_evaluates_them() {
    rules! {
        grammar Expressions = r#"
            attr a = print("attribute")
            const c = print("constant")
            said(what) = print(what)
            length(n) = print(n)
            is_top = print("selector") == "selector" && geometry.isOriented(top)
            Lot --> case said("condition") == "" : NIL else : B(said("argument of B")) Half
            Half --> split(x) { length(1) : C(said("argument of C")) } comp(f) { is_top : C("top") }
            B(what) --> print("B") X.
            C(what) --> print("C") X.
        "#;
    }
    let lines = lines(&model(&Expressions::default()));
    let (mut before, after) = (lines[..2].to_vec(), lines[2..].join(", "));
    before.sort();
    assert_eq!(before, ["attribute", "constant"]);
    assert_eq!(after, "condition, argument of B, B, 1, argument of C, selector, C, C");
}

#[test]
fn an_import_that_starts_again_prints_at_the_depth_of_the_call() {
    rules! {
        grammar Dynamic = r#"
            import imp : "rules/import/printing.cga"
            Lot --> A imp(height = 3).Lot
            A --> print("A") X.
        "#;
    }
    let lines = lines(&model(&Dynamic::default()));
    let last = &lines[lines.len() - 4..];
    assert_eq!(last, ["height 3", "A", "Lot", "Part"], "{lines:?}");
}

rules! {
    grammar Recursive = r#"
        attr levels = 3000
        Lot --> Down(0) Side(0)
        Down(n) --> case n < levels : print(n) [ split(x) { ~1 : Down(n + 1) print(n) } ] else : X.
        Side(n) --> case n < levels : print(n) Side(n + 1) else : X.
    "#;
}

#[test]
fn calls_that_wait_keep_their_depth() {
    // So deep that the stack does not suffice.
    let settings = Settings { limits: Limits { depth: 10_000, ..Limits::default() }, ..Settings::default() };
    let model = clean(Recursive::default().generate_with(&lot(), &settings).expect("a model"));
    let expected: Vec<String> = (0..3000).flat_map(|level| [level; 3]).map(|level: u32| level.to_string()).collect();
    assert_eq!(lines(&model), expected);
    assert!(model.prints().iter().all(|line| ["Down", "Side"].contains(&line.rule.as_str())));
}

#[test]
fn lines_beyond_the_limit_are_those_derived_last() {
    rules! {
        grammar Many = r#"
            Lot --> print(1) A print(2) print(3)
            A --> print("A") X.
        "#;
    }
    let settings = Settings { limits: Limits { prints: 3, ..Limits::default() }, ..Settings::default() };
    let model = Many::default().generate_with(&lot(), &settings).expect("a model");
    assert_eq!(lines(&model), ["1", "2", "A"]);
    assert_eq!(model.report().prints_left_out(), 1);
}

/// Set in the process that [`the_console_has_the_same_order`] starts.
const CHILD: &str = "CGA_TEST_ECHO";

#[test]
fn the_console_has_the_same_order() {
    rules! {
        grammar Echo = r#"
            Lot --> A print("echo 1") Endless
            A --> print("echo 2") X.
            @Allow(endless_rules)
            Endless --> Endless X.
        "#;
    }
    if std::env::var_os(CHILD).is_some() {
        let settings = Settings { echo: true, ..Settings::default() };
        assert!(Echo::default().generate_with(&lot(), &settings).is_err());
        return;
    }
    let mut child = std::process::Command::new(std::env::current_exe().expect("this program"));
    child.args(["prints::the_console_has_the_same_order", "--exact", "--nocapture"]).env(CHILD, "1");
    let output = child.output().expect("it runs");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let said: Vec<&str> = text.lines().filter(|line| line.starts_with("echo")).collect();
    assert!(output.status.success() && said == ["echo 1", "echo 2"], "{text}");
}
