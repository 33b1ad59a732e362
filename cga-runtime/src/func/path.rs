//! The parts of a file's path.

use crate::run::env::Env;
use crate::value::text::Text;

/// The directory with the last `/`, and the name.
fn parts(path: &str) -> (&str, &str) {
    path.split_at(path.rfind('/').map_or(0, |slash| slash + 1))
}

/// The name without directory and extension (*fileBasename*).
pub fn file_basename(env: &mut Env, path: Text) -> Text {
    let (_, name) = parts(&path);
    env.copy(name.rsplit_once('.').map_or(name, |(base, _)| base))
}

/// The directory with the last `/`; "" without one (*fileDirectory*).
pub fn file_directory(env: &mut Env, path: Text) -> Text {
    env.copy(parts(&path).0)
}

/// The part of the name after the last `.`; "" without one (*fileExtension*).
pub fn file_extension(env: &mut Env, path: Text) -> Text {
    env.copy(parts(&path).1.rsplit_once('.').map_or("", |(_, extension)| extension))
}

/// The name without the directory (*fileName*).
pub fn file_name(env: &mut Env, path: Text) -> Text {
    env.copy(parts(&path).1)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, text};
    use super::*;

    #[test]
    fn paths_have_parts() {
        let env = &mut env();
        // *fileBasename*, *fileDirectory*, *fileExtension*, *fileName*.
        for (path, directory, base, extension, name) in [
            ("assets/obj/mygeometry.01.obj", "assets/obj/", "mygeometry.01", "obj", "mygeometry.01.obj"),
            ("a.b/c", "a.b/", "c", "", "c"),
            ("größe.jpg", "", "größe", "jpg", "größe.jpg"),
            ("/", "/", "", "", ""),
            (".hidden", "", "", "hidden", ".hidden"),
            ("", "", "", "", ""),
        ] {
            assert_eq!(file_directory(env, text(path)).as_str(), directory);
            assert_eq!(file_basename(env, text(path)).as_str(), base);
            assert_eq!(file_extension(env, text(path)).as_str(), extension);
            assert_eq!(file_name(env, text(path)).as_str(), name);
        }
    }
}
