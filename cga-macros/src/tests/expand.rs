//! Snapshots of generated code, in `expand/`: `NAME.cga` is the input of the macro, `NAME.rs` its output.
//!
//! The first line of the input says which part is shown. `CGA_BLESS=1` rewrites what is expected.

use std::fs;
use std::path::Path;

use proc_macro2::{TokenStream, TokenTree};
use syn::{File, Item};

#[path = "../../../tests/benches/build/facade.rs"]
mod facade;

/// The part of an expansion that a test shows.
fn part(show: &str, file: File) -> Vec<Item> {
    let mut items = Vec::new();
    for item in file.items {
        if is_for_editors(&item) != (show == "names") {
            continue;
        }
        match item {
            Item::Const(names) if show == "names" => items.push(Item::Const(names)),
            Item::Const(hidden) if show != "findings" => {
                if let syn::Expr::Block(block) = *hidden.expr {
                    items.extend(block.block.stmts.into_iter().filter_map(|statement| match statement {
                        syn::Stmt::Item(item) => Some(item),
                        _ => None,
                    }));
                }
            }
            other => items.push(other),
        }
    }
    items.retain(|item| wanted(show, item));
    items.iter_mut().for_each(without_methods);
    items
}

/// Takes the methods of the struct out of a const: they are the same in every grammar, and shown on their own.
fn without_methods(item: &mut Item) {
    let Item::Const(item) = item else { return };
    if let syn::Expr::Block(block) = &mut *item.expr {
        block.block.stmts.retain(|it| !matches!(it, syn::Stmt::Item(Item::Impl(it)) if it.trait_.is_none()));
    }
}

/// Returns true for the const with the names for editors.
fn is_for_editors(item: &Item) -> bool {
    let Item::Const(item) = item else { return false };
    let syn::Expr::Block(block) = &*item.expr else { return false };
    block.block.stmts.iter().any(|it| matches!(it, syn::Stmt::Item(Item::Mod(module)) if module.ident == "names"))
}

fn wanted(show: &str, item: &Item) -> bool {
    let (is_trait, owner) = match item {
        Item::Impl(item) => {
            let owner = if let syn::Type::Path(path) = &*item.self_ty { path.path.get_ident() } else { None };
            let name = item.trait_.as_ref().and_then(|(path, _)| path.segments.last());
            (name.map(|name| name.ident.to_string()), owner.map(ToString::to_string).unwrap_or_default())
        }
        _ => (None, String::new()),
    };
    match show {
        "struct" => {
            matches!(item, Item::Struct(it) if it.ident != "CgaValues" && it.ident != "CgaRules")
                || is_trait.as_deref() == Some("Default")
        }
        "methods" => is_trait.is_none() && !owner.is_empty() && owner != "CgaRules" && owner != "CgaValues",
        "lazy" => owner == "CgaValues" || is_trait.as_deref() == Some("Rules"),
        "values" => {
            matches!(item, Item::Struct(it) if it.ident == "CgaValues") || matches!(item, Item::Enum(_) | Item::Type(_))
        }
        "rules" => owner == "CgaRules",
        "run" => is_trait.as_deref() == Some("Rules"),
        "table" => is_trait.as_deref() == Some("Grammar"),
        "names" => true,
        "findings" => matches!(item, Item::Macro(_) | Item::Const(_)),
        other => panic!("no part `{other}`"),
    }
}

/// The items that an expansion consists of, with an expression's taken out of its block.
fn items(output: TokenStream) -> File {
    if let Ok(file) = syn::parse2::<File>(output.clone()) {
        return file;
    }
    let Ok(syn::Expr::Match(mut whole)) = syn::parse2(output) else { panic!("neither items nor an expression") };
    let syn::Expr::Block(body) = *whole.arms.remove(0).body else { panic!("no block") };
    let items = body.block.stmts.into_iter().filter_map(|statement| match statement {
        syn::Stmt::Item(item) => Some(item),
        _ => None,
    });
    File { shebang: None, frontmatter: None, attrs: Vec::new(), items: items.collect() }
}

#[test]
fn generated_code_is_as_reviewed() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/tests/expand");
    let bless = std::env::var_os("CGA_BLESS").is_some();
    let mut inputs: Vec<_> =
        fs::read_dir(&folder).expect("readable folder").map(|entry| entry.unwrap().path()).collect();
    inputs.retain(|path| path.extension().is_some_and(|extension| extension == "cga"));
    inputs.sort();
    assert!(5 < inputs.len());
    let mut wrong = String::new();
    for path in inputs {
        let input = fs::read_to_string(&path).expect("readable input");
        let show =
            input.lines().next().and_then(|line| line.strip_prefix("// show ")).expect("a first line that says what");
        let stream: TokenStream = input.parse().unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        // Two expansions: for compilers and for editors.
        let whole = items(if show == "names" { crate::editor::expand(stream) } else { crate::expand(stream) });
        let shown = File { shebang: None, frontmatter: None, attrs: Vec::new(), items: part(show, whole) };
        let actual = prettyplease::unparse(&shown);
        assert!(actual.lines().count() <= 150, "{} is longer than anybody reads", path.display());
        let expected = path.with_extension("rs");
        if fs::read_to_string(&expected).unwrap_or_default() == actual {
            continue;
        }
        if bless {
            fs::write(&expected, actual).expect("writable snapshot");
        } else {
            wrong.push_str(&format!("{}:\n{actual}\n", expected.display()));
        }
    }
    assert!(wrong.is_empty(), "{wrong}CGA_BLESS=1 accepts this");
}

