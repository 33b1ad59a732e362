//! Each row of the tables that runs has its function in the runtime, each word its variant there, and each public function of
//! these modules of the runtime has a row.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cga_lang::ops::{
    Braces, COMPONENTS, Changes, Operation, SET_BY_NAME, SelectorPlaces, all_functions, all_operations,
    all_shape_attrs, operations, selectors, variant,
};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::ToTokens;
use syn::{ImplItem, Item, UseTree, Visibility};

use super::sources::root;

/// Functions that the code generator calls for syntax, which has no rows: operators, arrays and indices, text of numbers,
/// the form that operations on slim shapes have in common.
const SYNTAX: &[&str] = &[
    "array",
    "array_to_text",
    "attribute",
    "bool_attribute",
    "bool_to_text",
    "bools_attribute",
    "concat",
    "element",
    "element_at",
    "elements",
    "elements_at",
    "equal",
    "float_attribute",
    "float_to_text",
    "floats_attribute",
    "greater",
    "greater_equal",
    "less",
    "less_equal",
    "change_coordinates",
    "change_material",
    "range_by",
    "text_attribute",
    "text_to_text",
    "texts_attribute",
    "unequal",
];

/// The sources of the runtime.
struct Runtime {
    files: Vec<(PathBuf, syn::File)>,
    /// The variants of each public enum, and the public constants of each type.
    enums: BTreeMap<String, BTreeSet<String>>,
}

impl Runtime {
    fn read() -> Runtime {
        let mut files = Vec::new();
        read(&sources(), &mut files);
        // Some enums come from below.
        read(&root().join("cga-geometry/src"), &mut files);
        let mut enums: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (_, file) in &files {
            for item in &file.items {
                match item {
                    Item::Enum(item) if is_public(&item.vis) => {
                        let variants = item.variants.iter().map(|variant| variant.ident.to_string());
                        enums.entry(item.ident.to_string()).or_default().extend(variants);
                    }
                    Item::Impl(item) => {
                        let words = item.items.iter().filter_map(|item| match item {
                            ImplItem::Const(word) if is_public(&word.vis) => Some(word.ident.to_string()),
                            _ => None,
                        });
                        enums.entry(item.self_ty.to_token_stream().to_string()).or_default().extend(words);
                    }
                    _ => {}
                }
            }
        }
        Runtime { files, enums }
    }

    /// The file of a module, below the sources.
    fn file(&self, module: &Path) -> &(PathBuf, syn::File) {
        let places = [module.with_extension("rs"), module.join("mod.rs")].map(|place| sources().join(place));
        let file = self.files.iter().find(|(path, _)| places.contains(path));
        file.unwrap_or_else(|| panic!("no module {}", module.display()))
    }

    /// The public names of a module of `rt.rs`, which is what generated code sees.
    fn names(&self, module: &str) -> BTreeSet<String> {
        let (mut names, (_, rt)) = (BTreeSet::new(), self.file(Path::new("rt")));
        for item in &rt.items {
            match item {
                Item::Mod(item) if item.ident == module => {
                    let (_, items) = item.content.as_ref().expect("a module in place");
                    self.add(items, Path::new(""), &mut names);
                }
                Item::Use(item) => {
                    if let Some(path) = imported(&item.tree, module, Path::new("")) {
                        let (_, file) = self.file(&path);
                        self.add(&file.items, &path, &mut names);
                    }
                }
                _ => {}
            }
        }
        assert!(!names.is_empty(), "rt.rs has no {module}");
        names
    }

    /// Adds the public names among the items of a module.
    fn add(&self, items: &[Item], module: &Path, names: &mut BTreeSet<String>) {
        for item in items {
            match item {
                Item::Fn(item) if is_public(&item.vis) => _ = names.insert(item.sig.ident.to_string()),
                Item::Enum(item) if is_public(&item.vis) => _ = names.insert(item.ident.to_string()),
                Item::Use(item) if is_public(&item.vis) => self.used(&item.tree, module, names),
                Item::Macro(item) if item.ident.is_none() => match item.mac.path.get_ident() {
                    // Their entries are arguments of other macros.
                    Some(name) if name.to_string().starts_with("each_material") => {
                        let (_, list) = self.file(Path::new("material/list"));
                        list.items.iter().for_each(|item| {
                            if let Item::Macro(item) = item {
                                entries(&item.mac.tokens, names);
                            }
                        });
                    }
                    _ => entries(&item.mac.tokens, names),
                },
                _ => {}
            }
        }
    }

    /// Adds the names of a `pub use` in a module.
    fn used(&self, tree: &UseTree, module: &Path, names: &mut BTreeSet<String>) {
        match tree {
            UseTree::Path(tree) if tree.ident == "crate" => self.used(&tree.tree, Path::new(""), names),
            UseTree::Path(tree) => self.used(&tree.tree, &module.join(tree.ident.to_string()), names),
            UseTree::Name(tree) => _ = names.insert(tree.ident.to_string()),
            UseTree::Rename(tree) => _ = names.insert(tree.rename.to_string()),
            UseTree::Group(tree) => tree.items.iter().for_each(|tree| self.used(tree, module, names)),
            UseTree::Glob(_) => self.add(&self.file(module).1.items, module, names),
        }
    }
}

