//! Files: `fileExists`, `fileSearch`, `fileRandom`, `assetInfo`, `imageInfo` and `readTextFile`.

use crate::asset::image::header;
use crate::asset::{AssetError, BUILTINS, File};
use crate::geometry::Axis;
use crate::material::Material;
use crate::run::env::Env;
use crate::shape::view::View;
use crate::value::array::Array;
use crate::value::text::Text;

/// The largest size of a text file, in bytes.
const LONGEST_TEXT: u64 = 4 << 20;

/// `fileExists(file)`: true if there is such a file of a supported kind (*fileExists function*).
pub fn file_exists(env: &Env, file: File) -> bool {
    env.settings.assets.exists(&file)
}

/// `fileSearch(query)`: the files found as a sorted list, each followed by `;` (*fileSearch / filesSearch
/// functions*). Paths are relative to the asset folder. A path begins with a slash if the rule file would find
/// another file by the path without it.
pub fn file_search(env: &mut Env, query: File) -> Text {
    let found = env.files(&query);
    list(env, &found)
}

/// The texts as a list.
pub(super) fn list(env: &mut Env, texts: &[Text]) -> Text {
    if !env.may_write(texts.iter().map(|text| text.len() + 1).sum()) {
        return Text::default();
    }
    let mut list = String::new();
    for text in texts {
        list += text;
        list.push(';');
    }
    Text::from(list)
}

/// `filesSearch(query)`: the files found, sorted (*fileSearch / filesSearch functions*).
pub fn files_search(env: &mut Env, query: File) -> Array<Text> {
    let found = env.files(&query);
    if env.may_hold(found.len()) { found.iter().cloned().collect() } else { Array::default() }
}

/// `fileRandom(query)`: a random file of those found; empty if there are none (*fileRandom*). It always draws one
/// random number.
pub fn file_random(env: &mut Env, shape: &mut impl View, query: File) -> Text {
    let (draw, found) = (shape.draw(), env.files(&query));
    found.get((draw * found.len() as f64) as usize).cloned().unwrap_or_default()
}

/// The result of `assetInfo`: the size or the lowest coordinate along an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AssetDimension {
    of_size: bool,
    axis: Axis,
}

#[allow(missing_docs, non_upper_case_globals, reason = "the language defines the names")]
impl AssetDimension {
    pub const Sx: AssetDimension = AssetDimension { of_size: true, axis: Axis::X };
    pub const Sy: AssetDimension = AssetDimension { of_size: true, axis: Axis::Y };
    pub const Sz: AssetDimension = AssetDimension { of_size: true, axis: Axis::Z };
    pub const Tx: AssetDimension = AssetDimension { of_size: false, axis: Axis::X };
    pub const Ty: AssetDimension = AssetDimension { of_size: false, axis: Axis::Y };
    pub const Tz: AssetDimension = AssetDimension { of_size: false, axis: Axis::Z };
}

/// `assetInfo(file, sx | sy | sz | tx | ty | tz)`: size and lowest corner of an asset's bounding box, in metres
/// (*assetInfo function*). If the asset is missing, 0 with a fault.
pub fn asset_info(env: &mut Env, file: File, dimension: AssetDimension) -> f64 {
    let bounds = match env.settings.assets.mesh_of(&file) {
        Ok(mesh) => mesh.bounds(),
        Err(why) => return unknown(env, &file, &why),
    };
    let (size, low) = (bounds.size(), if bounds.low.is_finite() { bounds.low } else { glam::DVec3::ZERO });
    (if dimension.of_size { size } else { low })[dimension.axis.index()]
}

/// The names that `assetNamingInfo` lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AssetNaming {
    /// Groups.
    Groups,
    /// Materials.
    Materials,
}

/// `assetNamingInfos(file, g | m)`: the names of an asset's groups or materials, in its order (*assetNamingInfo /
/// assetNamingInfos functions*). If the asset is missing, an empty array with a fault.
pub fn asset_naming_infos(env: &mut Env, file: File, what: AssetNaming) -> Array<Text> {
    let mesh = match env.settings.assets.mesh_of(&file) {
        Ok(mesh) => mesh,
        Err(why) => {
            env.asset_fault(format!("`{file}` cannot be read: {why}; the list of names is empty"));
            return Array::default();
        }
    };
    let names: Vec<Text> = match what {
        AssetNaming::Groups => mesh.groups().iter().map(|name| Text::from(name.as_str())).collect(),
        AssetNaming::Materials => {
            mesh.materials::<Material>().iter().map(|look| look.name.clone().unwrap_or_default()).collect()
        }
    };
    if env.may_hold(names.len()) { Array::from(names) } else { Array::default() }
}

/// `assetNamingInfo(file, g | m)`: the names of an asset's groups or materials as a list, each followed by `;`
/// (*assetNamingInfo / assetNamingInfos functions*).
pub fn asset_naming_info(env: &mut Env, file: File, what: AssetNaming) -> Text {
    let names = asset_naming_infos(env, file, what);
    list(env, names.as_slice())
}

