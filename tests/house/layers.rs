//! The layers of the library crates: a file imports only from its own layer or from below, and no files import each other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cga_tests::tree::root;

/// The layers of a crate, from the ground up: the folders and files of its `src`. `lib.rs` is outside.
struct Layers {
    package: &'static str,
    layers: &'static [&'static str],
}

const CRATES: &[Layers] = &[
    Layers {
        package: "cga-lang",
        layers: &[
            "hash",
            "graph",
            "types",
            "dialect",
            "span",
            "diag",
            "ops",
            "syntax",
            "reference",
            "ir",
            "link",
            "resolve",
            "infer",
            "annotations",
            "analysis",
            "diagnostics",
            "editor",
            "check",
            "lower",
            "compile",
            "snippet",
        ],
    },
    Layers { package: "cga-source", layers: &["file_list", "imports", "read", "root", "rust", "rule_files"] },
    Layers {
        package: "cga-macros",
        layers: &["location", "source", "report", "output", "codegen", "stub", "input", "editor"],
    },
    Layers {
        package: "cga-picture",
        layers: &[
            "threads",
            "raster",
            "gamma",
            "bitmap",
            "palette",
            "png",
            "texture",
            "camera",
            "viewport",
            "style",
            "paint",
            "face",
            "scene",
            "footprint",
            "visible",
            "light",
            "lines",
            "shade",
            "renderer",
        ],
    },
    Layers {
        package: "cga-runtime",
        layers: &[
            "fixed_hash",
            "value",
            "fault",
            "material",
            "shape",
            "asset",
            "run",
            "func",
            "comp",
            "split",
            "query",
            "op",
            "output",
            "grammar",
            "rt",
            "rt_eval",
            "facade",
        ],
    },
    Layers {
        package: "cga-eval",
        layers: &[
            "object",
            "stack",
            "current",
            "call",
            "dispatch",
            "code",
            "steps",
            "program",
            "tables",
            "compile",
            "run",
            "diagnostic",
            "error",
            "rule_file",
            "rule_loader",
            "watch",
            "live",
        ],
    },
];

/// The layers of `cga-geometry`, from the ground up: numbers and the plane, meshes, what follows from origins, and the operations.
/// Files of one layer may import each other, without a cycle.
const GEOMETRY: &[&[&str]] = &[
    &["each", "small_sort", "tol", "work", "exact", "frame", "rotation", "bounds", "vector", "segment", "random"],
    &[
        "bounds_tree",
        "buckets",
        "disjoint",
        "long_sort",
        "status",
        "hull",
        "nesting",
        "uv_map",
        "trace",
        "origin",
        "upward_ray",
    ],
    &["triangulate", "overlay", "skeleton"],
    &["mesh"],
    &["provenance", "wire", "derive", "average_normal", "face_frame"],
    &["solid", "primitive", "extract", "level_face", "unbent", "extrude", "conform", "cut"],
    &["boolean", "cleanup"],
    &[
        "along_uv",
        "convexify",
        "envelope",
        "extrude_wire",
        "footprint",
        "holes",
        "inner_rectangle",
        "obj",
        "offset",
        "recompose",
        "rectify",
        "reduce",
        "relation",
        "roof",
        "scatter",
        "soften",
    ],
];

/// The layers of the operations in `cga-runtime/src/op`.
const OPERATIONS: &[&[&str]] =
    &[&["set", "slim", "report", "scope", "tagging"], &["face", "look", "set_by_name"], &["create", "mesh"]];

/// A module path from the root of a crate.
type Module = Vec<String>;

/// The modules of a crate that have a file, tests left out.
fn modules(src: &Path) -> BTreeMap<Module, PathBuf> {
    fn walk(folder: &Path, at: &Module, found: &mut BTreeMap<Module, PathBuf>) {
        for entry in fs::read_dir(folder).expect("a folder of the crate") {
            let path = entry.expect("an entry").path();
            let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default().to_owned();
            if stem.ends_with("tests") {
                continue;
            }
            let inner = || at.iter().cloned().chain([stem.clone()]).collect::<Module>();
            if path.is_dir() {
                walk(&path, &inner(), found);
            } else if ["mod", "lib", "main"].contains(&&*stem) {
                found.insert(at.clone(), path);
            } else if path.extension().is_some_and(|end| end == "rs") {
                found.insert(inner(), path);
            }
        }
    }
    let mut found = BTreeMap::new();
    walk(src, &Module::new(), &mut found);
    assert!(10 < found.len(), "the walk found the modules of {}", src.display());
    found
}

/// The code of a file without comments and without its test module, line by line.
fn code(text: &str) -> String {
    let mut code = String::new();
    let mut is_test = false;
    for line in text.lines() {
        if is_test && line.starts_with("mod ") && line.ends_with('{') {
            break;
        }
        is_test = line.trim() == "#[cfg(test)]";
        code.push_str(line.split("//").next().unwrap_or_default());
        code.push('\n');
    }
    code
}