/// The path of a module that a `use` brings in.
fn imported(tree: &UseTree, module: &str, path: &Path) -> Option<PathBuf> {
    match tree {
        UseTree::Path(tree) if tree.ident == "crate" => imported(&tree.tree, module, path),
        UseTree::Path(tree) => imported(&tree.tree, module, &path.join(tree.ident.to_string())),
        UseTree::Name(tree) => (tree.ident == module).then(|| path.join(module)),
        UseTree::Group(tree) => tree.items.iter().find_map(|tree| imported(tree, module, path)),
        UseTree::Rename(_) | UseTree::Glob(_) => None,
    }
}

fn sources() -> PathBuf {
    root().join("cga-runtime/src")
}

fn read(folder: &Path, files: &mut Vec<(PathBuf, syn::File)>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            read(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).expect("a file");
            let file = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            files.push((path, file));
        }
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// The names of the entries of a macro: the first word of each, after its doc comments. Entries end with `;`.
fn entries(tokens: &TokenStream, names: &mut BTreeSet<String>) {
    let mut is_first = true;
    for token in tokens.clone() {
        match token {
            // `$make! { … }` is the call of another macro with the entries.
            TokenTree::Punct(sign) if sign.as_char() == '$' => is_first = false,
            TokenTree::Ident(name) if is_first => {
                names.insert(name.to_string());
                is_first = false;
            }
            TokenTree::Punct(sign) if sign.as_char() == ';' => is_first = true,
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => entries(&group.stream(), names),
            _ => {}
        }
    }
}

fn functions(names: BTreeSet<String>) -> BTreeSet<String> {
    names.into_iter().filter(|name| name.starts_with(|first: char| first.is_ascii_lowercase())).collect()
}

/// Returns true if the function of an operation is in the module `op`. The code generator has code for slots and components.
pub(super) fn is_in_op(row: &&'static Operation) -> bool {
    !matches!(row.braces, Braces::Slots(_) | Braces::Components)
}

/// The functions that rows name.
fn called(runs: impl Iterator<Item = &'static str>) -> BTreeSet<String> {
    runs.map(str::to_owned).collect()
}

#[test]
fn rows_and_functions_of_the_runtime_belong_together() {
    let runtime = Runtime::read();
    let operations = || all_operations().chain([&SET_BY_NAME]).filter(is_in_op);
    let of_rows = [
        ("op", called(operations().map(|row| row.run))),
        ("slim", called(operations().filter(|row| row.changes == Changes::Scope).map(|row| row.run))),
        ("func", called(all_functions().map(|row| row.run))),
        ("get", called(all_shape_attrs().map(|row| row.get))),
        ("set", called(all_shape_attrs().filter_map(|row| row.set))),
    ];
    let mut idle: BTreeSet<&str> = SYNTAX.iter().copied().collect();
    for (module, rows) in of_rows {
        let public = functions(runtime.names(module));
        idle.retain(|name| !public.contains(*name));
        let lacking: Vec<&String> = rows.difference(&public).collect();
        assert!(lacking.is_empty(), "`{module}` does not have {lacking:?}");
        let is_syntax = |name: &str| SYNTAX.contains(&name) || name.starts_with("each_");
        let left_over: Vec<&String> = public.difference(&rows).filter(|name| !is_syntax(name)).collect();
        assert!(left_over.is_empty(), "no row runs these functions of `{module}`: {left_over:?}");
    }
    assert!(idle.is_empty(), "no module has {idle:?}");
}

#[test]
fn words_are_variants_of_enums_of_the_runtime() {
    let runtime = Runtime::read();
    let (of_op, of_func) = (runtime.names("op"), runtime.names("func"));
    let operations = all_operations().map(|row| (Some(&of_op), row));
    let operations = operations.map(|(module, row)| (module.filter(|_| is_in_op(&row)), row.name, row.params));
    let functions = all_functions().map(|row| (Some(&of_func), row.name, row.params));
    for (module, name, params) in operations.chain(functions) {
        for words in params.iter().filter_map(|param| param.kind.words()) {
            let rust = words.rust;
            assert!(module.is_none_or(|public| public.contains(rust)), "the module of {name} does not have {rust}");
            let variants = runtime.enums.get(rust).unwrap_or_else(|| panic!("no enum {rust} for {name}"));
            for word in words.list {
                let variant = words.variant(word);
                assert!(variants.contains(&variant), "{rust} does not have {variant}, which is `{word}` of {name}");
            }
        }
    }
}

#[test]
fn selectors_and_components_are_variants_of_enums_of_the_runtime() {
    let enums = Runtime::read().enums;
    for row in selectors().filter(|row| row.old.is_none() && row.on.meets(SelectorPlaces::COMP)) {
        assert!(enums["Word"].contains(&variant(row.name)), "{}", row.name);
    }
    let row = operations("comp").next().expect("a row");
    let words = row.params[0].kind.words().expect("the kinds of components");
    let components: BTreeSet<String> = COMPONENTS.iter().map(|row| words.variant(row.name)).collect();
    assert_eq!(components, enums["Components"]);
}