/// The result of `imageInfo`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageDimension {
    /// Width.
    Sx,
    /// Height.
    Sy,
}

/// `imageInfo(file, sx | sy)`: the width or height in pixels of a PNG or JPEG file (*imageInfo function*). For other
/// files, 0 with a fault.
pub fn image_info(env: &mut Env, file: File, dimension: ImageDimension) -> f64 {
    let size = image_size(env, &file);
    match (size, dimension) {
        (Ok((width, _)), ImageDimension::Sx) => width.into(),
        (Ok((_, height)), ImageDimension::Sy) => height.into(),
        (Err(why), _) => unknown(env, &file, &why),
    }
}

/// The width and the height of an image, in pixels.
pub(super) fn image_size(env: &mut Env, file: &File) -> Result<(u32, u32), AssetError> {
    if let Some(known) = env.kept.image_sizes.get(file) {
        return known.clone();
    }
    let assets = &env.settings.assets;
    let size = if BUILTINS.contains(&file.name.as_str()) {
        assets.image_header(&file.name).map(|header| (header.width, header.height))
    } else {
        let read = assets.bytes(file, header::LOOKED_AT);
        read.and_then(|(bytes, _)| {
            header::size(&bytes).ok_or(AssetError::Format("only PNG and JPEG images can be read"))
        })
    };
    env.keep_image_size(file, &size);
    size
}

fn unknown(env: &mut Env, file: &File, why: &AssetError) -> f64 {
    env.asset_fault(format!("`{file}` cannot be measured: {why}; 0 is used instead"));
    0.0
}

/// `readTextFile(file)`: the contents of a text file, with line ends as `\n` and other control characters as `?`
/// (*readTextFile function*). The file is UTF-8, or UTF-16 with a byte order mark; other bytes become `U+FFFD`. If
/// the file is missing, empty text with a fault.
pub fn read_text_file(env: &mut Env, file: File) -> Text {
    match read_text(env, &file, "txt") {
        Ok(text) if env.may_write(text.len()) => Text::from(text),
        Ok(_) => Text::default(),
        Err(why) => {
            env.asset_fault(format!("`{file}` cannot be read: {why}; it gives empty text"));
            Text::default()
        }
    }
}

/// The text of a file, whose name must have the ending `end`.
pub(super) fn read_text(env: &Env, file: &File, end: &str) -> Result<String, AssetError> {
    if !file.name.rsplit_once('.').is_some_and(|(_, found)| found.eq_ignore_ascii_case(end)) {
        return Err(AssetError::Format("its name has another ending"));
    }
    let (bytes, all) = env.settings.assets.bytes(file, LONGEST_TEXT)?;
    if all { Ok(plain_text(&bytes)) } else { Err(AssetError::TooLong { most: LONGEST_TEXT }) }
}

