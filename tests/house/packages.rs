//! The manifests: what a registry asks of a package.

use std::fs;
use std::path::Path;

use cga_tests::tree::root;

const PACKAGES: [&str; 11] = [
    "",
    "cga-cli",
    "cga-eval",
    "cga-geometry",
    "cga-lang",
    "cga-macros",
    "cga-picture",
    "cga-runtime",
    "cga-source",
    "cga-split",
    "cga-street",
];

/// The elements of `key = ["…", …]`, which may have several lines.
fn list<'t>(manifest: &'t str, key: &str) -> Vec<&'t str> {
    let start = manifest.find(&format!("\n{key} = [")).unwrap_or_else(|| panic!("{key} is missing"));
    let rest = &manifest[start..];
    let inner = &rest[rest.find('[').expect("it begins")..rest.find(']').expect("it ends")];
    inner.split('"').skip(1).step_by(2).collect()
}

#[test]
fn packages_have_keywords_categories_licences_and_a_readme() {
    for package in PACKAGES {
        let folder = root().join(package);
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).expect("the manifest");
        let keywords = list(&manifest, "keywords");
        assert!((1..=5).contains(&keywords.len()) && keywords.iter().all(|word| word.len() <= 20), "{package}");
        assert!((1..=5).contains(&list(&manifest, "categories").len()), "{package}");
        assert!(manifest.contains("readme = \"README.md\"") && manifest.contains("\ndescription = "), "{package}");
        let readme = fs::read_to_string(folder.join("README.md")).expect("a README");
        assert!(readme.starts_with("# cga"), "{package}");
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let own = fs::read_to_string(folder.join(licence)).expect("a licence");
            let first = fs::read_to_string(root().join(licence)).expect("a licence");
            assert_eq!(own, first, "{package}/{licence}");
        }
    }
}

#[test]
fn files_that_pages_of_the_package_show_are_inside() {
    let root = root();
    let manifest = fs::read_to_string(root.join("Cargo.toml")).expect("the manifest");
    // The workspace has a list of that name, too.
    let excluded = list(&manifest[manifest.find("\n[package]").expect("a package")..], "exclude");
    for file in ["README.md", "docs/guide/tutorial.md", "docs/cutting.md", "docs/offset.md"] {
        let text = fs::read_to_string(root.join(file)).expect("a page");
        for picture in text.split(['(', ' ', '\n']).filter_map(|part| Some(&part[..part.find(".png")? + 4])) {
            let path = Path::new(file).with_file_name(picture);
            let found = [path.clone(), picture.into()].into_iter().find(|path| root.join(path).exists());
            let Some(path) = found else { continue };
            // The last rule for a file counts; a rule with `!` takes files in again.
            let covers = |rule: &&&str| path.starts_with(rule.trim_start_matches(['!', '/']).trim_end_matches("/*"));
            let is_out = excluded.iter().rfind(covers).is_some_and(|rule| !rule.starts_with('!'));
            assert!(!is_out, "{file} shows {}", path.display());
        }
    }
}
