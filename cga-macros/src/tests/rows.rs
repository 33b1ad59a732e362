//! Each row of the tables that runs has its function in the runtime, each word its variant there, and each public function of
//! these modules of the runtime has a row.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cga_lang::ops::{
    COMPONENTS, Changes, Places, Run, all_functions, all_operations, all_shape_attrs, selectors, variant,
};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use syn::{Item, UseTree, Visibility};

use super::doors::root;

/// Functions that the code generator calls for syntax, which has no rows: operators, arrays and indices, text of numbers,
/// the form that operations on slim shapes have in common.
const SYNTAX: &[&str] = &[
    "after",
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
    "instead",
    "less",
    "less_equal",
    "paint",
    "range_by",
    "text_attribute",
    "text_to_text",
    "texts_attribute",
    "unequal",
];

/// The sources of the runtime.
struct Runtime {
    files: Vec<(PathBuf, syn::File)>,
    /// The variants of each public enum.
    enums: BTreeMap<String, BTreeSet<String>>,
}

impl Runtime {
    fn read() -> Runtime {
        let mut files = Vec::new();
        read(&root().join("cga-runtime/src"), &mut files);
        let mut enums: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (_, file) in &files {
            for item in &file.items {
                if let Item::Enum(item) = item
                    && is_public(&item.vis)
                {
                    let variants = item.variants.iter().map(|variant| variant.ident.to_string());
                    enums.entry(item.ident.to_string()).or_default().extend(variants);
                }
            }
        }
        Runtime { files, enums }
    }

    fn file(&self, end: &str) -> &(PathBuf, syn::File) {
        let mut found = self.files.iter().filter(|(path, _)| path.ends_with(end));
        let file = found.next().unwrap_or_else(|| panic!("no file {end}"));
        assert!(found.next().is_none(), "two files {end}");
        file
    }

    /// The public names of a module, by the end of its path.
    fn names(&self, end: &str) -> BTreeSet<String> {
        let (path, file) = self.file(end);
        let mut names = BTreeSet::new();
        for item in &file.items {
            match item {
                Item::Fn(item) if is_public(&item.vis) => _ = names.insert(item.sig.ident.to_string()),
                Item::Enum(item) if is_public(&item.vis) => _ = names.insert(item.ident.to_string()),
                Item::Use(item) if is_public(&item.vis) => self.used(&item.tree, path, &mut names),
                Item::Macro(item) if item.ident.is_none() => {
                    let name = item.mac.path.segments.last().expect("a name").ident.to_string();
                    if name.starts_with("each_material") {
                        let (_, list) = self.file("material/list.rs");
                        list.items.iter().for_each(|item| {
                            if let Item::Macro(item) = item {
                                entries(&item.mac.tokens, &mut names);
                            }
                        });
                    } else {
                        entries(&item.mac.tokens, &mut names);
                    }
                }
                _ => {}
            }
        }
        names
    }

    /// The names of a `pub use`. A glob has those of a module: one beside the file, or at the root of the crate.
    fn used(&self, tree: &UseTree, path: &Path, names: &mut BTreeSet<String>) {
        match tree {
            UseTree::Path(tree) if matches!(*tree.tree, UseTree::Glob(_)) => {
                let name = tree.ident.to_string();
                let beside = path.with_file_name(&name).join("mod.rs");
                let end = self
                    .files
                    .iter()
                    .find(|(path, _)| *path == beside)
                    .map_or_else(|| format!("src/{name}/mod.rs"), |(path, _)| path.display().to_string());
                names.extend(self.names(&end));
            }
            UseTree::Path(tree) => self.used(&tree.tree, path, names),
            UseTree::Name(tree) => _ = names.insert(tree.ident.to_string()),
            UseTree::Rename(tree) => _ = names.insert(tree.rename.to_string()),
            UseTree::Group(tree) => tree.items.iter().for_each(|tree| self.used(tree, path, names)),
            UseTree::Glob(_) => {}
        }
    }
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

/// The functions that rows name.
fn called(runs: impl Iterator<Item = Run>) -> BTreeSet<String> {
    runs.filter_map(Run::now).map(str::to_owned).collect()
}

#[test]
fn rows_and_functions_of_the_runtime_belong_together() {
    let runtime = Runtime::read();
    let operations = || all_operations();
    let of_rows = [
        ("op/mod.rs", called(operations().map(|row| row.run))),
        ("op/slim.rs", called(operations().filter(|row| row.changes == Changes::Scope).map(|row| row.run))),
        ("func/mod.rs", called(all_functions().map(|row| row.run))),
        ("src/get.rs", called(all_shape_attrs().map(|row| row.get))),
        ("src/set.rs", called(all_shape_attrs().filter_map(|row| row.set))),
    ];
    for (module, rows) in of_rows {
        let public = functions(runtime.names(module));
        let lacking: Vec<&String> = rows.difference(&public).collect();
        assert!(lacking.is_empty(), "{module} does not have {lacking:?}");
        let is_syntax = |name: &str| SYNTAX.contains(&name) || name.starts_with("each_");
        let left_over: Vec<&String> = public.difference(&rows).filter(|name| !is_syntax(name)).collect();
        assert!(left_over.is_empty(), "no row runs these functions of {module}: {left_over:?}");
    }
}

#[test]
fn words_are_variants_of_enums_of_the_runtime() {
    let runtime = Runtime::read();
    let operations = all_operations().map(|row| ("op/mod.rs", row.name, row.params, row.run));
    let functions = all_functions().map(|row| ("func/mod.rs", row.name, row.params, row.run));
    for (module, name, params, run) in operations.chain(functions) {
        let public = runtime.names(module);
        for words in params.iter().filter_map(|param| param.kind.words()) {
            assert_eq!(
                words.rust.is_some(),
                run != Run::Later,
                "{name}: rows that run have an enum for words, others have none"
            );
            let Some(rust) = words.rust else { continue };
            assert!(public.contains(rust), "{module} does not have {rust} of {name}");
            let variants = &runtime.enums[rust];
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
    for row in selectors().filter(|row| row.old.is_none() && row.on.meets(Places::COMP)) {
        assert!(enums["Word"].contains(&variant(row.name)), "{}", row.name);
    }
    let components: BTreeSet<String> = COMPONENTS.iter().map(|row| row.rust.to_owned()).collect();
    assert_eq!(components, enums["Components"]);
}
