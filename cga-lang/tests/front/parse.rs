//! `tests/data/parse`: tokens to tree, shown with a bracket around every operator.

use crate::print::{Spelling, print};
use cga_lang::diag::{Diags, Level};
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::parse::parse;
use std::fs;

#[test]
fn tokens_become_these_trees() {
    crate::common::walk("parse", |text| {
        let lexed = lex(text);
        let mut diags = Diags::new();
        diags.append(lexed.diags.clone());
        let ast = parse(&lexed.tokens, &mut diags);
        (diags.finish(), lexed, Some(print(&ast, Spelling::Text)))
    });
}

#[test]
fn a_printed_tree_reads_as_the_same_tree_in_either_spelling() {
    let mut compared = 0;
    for folder in ["parse", "check", "lower"] {
        for path in crate::common::fixtures(folder) {
            let text = crate::common::strip(&fs::read_to_string(&path).expect("readable fixture"));
            let (mut diags, lexed) = (Diags::new(), lex(&text));
            diags.append(lexed.diags);
            let first = parse(&lexed.tokens, &mut diags);
            if diags.finish().iter().any(|diag| diag.level == Level::Error) {
                // Text with a syntax error is not printed as it was written.
                continue;
            }
            for spelling in [Spelling::Text, Spelling::Inline] {
                let printed = print(&first, spelling);
                let mut diags = Diags::new();
                let again = parse(&lex(&printed).tokens, &mut diags);
                assert!(!diags.has_errors(), "{}: {:?}", path.display(), diags.finish());
                diags.finish();
                assert_eq!(crate::common::shape(&again), crate::common::shape(&first), "{}", path.display());
                assert_eq!(print(&again, spelling), printed, "{}", path.display());
                compared += 1;
            }
        }
    }
    assert!(50 < compared, "{compared}");
}

#[test]
fn one_mistake_does_not_hide_the_declarations_behind_it() {
    let good = "attr after = 1\nAfter(a) --> X.\nafter2(a) = a\nconst last = 2\n";
    for bad in [
        "A --> s(1, 2\n",
        "A --> split(x) { 1 : X\n",
        "A --> [ X\n",
        "A --> i(\"a.obj) X\n",
        "a = [1, 2\n",
        "a = b[1\n",
        "a = comp(f) { all : 1\n",
        "a = case b : 1\n",
        "a = 1 +\n",
        "A with ( b := 1 --> X\n",
        "A with ( b = ) --> X\n",
        "import a : \"x\" ( h = 1\n",
        "import a\n",
        "style A extends\n",
        "A --> lib(h = 1.X\n",
        "A --> inline\n",
        "A --> setback(1) { all : X | remainder\n",
        "A --> splitAndSetbackPerimeter(1) { 1 : 2\n",
        "A --> X ) } ]\n",
        "@Range(1, 2\n",
        "a = ] ) }\n",
    ] {
        let mut diags = Diags::new();
        let ast = parse(&lex(&format!("{bad}{good}")).tokens, &mut diags);
        diags.finish();
        let names: Vec<&str> = ast.decls.iter().map(|decl| decl.name.text.as_str()).collect();
        assert!(names.ends_with(&["after", "After", "after2", "last"]), "{bad}: {names:?}");
    }
}
