//! OBJ and MTL text.
//!
//! Polygons stay polygons. Faces with holes become triangles, as the format has no holes. Each building, which is an initial shape, is an
//! object (`o`) with its name. Consecutive leaves of a building with one rule and one material share a `g` and a `usemtl`. Coordinates are in the world, with all digits needed to read the
//! same values back. Colours are written unchanged, in sRGB.
//!
//! A corner has one pair of texture coordinates in this format: of set 0, or of the first set of a mesh. The library
//! refers to images by the paths in the rules, relative to the asset folder, with scale and offset (`-s`, `-o`). It
//! cannot express rotation (`rw`) and other sets. Built-in textures are written as files beside the library.

mod mtl;

use std::collections::{BTreeSet, HashMap, HashSet};
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::ops::{ControlFlow, Range};
use std::path::Path;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::error::WriteError;
use super::flatten::{Flattener, unit};
use super::leaf_numbers::Numbers;
use super::number_text::{NumberTexts, hex, push_whole};
use super::whole_file::{self, WholeFile};
use crate::geometry::mesh::Mesh;
use crate::geometry::mesh::map::normal_map;
use crate::geometry::obj::line_name;
use crate::material::Material;
use crate::output::batches::Batches;
use crate::output::model::Model;
use crate::run::building::Building;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink, cuboid_mesh, quad_mesh};
use crate::value::text::Text;

/// The size of text, in bytes, from which it is written out.
const MUCH: usize = 1 << 15;

/// Writes leaves as they come, in constant memory. Materials are kept until the end.
#[derive(Debug)]
pub struct Obj<W> {
    out: W,
    /// Text for `out`, written in larger pieces.
    text: Vec<u8>,
    texts: NumberTexts,
    numbers: Numbers,
    names: GroupNames,
    /// The rule and the material written last.
    run: Option<(u32, u32)>,
    /// The number of buildings so far.
    buildings: usize,
    /// True after a building: the next leaves are outside of it.
    has_ended: bool,
    points: u64,
    uvs: u64,
    normals: u64,
    failed: Option<io::Error>,
    flattener: Flattener,
}

impl<W: Write> Obj<W> {
    /// Starts a file with the material library `library`, a file name. `_` takes the place of characters that would end the name: control
    /// characters, `#` and space except between words.
    pub fn new(mut out: W, library: &str) -> Self {
        // Smoothing off: faces without normals are flat.
        let failed = write!(out, "mtllib {}\ns off\n", line_name(library)).err();
        Obj {
            out,
            text: Vec::new(),
            texts: NumberTexts::default(),
            numbers: Numbers::default(),
            names: GroupNames::default(),
            run: None,
            buildings: 0,
            has_ended: false,
            points: 0,
            uvs: 0,
            normals: 0,
            failed,
            flattener: Flattener::default(),
        }
    }

    /// Ends the file and returns the text of the material library.
    ///
    /// # Errors
    /// The first error of `out`.
    pub fn finish(mut self) -> Result<String, WriteError> {
        let _ = self.hand_over();
        if let Some(error) = self.failed.take() {
            return Err(error.into());
        }
        self.out.flush()?;
        let mut library = String::new();
        for (material, name) in self.numbers.table.materials().iter().zip(&self.names.list) {
            // Some materials only served to make others.
            if let Some(name) = name {
                mtl::write(&mut library, name, material);
            }
        }
        Ok(library)
    }

    /// Starts a group unless the last one continues.
    fn run(&mut self, rule: u32, material: u32) {
        if self.run == Some((rule, material)) {
            return;
        }
        self.run = Some((rule, material));
        if std::mem::take(&mut self.has_ended) {
            self.text.extend_from_slice(b"o rest\n");
        }
        let group = self.numbers.table.rules()[rule as usize].as_str();
        let name = self.names.of(material, &self.numbers.table.materials()[material as usize]);
        for text in ["g ", group, "\nusemtl ", name, "\n"] {
            self.text.extend_from_slice(text.as_bytes());
        }
    }

    fn point(&mut self, p: DVec3) {
        self.line("v", &p.to_array());
        self.points += 1;
    }

    /// Writes a line of a key and numbers.
    fn line(&mut self, key: &str, numbers: &[f64]) {
        self.text.extend_from_slice(key.as_bytes());
        for &number in numbers {
            self.text.push(b' ');
            self.texts.push(&mut self.text, number);
        }
        self.text.push(b'\n');
    }

    fn polygon(&mut self, corners: impl IntoIterator<Item = u64>) {
        self.text.push(b'f');
        for corner in corners {
            self.text.push(b' ');
            push_whole(&mut self.text, corner);
        }
        self.text.push(b'\n');
    }

    /// Writes the collected text out once there is enough.
    fn flush(&mut self) -> Flow {
        if self.text.len() < MUCH && self.failed.is_none() { ControlFlow::Continue(()) } else { self.hand_over() }
    }

