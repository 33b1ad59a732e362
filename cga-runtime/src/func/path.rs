//! The parts of a file's path.

use crate::value::text::Text;

/// The directory with the last `/`, and the name.
fn parts(path: &str) -> (&str, &str) {
    path.split_at(path.rfind('/').map_or(0, |slash| slash + 1))
}

/// The name without directory and extension (*fileBasename*).
pub fn file_basename(path: Text) -> Text {
    let (_, name) = parts(&path);
    Text::from(name.rsplit_once('.').map_or(name, |(base, _)| base))
}

/// The directory with the last `/`; "" without one (*fileDirectory*).
pub fn file_directory(path: Text) -> Text {
    Text::from(parts(&path).0)
}

/// The part of the name after the last `.`; "" without one (*fileExtension*).
pub fn file_extension(path: Text) -> Text {
    Text::from(parts(&path).1.rsplit_once('.').map_or("", |(_, extension)| extension))
}

/// The name without the directory (*fileName*).
pub fn file_name(path: Text) -> Text {
    Text::from(parts(&path).1)
}

#[cfg(test)]
mod tests {
    use super::super::tests::text;
    use super::*;

    #[test]
    fn paths_have_parts() {
        // *fileBasename*, *fileDirectory*, *fileExtension*, *fileName*.
        for (path, directory, base, extension, name) in [
            ("assets/obj/mygeometry.01.obj", "assets/obj/", "mygeometry.01", "obj", "mygeometry.01.obj"),
            ("a.b/c", "a.b/", "c", "", "c"),
            ("größe.jpg", "", "größe", "jpg", "größe.jpg"),
            ("/", "/", "", "", ""),
            (".hidden", "", "", "hidden", ".hidden"),
            ("", "", "", "", ""),
        ] {
            assert_eq!(file_directory(text(path)).as_str(), directory);
            assert_eq!(file_basename(text(path)).as_str(), base);
            assert_eq!(file_extension(text(path)).as_str(), extension);
            assert_eq!(file_name(text(path)).as_str(), name);
        }
    }
}