#[test]
fn equal_input_gives_equal_output() {
    let expand = || {
        let input = "grammar A; attr x = rand f(n) = case n > 0 : f(n - 1) else : 0
            Lot --> split(x) { ~1 : B | 2 : Lot } B --> C C --> comp(f) { all : B } D(a, b) --> X.";
        crate::expand(input.parse().expect("Rust tokens")).to_string()
    };
    assert_eq!(expand(), expand());
}

#[test]
fn locals_are_kept_apart_from_parameters() {
    fn collect(stream: TokenStream, names: &mut Vec<String>) {
        // The token before, without `mut`.
        let (mut before, mut in_parameters) = (String::new(), false);
        for token in stream {
            let text = match token {
                TokenTree::Group(group) => {
                    collect(group.stream(), names);
                    "()".into()
                }
                token => token.to_string(),
            };
            // A closure, not the operator.
            if text == "|" {
                in_parameters = !in_parameters && matches!(before.as_str(), "" | "," | "=" | "&");
            }
            if text.starts_with(|c: char| c.is_ascii_lowercase()) && text != "mut" && (in_parameters || before == "let")
            {
                names.push(text.clone());
            }
            if text != "mut" {
                before = text;
            }
        }
    }
    let (mut locals, mut written) = (Vec::new(), String::new());
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/tests/expand");
    for entry in fs::read_dir(folder).expect("readable folder") {
        let path = entry.expect("readable folder").path();
        if path.extension().is_some_and(|extension| extension == "cga") {
            let input = fs::read_to_string(&path).expect("readable");
            let rules = part("rules", items(crate::expand(input.parse().expect("Rust tokens"))));
            rules.iter().for_each(|item| collect(quote::quote!(#item), &mut locals));
            written += &input;
        }
    }
    let names = written.split(|c: char| !c.is_alphanumeric() && c != '_');
    let names: std::collections::HashSet<&str> = names.collect();
    locals.retain(|local| !names.contains(local.as_str()) && !crate::codegen::is_local(local));
    assert_eq!(locals, [""; 0], "`codegen/names.rs` lists the locals of generated code");
}

#[test]
fn expansions_stay_small() {
    // Emitted tokens for each token of the rules, over all snapshots. It may fall, not rise.
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/tests/expand");
    let (mut read, mut written) = (0, 0);
    for entry in fs::read_dir(folder).expect("readable folder") {
        let path = entry.expect("readable folder").path();
        if path.extension().is_some_and(|extension| extension == "cga") {
            let stream: TokenStream = fs::read_to_string(&path).expect("readable").parse().expect("Rust tokens");
            read += count(stream.clone());
            written += count(crate::expand(stream));
        }
    }
    let ratio = written as f64 / read as f64;
    assert!(ratio < 60.0, "{ratio}");
}

#[test]
fn expansions_for_editors_stay_small() {
    // An editor passes over the whole expansion for each token of the user.
    let mut text = String::from("grammar Town; attr height = 24 Roof --> roofHip(30)");
    for number in 0..200 {
        let next = (number + 1) % 200;
        text += &format!(
            " Wall{number}(w) --> split(y) {{ ~3 : Tile{number}(w, height) | 1 : s(1, scope.sy, 2) Roof }}
            Tile{number}(w, h) --> case w > h : color(\"#ff0000\") Wall{next}(w) else : comp(f) {{ front : Roof }}"
        );
    }
    let stream: TokenStream = text.parse().expect("Rust tokens");
    let read = count(stream.clone());
    let (compiled, edited) = (count(crate::expand(stream.clone())), count(crate::editor::expand(stream)));
    assert!(
        edited < 2 * read && 10 * edited < compiled,
        "{read} tokens: {compiled} for compilers, {edited} for editors"
    );
}

#[test]
fn styles_share_their_code() {
    // A style adds its own definitions and a choice for each, whatever the file has besides.
    let tokens = |styles| {
        let text = format!("grammar Facade = {:?};", facade::rules(styles));
        count(crate::expand(text.parse().expect("a string")))
    };
    let ratio = tokens(14) as f64 / tokens(0) as f64;
    assert!(ratio < 1.5, "{ratio}");
}

#[test]
fn sites_of_an_import_share_their_code() {
    // A site adds the attributes of the library and a choice where they are read, whatever the library has besides. Rule files
    // must be in the package.
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = format!("target/sites-{}", std::process::id());
    let tokens = |wings: usize| {
        let folder = format!("{folder}/{wings}");
        fs::create_dir_all(package.join(&folder)).expect("a folder");
        for (name, text) in facade::imports(wings) {
            fs::write(package.join(&folder).join(name), text).expect("a file");
        }
        let text = format!("grammar Building in \"{folder}/main.cga\";");
        count(crate::expand(text.parse().expect("a path")))
    };
    let ratio = tokens(4) as f64 / tokens(0) as f64;
    fs::remove_dir_all(package.join(&folder)).expect("a folder");
    assert!(1.5 < ratio && ratio < 2.5, "{ratio}");
}

fn count(stream: TokenStream) -> usize {
    let tokens = stream.into_iter().map(|token| match token {
        proc_macro2::TokenTree::Group(group) => 2 + count(group.stream()),
        _ => 1,
    });
    tokens.sum()
}