    fn hand_over(&mut self) -> Flow {
        if self.failed.is_none() {
            self.failed = self.out.write_all(&self.text).err();
        }
        self.text.clear();
        if self.failed.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl<W: Write> Sink for Obj<W> {
    fn begin_building(&mut self, name: &str, _: u64) {
        let name = match name {
            "" => format!("building_{}", self.buildings),
            name => line_name(name),
        };
        self.buildings += 1;
        self.has_ended = false;
        for text in ["o ", &name, "\n"] {
            self.text.extend_from_slice(text.as_bytes());
        }
        self.run = None;
    }

    fn end_building(&mut self, _: &dyn Fn() -> Building) {
        (self.has_ended, self.run) = (true, None);
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        if !leaf.uvs().is_empty() {
            return self.mesh(leaf, &quad_mesh(leaf, quad), &DAffine3::IDENTITY);
        }
        let (rule, material) = self.numbers.leaf(leaf);
        self.run(rule, material);
        let start = self.points;
        quad.points().into_iter().for_each(|point| self.point(point));
        self.polygon(quad.unit.mesh().corners().iter().map(|&corner| start + 1 + u64::from(corner)));
        self.flush()
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        if !leaf.uvs().is_empty() {
            return self.mesh(leaf, &cuboid_mesh(leaf, cuboid), &DAffine3::IDENTITY);
        }
        let (rule, material) = self.numbers.leaf(leaf);
        self.run(rule, material);
        let start = self.points;
        let (corners, unit) = (cuboid.corners(), cuboid.unit);
        unit.numbers().for_each(|number| self.point(corners[usize::from(number)]));
        for face in unit.mesh().faces() {
            self.polygon(face.outer().iter().map(|&corner| start + 1 + u64::from(corner)));
        }
        self.flush()
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let (rule, material) = self.numbers.leaf(leaf);
        let turn = normal_map(&placement.matrix3);
        let (points, uvs, normals) = (self.points + 1, self.uvs + 1, self.normals + 1);
        mesh.points().iter().for_each(|&point| self.point(placement.transform_point3(point)));
        let coordinates = mesh.uv_numbers().next().map_or(&[][..], |set| mesh.uv_set(set));
        for uv in coordinates {
            self.line("vt", &uv.to_array());
        }
        for &normal in mesh.normals() {
            self.line("vn", &unit(turn * normal).to_array());
        }
        self.uvs += coordinates.len() as u64;
        self.normals += mesh.normals().len() as u64;
        let corner = |text: &mut Vec<u8>, corner: usize| {
            text.push(b' ');
            push_whole(text, points + u64::from(mesh.corners()[corner]));
            if !coordinates.is_empty() {
                text.push(b'/');
                push_whole(text, uvs + corner as u64);
            }
            if !mesh.normals().is_empty() {
                text.extend_from_slice(if coordinates.is_empty() { b"//" } else { b"/" });
                push_whole(text, normals + corner as u64);
            }
        };
        let mut flattener = std::mem::take(&mut self.flattener);
        flattener.faces(mesh, placement, |face| {
            let shown = face.material(&mut self.numbers.table, material);
            self.run(rule, shown);
            let polygon = mesh.face(face.index);
            if polygon.holes().len() == 0 && !polygon.is_bent() {
                self.text.push(b'f');
                face.corners.clone().for_each(|c| corner(&mut self.text, c));
                self.text.push(b'\n');
                return true;
            }
            for triangle in face.triangles {
                self.text.push(b'f');
                triangle.iter().for_each(|&i| corner(&mut self.text, face.corners.start + i as usize));
                self.text.push(b'\n');
            }
            true
        });
        self.flattener = flattener;
        self.flush()
    }
}

/// The names of materials: unique, and valid in the format.
#[derive(Debug, Default)]
struct GroupNames {
    list: Vec<Option<String>>,
    taken: HashSet<String>,
    /// A range of numbers for each repeated name: the name is taken with all of them.
    numbers: HashMap<String, Range<usize>>,
}

impl GroupNames {
    fn of(&mut self, id: u32, material: &Material) -> &str {
        let id = id as usize;
        if self.list.len() <= id {
            self.list.resize(id + 1, None);
        }
        let GroupNames { list, taken, numbers } = self;
        list[id].get_or_insert_with(|| {
            let mut name = plain_name(material);
            if taken.contains(&name) {
                // The number makes it unique unless another material has that name.
                let full = numbers.entry(name.clone()).or_insert(id..id);
                if !full.contains(&id) {
                    *full = id..id;
                }
                while taken.contains(&format!("{name}_{}", full.end)) {
                    full.end += 1;
                }
                name = format!("{name}_{}", full.end);
                full.end += 1;
            }
            taken.insert(name.clone());
            name
        })
    }
}

/// The material's own name without spaces and special characters, or a name after its colour.
fn plain_name(material: &Material) -> String {
    let allowed = |c: char| if c.is_alphanumeric() || "_.-".contains(c) { c } else { '_' };
    let name: String = material.name.as_ref().map_or("", |name| name.as_str()).chars().map(allowed).collect();
    if !name.is_empty() {
        return name;
    }
    format!("color_{}", hex(&material.color()))
}

/// The most characters of a changed name that are kept: a file system takes at least 255 bytes.
const MOST_KEPT: usize = 50;

/// The file name of the library beside an OBJ file. A name that cannot be in a `mtllib` line is changed and gets a hash of
/// the original one, so that OBJ files in one folder have different libraries.
fn library_beside(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    let name = line_name(&stem.to_string_lossy());
    if stem == name.as_str() {
        return format!("{name}.mtl");
    }
    // FNV-1a.
    let hash = |hash: u32, byte: &u8| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
    let hash = stem.as_encoded_bytes().iter().fold(0x811c_9dc5, hash);
    let kept: String = name.chars().take(MOST_KEPT).collect();
    format!("{kept}_{hash:08x}.mtl")
}

impl Model {
    /// The model as OBJ text that refers to `library`, and the text of that library.
    pub fn to_obj(&self, library: &str) -> (String, String) {
        to_text(library, |obj| self.replay(obj))
    }

    /// Writes an OBJ file, and beside it its materials in a file with the ending `.mtl`. In that file's name, `_` takes the place of `#` and
    /// other characters that OBJ files cannot name, and a hash of the name follows: `a#.obj` has the library `a__0e24a29d.mtl`. Several files
    /// need a folder; [`Obj`] writes the text alone to any writer.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn write_obj(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        to_files(path.as_ref(), |obj| self.replay(obj))
    }
}

impl Batches<Model> {
    /// All models as one OBJ text that refers to `library`, and the text of that library.
    pub fn to_obj(&self, library: &str) -> (String, String) {
        to_text(library, |obj| self.replay(obj))
    }

