//! The reader of OBJ text.

use glam::{DVec2, DVec3};

use super::lines::{UTF_16, is_utf16, lines};
use super::names::Names;
use super::warnings::{Warnings, short};
use super::{ObjError, ObjText};
use crate::mesh::{FaceTag, MeshBuilder};

/// Reads a file in time and memory linear in its bytes.
///
/// # Errors
/// An error with its line if a number is invalid or not finite, or if a face uses a vertex that does not exist. Also an
/// error if the file is UTF-16 instead of UTF-8.
pub fn read(bytes: &[u8]) -> Result<ObjText, ObjError> {
    if is_utf16(bytes) {
        return Err(ObjError::Line { line: 1, what: UTF_16 });
    }
    let text = String::from_utf8_lossy(bytes);
    let mut reader = Reader::default();
    let mut joined = String::new();
    let mut joined_from = 0;
    for (number, line) in lines(&text) {
        if joined.is_empty() {
            joined_from = number;
        }
        if let Some(start) = line.strip_suffix('\\') {
            joined.push_str(start);
            joined.push(' ');
        } else if joined.is_empty() {
            reader.statement(line, number)?;
        } else {
            joined.push_str(line);
            let whole = std::mem::take(&mut joined);
            reader.statement(&whole, joined_from)?;
        }
    }
    reader.statement(&joined, joined_from)?;
    reader.finish()
}

/// The statements that are read.
const READ: [&str; 8] = ["v", "vt", "vn", "f", "g", "o", "usemtl", "mtllib"];

/// The statements that are skipped without a warning: they describe other things than polygons, or rendering.
const LEFT_OUT: &str = "l p s vp mg cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con bevel c_interp \
    d_interp lod shadow_obj trace_obj ctech stech maplib usemap call csh bsp bzp cdc cdp res fo s_interp";

/// A corner of a face: indices into the three lists, from 0.
#[derive(Clone, Copy)]
struct FaceCorner {
    point: u32,
    uv: Option<u32>,
    normal: Option<u32>,
}

#[derive(Default)]
struct Reader {
    builder: MeshBuilder,
    point_count: usize,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
    tag: FaceTag,
    groups: Names,
    materials: Names,
    /// The texts behind `mtllib`.
    libraries: Names,
    corners: Vec<FaceCorner>,
    uvs_on: Coverage,
    normals_on: Coverage,
    faces: usize,
    /// The first unknown statement, and the number of unknown statements.
    unknown: Option<(usize, String)>,
    unknowns: usize,
    warnings: Warnings,
}

/// The numbers of faces with a value at some corner, and with one at every corner.
#[derive(Default)]
struct Coverage {
    some: usize,
    all: usize,
}

impl Coverage {
    /// Counts a face. Returns the values of its corners if all corners have one.
    fn add<T>(&mut self, of_corners: impl Iterator<Item = Option<T>> + Clone) -> Option<Vec<T>> {
        self.some += usize::from(of_corners.clone().any(|value| value.is_some()));
        let all: Option<Vec<T>> = of_corners.collect();
        self.all += usize::from(all.is_some());
        all
    }
}

impl Reader {
    fn statement(&mut self, line: &str, number: usize) -> Result<(), ObjError> {
        let line = line.trim_start();
        let (keyword, rest) = line.split_once(|c: char| c.is_ascii_whitespace()).unwrap_or((line, ""));
        let rest = rest.trim();
        let is_keyword = |known: &&str| known.eq_ignore_ascii_case(keyword);
        match READ.into_iter().find(is_keyword).unwrap_or_default() {
            "v" => {
                let [x, y, z] = numbers::<3>(rest, 3, number)?;
                self.builder.point([x, y, z]);
                self.point_count += 1;
            }
            "vt" => {
                let [u, v] = numbers::<2>(rest, 1, number)?;
                self.uvs.push(DVec2::new(u, v));
            }
            "vn" => self.normals.push(DVec3::from(numbers::<3>(rest, 3, number)?)),
            "f" => self.face(rest, number)?,
            "g" | "o" => {
                self.tag.group = if rest.is_empty() { FaceTag::NONE } else { self.groups.number(rest) };
            }
            "usemtl" => {
                self.tag.material = if rest.is_empty() { FaceTag::NONE } else { self.materials.number(rest) };
            }
            "mtllib" => {
                self.libraries.number(rest);
            }
            _ if keyword.is_empty() || LEFT_OUT.split(' ').any(|known| is_keyword(&known)) => {}
            _ => {
                self.unknowns += 1;
                self.unknown.get_or_insert_with(|| (number, short(keyword)));
            }
        }
        Ok(())
    }

