//! The name of the running program, for lines that a person can type.

use std::path::Path;

/// The name with which the program was started: `target/release/cga-city` by `cargo run`, `cga-city` when it is installed. A name with spaces is
/// in quotation marks.
///
/// ```
/// let name = cga_city::program::name("cga-city");
/// assert!(!name.is_empty());
/// ```
///
/// `usual` is the name for a system that does not tell it.
pub fn name(usual: &str) -> String {
    let name = std::env::args_os().next().filter(|name| !name.is_empty());
    name.map_or_else(|| usual.to_owned(), |name| typed(Path::new(&name)))
}

fn typed(path: &Path) -> String {
    let name = path.display().to_string();
    if name.contains(char::is_whitespace) { format!("\"{name}\"") } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_spaces_are_in_quotation_marks() {
        assert_eq!(typed(Path::new("target/release/cga-city")), "target/release/cga-city");
        assert_eq!(typed(Path::new("my files/cga-city")), "\"my files/cga-city\"");
    }
}
