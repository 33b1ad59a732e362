//! A reader for Wavefront OBJ files with their material libraries.
//!
//! The geometry and the names of materials are read by [`geometry::obj`](crate::geometry::obj), the libraries by `tobj` (*insert
//! operation*: a mesh with inconsistent texture coordinates or normals drops them all).

mod mtl;

use std::collections::HashMap;

use crate::geometry::mesh::Mesh;
use crate::geometry::obj::{self, UTF_16, Warnings, is_utf16, short};
use crate::material::Material;
use crate::value::text::Text;

pub use crate::geometry::obj::ObjError;

/// A mesh and the warnings from reading it.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjFile {
    /// The mesh.
    pub mesh: Mesh,
    /// One sentence per problem, at most 100. If there are more, the last sentence gives the number of the others.
    pub warnings: Vec<String>,
}

/// Reads a file. `material_file` returns the bytes of a material library by its name, or `None` if it does not exist.
/// It is called for the first 16 libraries of a file, and for the first 16 names with spaces, which may be one library
/// or several.
///
/// # Errors
/// An error with its line if a number is invalid or not finite, or if a face uses a vertex that does not exist. Also an
/// error if the file is UTF-16 instead of UTF-8.
pub fn read_obj(bytes: &[u8], material_file: &mut dyn FnMut(&str) -> Option<Vec<u8>>) -> Result<ObjFile, ObjError> {
    let text = obj::read(bytes)?;
    let mut libraries = Libraries {
        material_file,
        looks: HashMap::new(),
        known: HashMap::new(),
        looked_up: [0; 2],
        left_out: 0,
        warnings: text.warnings,
    };
    text.libraries.iter().for_each(|names| libraries.names(names));
    let materials = text.mesh.materials::<String>().iter().map(|name| libraries.material(name)).collect::<Vec<_>>();
    let mesh = text.mesh.with_materials(materials, |number| number);
    Ok(ObjFile { mesh, warnings: libraries.finish() })
}

/// The first material of a library, with its name. The error is a sentence.
pub(crate) fn first_material(bytes: &[u8]) -> Result<Material, String> {
    if is_utf16(bytes) {
        return Err(UTF_16.to_owned());
    }
    let library = mtl::read_mtl(bytes).map_err(|error| error.to_string())?;
    let (name, material) = library.materials.into_iter().next().ok_or("it has no material")?;
    Ok(Material { name: Some(Text::from(name)), ..material })
}

/// The limit on libraries that are looked up for a file, and on names with spaces.
const LIBRARIES: usize = 16;

/// The material libraries of a file.
struct Libraries<'a> {
    material_file: &'a mut dyn FnMut(&str) -> Option<Vec<u8>>,
    looks: HashMap<String, Material>,
    /// Names of libraries that were looked up, and whether each exists.
    known: HashMap<String, bool>,
    /// The numbers of look-ups of names without spaces and with spaces.
    looked_up: [usize; 2],
    /// The number of names of libraries that were not looked up.
    left_out: usize,
    warnings: Warnings,
}

impl Libraries<'_> {
    fn names(&mut self, rest: &str) {
        for names in rest.split('\t').map(str::trim).filter(|names| !names.is_empty()) {
            // Either one name with spaces or several names, depending on which exists.
            if !self.library(names) && names.contains(' ') {
                for name in names.split(' ').filter(|name| !name.is_empty()) {
                    self.library(name);
                }
            }
        }
    }

    /// Reads a library when it is named for the first time. Returns whether it exists.
    fn library(&mut self, name: &str) -> bool {
        if let Some(&there) = self.known.get(name) {
            return there;
        }
        let may_be_several = name.contains(' ');
        let looked_up = &mut self.looked_up[usize::from(may_be_several)];
        if *looked_up == LIBRARIES {
            self.left_out += usize::from(!may_be_several);
            return false;
        }
        *looked_up += 1;
        let bytes = (self.material_file)(name);
        self.known.insert(name.to_owned(), bytes.is_some());
        let Some(bytes) = bytes else {
            if !may_be_several {
                self.warnings.add(|| format!("the material library `{}` was not found", short(name)));
            }
            return false;
        };
        if is_utf16(&bytes) {
            self.warnings.add(|| format!("the material library `{}` can't be read: {UTF_16}", short(name)));
            return true;
        }
        match mtl::read_mtl(&bytes) {
            Ok(mtl::MaterialLibrary { materials, left_out }) => {
                if let Some((first, more)) = left_out {
                    self.warnings.add(|| {
                        let what = format!("line {first} of the material library `{}` can't be read", short(name));
                        if more == 0 { what } else { format!("{what}, and {more} more") }
                    });
                }
                for (name, look) in materials {
                    self.looks.entry(name).or_insert(look);
                }
            }
            Err(error) => {
                self.warnings.add(|| format!("the material library `{}` can't be read: {error}", short(name)));
            }
        }
        true
    }

    /// The material with a name.
    fn material(&mut self, name: &str) -> Material {
        let mut material = self.looks.get(name).cloned().unwrap_or_else(|| {
            if !self.known.is_empty() {
                self.warnings.add(|| format!("the material `{}` is in no library", short(name)));
            }
            Material::UNSET
        });
        material.name = Some(Text::from(name));
        material
    }

    /// The warnings.
    fn finish(mut self) -> Vec<String> {
        if self.left_out != 0 {
            let more = self.left_out;
            self.warnings.add(|| {
                format!("the file names more than {LIBRARIES} material libraries: {more} more names were not looked up")
            });
        }
        self.warnings.finish()
    }
}

#[cfg(test)]
mod tests;