    fn face(&mut self, rest: &str, line: usize) -> Result<(), ObjError> {
        self.corners.clear();
        for token in rest.split_ascii_whitespace() {
            let mut parts = token.split('/');
            let point = index(parts.next(), self.point_count, line, "a face uses a vertex that does not exist")?
                .ok_or(ObjError::Line { line, what: "a corner of a face has no vertex" })?;
            let uv = index(parts.next(), self.uvs.len(), line, "a face uses a texture vertex that does not exist")?;
            let normal = index(parts.next(), self.normals.len(), line, "a face uses a normal that does not exist")?;
            self.corners.push(FaceCorner { point, uv, normal });
        }
        if self.corners.len() < 3 {
            self.warnings.add(|| format!("line {line}: a face with fewer than three corners was left out"));
            return Ok(());
        }
        let outline: Vec<u32> = self.corners.iter().map(|c| c.point).collect();
        self.builder.face(&outline, &[], self.tag);
        self.faces += 1;
        if let Some(uvs) = self.uvs_on.add(self.corners.iter().map(|c| c.uv.map(|i| self.uvs[i as usize]))) {
            self.builder.uvs(&uvs);
        }
        let normals = self.corners.iter().map(|c| c.normal.map(|i| self.normals[i as usize]));
        if let Some(normals) = self.normals_on.add(normals) {
            self.builder.normals(&normals);
        }
        Ok(())
    }

    fn finish(mut self) -> Result<ObjText, ObjError> {
        for (what, on) in [("texture coordinates", &self.uvs_on), ("normals", &self.normals_on)] {
            if on.some != 0 && on.all != self.faces {
                let (all, faces) = (on.all, self.faces);
                self.warnings
                    .add(|| format!("only {all} of {faces} faces have {what} at every corner: all were dropped"));
            }
        }
        if let Some((line, word)) = &self.unknown {
            let more = self.unknowns - 1;
            self.warnings.add(|| {
                let what = format!("line {line}: `{word}` is not a statement of an OBJ file");
                if more == 0 { what } else { format!("{what}, and {more} more") }
            });
        }
        if self.faces == 0 {
            self.warnings.add(|| "the file has no faces".to_owned());
        }
        self.builder.groups(self.groups.into_list()).materials(self.materials.into_list());
        let mesh = self.builder.build().map_err(ObjError::Mesh)?;
        let lost = self.faces - mesh.face_count();
        if lost != 0 {
            self.warnings.add(|| format!("{lost} faces without three different corners were left out"));
        }
        Ok(ObjText { mesh, libraries: self.libraries.into_list(), warnings: self.warnings })
    }
}

/// Parses up to `N` numbers, of which `least` are required.
fn numbers<const N: usize>(rest: &str, least: usize, line: usize) -> Result<[f64; N], ObjError> {
    let mut values = [0.0f64; N];
    let mut tokens = rest.split_ascii_whitespace();
    for (i, value) in values.iter_mut().enumerate() {
        let Some(token) = tokens.next() else {
            if i < least {
                return Err(ObjError::Line { line, what: "too few numbers" });
            }
            break;
        };
        *value = token.parse().map_err(|_| ObjError::Line { line, what: "this is not a number" })?;
        if !value.is_finite() {
            return Err(ObjError::Line { line, what: "a number is not finite" });
        }
    }
    Ok(values)
}

/// An index counted from 1, or from the end if negative.
fn index(token: Option<&str>, count: usize, line: usize, what: &'static str) -> Result<Option<u32>, ObjError> {
    let Some(token) = token.filter(|token| !token.is_empty()) else {
        return Ok(None);
    };
    let value: i64 = token.parse().map_err(|_| ObjError::Line { line, what: "this is not an index" })?;
    let index = if value > 0 { value - 1 } else { value.saturating_add(count as i64) };
    if value == 0 || index < 0 || index >= count as i64 {
        return Err(ObjError::Line { line, what });
    }
    Ok(Some(index as u32))
}