    /// Writes all models as one OBJ file, and beside it their materials in a file with the ending `.mtl`.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn write_obj(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        to_files(path.as_ref(), |obj| self.replay(obj))
    }
}

fn to_text(library: &str, replay: impl FnOnce(&mut Obj<&mut Vec<u8>>) -> Flow) -> (String, String) {
    let mut bytes = Vec::new();
    let mut obj = Obj::new(&mut bytes, library);
    let _ = replay(&mut obj);
    // Writing to memory does not fail, and all that was written is UTF-8.
    let materials = obj.finish().unwrap_or_default();
    (String::from_utf8(bytes).unwrap_or_default(), materials)
}

/// Writes the images, then the library, then the file that refers to both.
fn to_files(path: &Path, replay: impl FnOnce(&mut Obj<BufWriter<&File>>) -> Flow) -> Result<(), WriteError> {
    let name = library_beside(path);
    let library = path.with_file_name(&name);
    let whole = WholeFile::create(path)?;
    let mut obj = Obj::new(BufWriter::new(whole.file()), &name);
    let _ = replay(&mut obj);
    let images = mtl::builtins(obj.numbers.table.materials());
    let materials = obj.finish().map_err(|error| whole_file::named(path, error))?;
    write_images(path, &images)?;
    whole_file::write(&library, materials.as_bytes())?;
    whole.finish()
}

/// Writes built-in textures beside an OBJ file.
#[cfg(feature = "png")]
fn write_images(path: &Path, names: &BTreeSet<Text>) -> Result<(), WriteError> {
    names.iter().try_for_each(|name| match crate::asset::image::builtin::image(name) {
        Some(image) => image.write_png(path.with_file_name(mtl::file_name(name))),
        None => Ok(()),
    })
}

#[cfg(not(feature = "png"))]
fn write_images(_: &Path, _: &BTreeSet<Text>) -> Result<(), WriteError> {
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The smallest free number from the material's own number on.
    fn expected(taken: &mut HashSet<String>, id: u32, plain: &str) -> String {
        let mut names = std::iter::once(plain.to_owned()).chain((id..).map(|number| format!("{plain}_{number}")));
        let name = names.find(|name| !taken.contains(name)).expect("a free name");
        taken.insert(name.clone());
        name
    }

    #[test]
    fn materials_with_one_name_get_the_next_free_numbers() {
        let (mut names, mut taken, mut state) = (GroupNames::default(), HashSet::new(), 1u32);
        let mut below = |count: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) % count
        };
        let mut ids: Vec<u32> = (0..400).collect();
        (0..400).for_each(|at| ids.swap(at, below(400) as usize));
        ids[..200].sort_unstable();
        for id in ids {
            let plain = match below(3) {
                0 => "m".to_owned(),
                1 => format!("m_{}", below(400)),
                _ => format!("m_{}_{}", below(4), below(400)),
            };
            let material = Material { name: Some(Text::from(plain.as_str())), ..Material::default() };
            assert_eq!(names.of(id, &material), expected(&mut taken, id, &plain));
        }
    }
}