/// The paths of a tree of imports such as `a::{b, c::d}`, each after `before`, and the rest of the text.
fn tree<'t>(mut text: &'t str, mut before: Module, paths: &mut Vec<Module>) -> &'t str {
    loop {
        text = text.trim_start();
        if let Some(mut inner) = text.strip_prefix('{') {
            loop {
                inner = tree(inner, before.clone(), paths).trim_start();
                match inner.strip_prefix(',') {
                    Some(next) => inner = next,
                    None => return inner.strip_prefix('}').unwrap_or(inner),
                }
            }
        }
        let end = text.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(text.len());
        if end != 0 {
            before.push(text[..end].to_owned());
        }
        let rest = &text[end..];
        match rest.strip_prefix("::") {
            Some(next) if end != 0 => text = next,
            _ => {
                paths.push(before);
                // A new name for the import.
                let renamed = rest.trim_start().strip_prefix("as ").map(str::trim_start);
                return renamed.map_or(rest, |name| name.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_'));
            }
        }
    }
}

/// The paths in a file that begin at the root of the crate or at a module around it, each with its line.
fn paths(code: &str, own: &Module) -> Vec<(usize, Module)> {
    let mut found = Vec::new();
    for start in ["crate::", "super::"] {
        for (at, _) in code.match_indices(start) {
            let is_inner = code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == ':' || c == '$');
            let mut base = if start == "crate::" { Module::new() } else { own.clone() };
            if is_inner {
                continue;
            }
            let mut text = &code[at..];
            while let Some(rest) = text.strip_prefix("super::") {
                base.pop();
                text = rest;
            }
            let mut list = Vec::new();
            tree(text.strip_prefix("crate::").unwrap_or(text), base, &mut list);
            let line = code[..at].matches('\n').count() + 1;
            found.extend(list.into_iter().map(|path| (line, path)));
        }
    }
    found
}

/// An import of one file by another.
struct Arrow {
    from: Module,
    to: Module,
    place: String,
}

/// The imports of a crate between its files.
fn arrows(src: &Path) -> Vec<Arrow> {
    let modules = modules(src);
    let mut arrows = Vec::new();
    for (own, file) in &modules {
        let text = fs::read_to_string(file).expect("text");
        for (line, path) in paths(&code(&text), own) {
            let to = (1..=path.len()).rev().map(|length| path[..length].to_vec()).find(|to| modules.contains_key(to));
            let Some(to) = to.filter(|to| to != own && !own.is_empty()) else { continue };
            let place = format!("{}:{line}: {} uses {}", file.display(), own.join("::"), to.join("::"));
            arrows.push(Arrow { from: own.clone(), to, place });
        }
    }
    assert!(10 < arrows.len(), "the imports of {}", src.display());
    arrows
}

fn src(package: &str) -> PathBuf {
    root().join(package).join("src")
}

#[test]
fn imports_point_down() {
    for Layers { package, layers } in CRATES {
        let layer = |module: &Module| {
            let at = layers.iter().position(|layer| *layer == module[0]);
            at.unwrap_or_else(|| panic!("{package}: `{}` has no place in the table of layers", module[0]))
        };
        let up = arrows(&src(package)).into_iter().filter(|arrow| layer(&arrow.from) < layer(&arrow.to));
        let up: Vec<String> = up.map(|arrow| arrow.place).collect();
        assert!(up.is_empty(), "imports from a higher layer: {up:#?}");
    }
}

/// The imports between the modules inside a module, or inside the crate, that point up.
fn imports_up(package: &str, inside: &[&str], layers: &[&[&str]]) -> Vec<String> {
    let depth = inside.len();
    let layer = |module: &Module| {
        let at = layers.iter().position(|layer| layer.contains(&&*module[depth]));
        at.unwrap_or_else(|| panic!("{package}: `{}` has no place in the table of layers", module.join("::")))
    };
    let is_inside = |module: &Module| depth < module.len() && module[..depth] == *inside;
    let arrows = arrows(&src(package)).into_iter().filter(|arrow| is_inside(&arrow.from) && is_inside(&arrow.to));
    let up = arrows.filter(|arrow| layer(&arrow.from) < layer(&arrow.to));
    up.map(|arrow| arrow.place).collect()
}

#[test]
fn imports_of_geometry_point_down() {
    let up = imports_up("cga-geometry", &[], GEOMETRY);
    assert!(up.is_empty(), "imports from a higher layer: {up:#?}");
}

#[test]
fn imports_of_operations_point_down() {
    let up = imports_up("cga-runtime", &["op"], OPERATIONS);
    assert!(up.is_empty(), "imports from a higher layer: {up:#?}");
}

/// A module and those inside it are one thing to their reader, so imports between them do not count.
#[test]
fn no_files_import_each_other() {
    for package in CRATES.iter().map(|layers| layers.package).chain(["cga-geometry", "cga-street", "cga-cli"]) {
        let mut arrows = arrows(&src(package));
        arrows.retain(|Arrow { from, to, .. }| !from.starts_with(to) && !to.starts_with(from));
        loop {
            let users: BTreeSet<Module> = arrows.iter().map(|arrow| arrow.from.clone()).collect();
            let used: BTreeSet<Module> = arrows.iter().map(|arrow| arrow.to.clone()).collect();
            let before = arrows.len();
            // Nothing goes on from, or comes to, the ends of a chain of imports.
            arrows.retain(|arrow| users.contains(&arrow.to) && used.contains(&arrow.from));
            if arrows.len() == before {
                break;
            }
        }
        let cycles: Vec<String> = arrows.into_iter().map(|arrow| arrow.place).collect();
        assert!(cycles.is_empty(), "cycles, or imports between two of them: {cycles:#?}");
    }
}
