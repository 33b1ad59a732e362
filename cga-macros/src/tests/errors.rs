//! Findings as tokens: what rustc will be given.

use proc_macro2::TokenStream;

use crate::expand;

fn expanded(input: &str) -> String {
    expand(input.parse::<TokenStream>().expect("Rust tokens")).to_string()
}

/// The texts of the `compile_error!`s.
fn errors(input: &str) -> Vec<String> {
    let file = syn::parse_str::<syn::File>(&expanded(input)).expect("items");
    let text = |item: &syn::Item| match item {
        syn::Item::Macro(item) => item.mac.parse_body::<syn::LitStr>().ok().map(|text| text.value()),
        _ => None,
    };
    file.items.iter().filter_map(text).collect()
}

#[test]
fn several_mistakes_give_several_errors() {
    let list =
        errors("pub grammar A; attr x = 1 y Lot --> extrud(3) splt(x) { ~1 : X. } Part --> comp(q) { top : X. }");
    assert!(3 <= list.len(), "{list:#?}");
}

/// A level before a doc comment, and between two.
#[test]
fn levels_and_attributes_stand_in_any_order() {
    for header in ["@Allow(unused) #[doc = \"A.\"]", "#[doc = \"A.\"] @Allow(unused) #[doc = \"B.\"] @Deny(syntax)"] {
        let text = expanded(&format!("{header} pub grammar A; attr a = 1 Lot --> X."));
        assert!(text.contains("pub struct A") && text.contains("doc = \"A.\""), "{text}");
        assert!(!text.contains("compile_error"), "{text}");
    }
}

#[test]
fn a_broken_header_says_how_it_is_written() {
    for (input, start) in [
        ("pub grammar A", "the rules of `A` are missing\nhelp: after the grammar's name comes `;` and the rules"),
        ("grammar A = 3;", "the rules must be a string literal"),
        ("grammar A = rules;", "the rules of `A` are missing\nhelp: write the rules as one string literal"),
        ("grammar A = include_str!(\"x\");", "the rules of `A` are missing\nhelp: write the rules as one string"),
        ("grammar A in rules;", "the rules of `A` are missing\nhelp: write the path"),
        ("grammar A in \"rules\" Lot --> X.", "nothing but `;` may follow here"),
        ("pub struct A;", "the header is broken\nhelp: it is written `pub grammar Name`"),
        ("pub(crate) A; Lot --> X.", "the header is broken"),
        ("grammar;", "the header is broken"),
        (
            "@Range(1) grammar A = \"Lot --> X.\";",
            "`@Range` does not set the level of a diagnostic\nhelp: before a grammar in text",
        ),
        ("@Allow(no_such) grammar A = \"Lot --> X.\";", "`@Allow` does not set the level of a diagnostic"),
        ("grammar A in \"/etc/rules.cga\";", "the path `/etc/rules.cga` leaves the package"),
        ("grammar A in \"src/../../rules.cga\";", "the path `src/../../rules.cga` leaves the package"),
        ("grammar A in \"rules/tower.v2.cga\";", "the name of a rule file has no `.`\nhelp: rename the file"),
        ("grammar A in \"src\";", "`src` is a folder"),
        ("grammar A in \"no/such.cga\";", "there is no file `no/such.cga`\nhelp: paths count from the folder"),
    ] {
        let list = errors(input);
        assert!(list.len() == 1 && list[0].starts_with(start), "{input}: {list:?}");
    }
}

#[test]
fn names_are_emitted_whatever_is_wrong() {
    for input in [
        "pub grammar A",
        "pub grammar A in \"no/such.cga\";",
        "grammar A = 3;",
        "grammar A; attr x = 3 oops",
        "grammar A; }",
    ] {
        let Ok(stream) = input.parse::<TokenStream>() else { continue };
        let file: syn::File = syn::parse2(expand(stream)).expect("items");
        let names = file.items.iter().filter(|item| matches!(item, syn::Item::Struct(item) if item.ident == "A"));
        assert_eq!(names.count(), 1, "{input}");
    }
}