fn plain_text(bytes: &[u8]) -> String {
    let wide = |bytes: &[u8], from: fn([u8; 2]) -> u16| {
        let (pairs, _) = bytes.as_chunks::<2>();
        String::from_utf16_lossy(&pairs.iter().map(|pair| from(*pair)).collect::<Vec<u16>>())
    };
    let text = match bytes {
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] => String::from_utf8_lossy(rest).into_owned(),
        _ => String::from_utf8_lossy(bytes).into_owned(),
    };
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    text.chars().map(|c| if c.is_control() && !matches!(c, '\n' | '\t') { '?' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::asset::Assets;
    use crate::geometry::mesh::Mesh;
    use crate::run::settings::Settings;
    use crate::shape::Shape;
    use crate::shape::scope::Scope;
    use glam::DVec3;

    fn env(assets: Assets) -> Env {
        let settings = Settings { assets: Arc::new(assets), ..Settings::default() };
        Env::with_names(&settings, &[], &Shape::rectangle(1.0, 1.0), "")
    }

    fn block() -> Mesh {
        let scope = Scope { origin: DVec3::new(0.5, 0.55, 0.6), ..Scope::new(DVec3::new(0.2, 0.3, 0.4)) };
        crate::shape::filled_scope::cuboid(&scope, crate::shape::unit::UnitMesh::cube()).to_mesh()
    }

    #[test]
    fn an_asset_is_measured() {
        // *assetInfo function*, its example.
        type D = AssetDimension;
        let env = &mut env(Assets::new().with("unitCube.obj", block()).with("nothing.obj", Mesh::default()));
        let numbers =
            [D::Sx, D::Sy, D::Sz, D::Tx, D::Ty, D::Tz].map(|what| asset_info(env, "unitCube.obj".into(), what));
        assert!(numbers.iter().zip([0.2, 0.3, 0.4, 0.5, 0.55, 0.6]).all(|(a, b)| (a - b).abs() < 1e-12));
        assert_eq!([D::Sx, D::Ty].map(|what| asset_info(env, "nothing.obj".into(), what)), [0.0, 0.0]);
        assert_eq!(env.take_faults().0.len(), 0);
        assert_eq!(asset_info(env, "missing.obj".into(), D::Sx), 0.0);
        assert_eq!(
            env.take_faults().0[0].message,
            "`missing.obj` cannot be measured: no asset folder is set (`Settings::assets`); 0 is used instead"
        );
    }

    #[test]
    fn an_asset_names_its_groups_and_materials() {
        let mut builder = crate::geometry::mesh::MeshBuilder::new();
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|p| builder.point(p));
        builder.face(
            &points,
            &[],
            crate::geometry::mesh::FaceTag { group: 1, ..crate::geometry::mesh::FaceTag::PLAIN },
        );
        builder.groups(["a", "b"].map(str::to_owned).to_vec());
        builder.materials([crate::material::Material::with(|look| look.name = Some("bark".into()))]);
        let env = &mut env(Assets::new().with("tree.obj", builder.build().expect("a triangle")));
        let info = |env: &mut Env, file: &'static str, what| asset_naming_info(env, file.into(), what).to_string();
        assert_eq!(info(env, "tree.obj", AssetNaming::Groups), "a;b;");
        assert_eq!(info(env, "tree.obj", AssetNaming::Materials), "bark;");
        assert_eq!((info(env, "none.obj", AssetNaming::Groups), env.take_faults().0.len()), (String::new(), 1));
    }

    #[test]
    fn assets_in_memory_are_found_and_drawn() {
        let mut assets = Assets::new();
        for name in ["b.obj", "a.obj", "c/a.obj", "é.png"] {
            assets = assets.with(name, block());
        }
        let (env, shape) = (&mut env(assets), &mut Shape::rectangle(1.0, 1.0));
        assert_eq!(file_search(env, "*.obj".into()).as_str(), "a.obj;b.obj;c/a.obj;");
        assert_eq!(files_search(env, "Name=a.obj".into()).as_slice(), ["a.obj", "c/a.obj"].map(Text::from));
        assert_eq!(files_search(env, "$[a-b].*".into()).len(), 2);
        assert_eq!(file_search(env, "*.dae".into()).as_str(), "");
        assert!(file_exists(env, "é.png".into()) && !file_exists(env, "e.png".into()));
        let drawn: Vec<Text> = (0..60).map(|_| file_random(env, shape, "*.obj".into())).collect();
        assert!(["a.obj", "b.obj", "c/a.obj"].iter().all(|name| drawn.iter().any(|file| file.as_str() == *name)));
        assert!(drawn.iter().all(|file| !file.is_empty()) && file_random(env, shape, "x".into()).is_empty());
        let mut other = Shape::rectangle(1.0, 1.0);
        assert_eq!(file_random(env, &mut other, "*.obj".into()), drawn[0]);
        assert_eq!(env.take_faults().0.len(), 0);
    }

    #[test]
    fn text_comes_without_marks_and_control_characters() {
        assert_eq!(plain_text(b"a\r\nb\rc\n\x07\td"), "a\nb\nc\n?\td");
        assert_eq!(plain_text(b"\xef\xbb\xbf\xc3\xa9"), "é");
        assert_eq!((plain_text(b"\xff\xfe\xe9\0x"), plain_text(b"\xfe\xff\0\xe9")), ("é".to_owned(), "é".to_owned()));
        assert_eq!(plain_text(b"\xc3("), "\u{fffd}(");
    }

    #[test]
    fn files_of_a_folder_are_read_and_others_are_not() {
        let folder = std::env::temp_dir().join(format!("cga-files-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("assets")).expect("a folder");
        std::fs::write(folder.join("assets/note.txt"), "one\r\ntwo").expect("a file");
        std::fs::write(folder.join("assets/note.doc"), "one").expect("a file");
        std::fs::write(folder.join("long.txt"), vec![b'x'; LONGEST_TEXT as usize + 1]).expect("a file");
        let png = [b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR".as_slice(), &[0, 0, 0, 7, 0, 0, 0, 9]].concat();
        std::fs::write(folder.join("a.png"), png).expect("a file");
        let env = &mut env(Assets::below(&folder));
        assert_eq!(read_text_file(env, "note.txt".into()).as_str(), "one\ntwo");
        let small = &mut self::env(Assets::below(&folder));
        small.settings.limits.text = 6;
        assert!(read_text_file(small, "note.txt".into()).is_empty() && small.ended());
        let size = [ImageDimension::Sx, ImageDimension::Sy].map(|what| image_info(env, "a.png".into(), what));
        assert_eq!(size, [7.0, 9.0]);
        assert!(file_exists(env, "note.txt".into()) && file_exists(env, "assets/note.txt".into()));
        assert_eq!(env.take_faults().0.len(), 0);
        for file in ["note.doc", "none.txt", "long.txt", "../note.txt", "assets"] {
            assert_eq!(read_text_file(env, file.into()).as_str(), "");
        }
        assert!(
            ["note.doc", "assets", "", "../a.png", "none.txt"].iter().all(|file| !file_exists(env, (*file).into()))
        );
        assert_eq!(image_info(env, "note.txt".into(), ImageDimension::Sx), 0.0);
        assert_eq!(env.take_faults().0.len(), 6);
        let _ = std::fs::remove_dir_all(&folder);
    }
}