#[test]
fn habits_of_other_languages_are_named_once() {
    for (rules, message, help) in [
        ("Lot --> extrude(3m) X.", "`3m` is not a number in CGA", "write `3`"),
        ("Lot --> split(x) { 2.5cm : X. | ~1 : Y. }", "`2.5cm` is not a number in CGA", "write `0.025`"),
        ("Lot --> extrude(3e400) X.", "this number is too large", ""),
        ("Lot --> extrude(0x10) X.", "`0x10` is not a number in CGA", "write it in digits"),
        ("Lot --> s('1', ^2, 3) X.", "Rust reads `'1'` as a character", "inline, write `^1`"),
        ("Lot --> s(3, 'a', 3) X.", "Rust reads `'a'` as a character", "inline, write a relative size as `^0.5`"),
        ("Lot --> case 3 < 4 & 4 < 5 : X. else : Y.", "`&` has no meaning in CGA", "write `&&`"),
        ("Lot --> extrude(3 < 4 ? 5 : 6) X.", "`?` has no meaning in CGA", "write `case condition : a else : b`"),
        ("Lot --> color(#00ff00) X.", "a colour is text", "write `\"#00ff00\"`"),
        (
            "Lot --> color(#ff00aa) X.",
            "a colour is text",
            "write `\"#ff00aa\"`; the Rust value of this name is `#(ff00aa)`",
        ),
        ("Lot --> color(#ffffff) X.", "a colour is text", "write `\"#ffffff\"`"),
        ("attr h = 3 Lot --> if h > 3 : X. else : Y.", "a condition begins with `case`", "write `case h > 3 :`"),
        ("attr h = 3 Lot --> case h <> 3 : X. else : Y.", "`<>` is not an operator", "write `!=`"),
        ("attr a = 3 Lot --> case not a > 3 : X. else : Y.", "`not` is not an operator", "write `!(a > 3)`"),
        ("attr b = True Lot --> case b : X. else : Y.", "unknown name `True`", "did you mean `true`?"),
        ("Lot --> comp(f) { side => X. }", "expected `:` after the selector, found `=>`", "write `:`"),
        ("Lot --> split(x) { 3 = X. | ~1 : Y. }", "expected `:` after the size, found `=`", "write `:`"),
        ("attr h: f32 = 3 Lot --> extrude(h) X.", "types cannot be declared", "write `attr h = …`"),
        ("let h = 3 Lot --> extrude(h) X.", "`let` does not begin a declaration", "write `attr h = 3`"),
        ("attr h Lot --> extrude(h) X.", "expected `=` after this", "write `attr h = …`"),
        ("Lot --> minimumDistance(inter, \"a\") X.", "`minimumDistance` is a function", ""),
        (
            "Lot --> scatter(20) { X. }",
            "operation `scatter` takes 3 or 5",
            "write `scatter(domain, nPoints, distributionType) { … }`",
        ),
        (
            "Lot --> repeat(x) { ~2 : X. }",
            "`repeat` does not take a `{ … }` block",
            "`split(x) { { ~size : … }* }` repeats a slot",
        ),
        ("import lib \"lib.cga\" Lot --> lib.Wall", "expected `:`, found a string", "write `import lib : "),
    ] {
        let list = errors(&format!("grammar A; {rules}"));
        assert!(list.len() == 1 && list[0].starts_with(message), "{rules}: {list:?}");
        assert!(help.is_empty() || list[0].contains(&format!("help: {help}")), "{rules}: {list:?}");
    }
}

#[test]
fn text_is_quoted_with_its_line() {
    let list = errors("grammar A = \"Lot --> X.\nX --> splat(x) { ~1 : X. }\n\";");
    assert_eq!(list.len(), 1, "{list:?}");
    assert!(list[0].contains(":2:7\n"), "{}", list[0]);
    assert!(list[0].contains("2 | X --> splat(x)"), "{}", list[0]);
}

#[test]
fn bytes_of_older_encodings_are_read() {
    assert_eq!(errors("grammar A in \"src/tests/latin1.cga\";"), [] as [&str; 0]);
    assert!(expanded("grammar A in \"src/tests/latin1.cga\";").contains('ü'));
}

#[test]
fn no_path_of_this_machine_gets_into_the_output() {
    let output = expanded("grammar A in \"src/tests/latin1.cga\";") + &expanded("grammar A in \"no/such.cga\";");
    assert!(!output.contains(env!("CARGO_MANIFEST_DIR")), "{output}");
}

#[test]
fn another_path_to_the_runtime_replaces_the_usual_one() {
    for door in
        ["grammar A; attr t = \"x\" Lot --> split(x) { ~1 : X. }", "Lot --> extrude(#height) X.", "grammar A; oops"]
    {
        let output = expanded(&format!("#[cga(crate = my::shapes)] {door}"));
        assert!(output.contains("my :: shapes :: __rt") && !output.contains(":: cga ::"), "{output}");
    }
}

#[test]
fn a_flood_of_findings_ends_with_how_many_there_are() {
    let rules = "Lot --> frobnicate(1) ".repeat(250);
    let list = errors(&format!("grammar A; {rules}"));
    assert_eq!(list.len(), 100);
    assert!(list[99].contains("more are not shown"), "{}", list[99]);
}
