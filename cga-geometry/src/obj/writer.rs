//! The writer of OBJ text.

use std::io::{self, BufWriter, Write};

use glam::DVec3;

use crate::mesh::{FaceTag, Mesh};
use crate::triangulate::Triangulator;

/// Writes a mesh. Faces stay polygons; faces with holes and bent faces become triangles, as the format has neither. Groups
/// are written, and materials if they are names (`String`). A corner has the texture coordinates of the first set. All digits are
/// written that are needed to read the same values back.
///
/// # Errors
/// The errors of `out`.
pub fn write(mesh: &Mesh, out: impl Write) -> io::Result<()> {
    let mut writer = Writer { out: BufWriter::new(out), counts: [1; 3] };
    writer.mesh(mesh)?;
    writer.out.flush()
}

/// Writes several meshes as objects (`o`) with names, each as [`write()`] does.
///
/// # Errors
/// The errors of `out`.
pub fn write_objects<'m>(
    objects: impl IntoIterator<Item = (impl AsRef<str>, &'m Mesh)>,
    out: impl Write,
) -> io::Result<()> {
    let mut writer = Writer { out: BufWriter::new(out), counts: [1; 3] };
    for (name, mesh) in objects {
        writeln!(writer.out, "o {}", line_name(name.as_ref()))?;
        writer.mesh(mesh)?;
    }
    writer.out.flush()
}

/// A name without characters that would end it in a line such as `mtllib`. Spaces between words stay.
pub fn line_name(name: &str) -> String {
    let words = name.trim_start_matches(' ');
    let ends = |c: char| c == '#' || c.is_control() || (c.is_whitespace() && c != ' ');
    let kept = words.chars().map(|c| if ends(c) { '_' } else { c });
    std::iter::repeat_n('_', name.len() - words.len()).chain(kept).collect()
}

struct Writer<W: Write> {
    out: BufWriter<W>,
    /// The numbers of the next point, texture vertex and normal, from 1.
    counts: [usize; 3],
}

impl<W: Write> Writer<W> {
    fn mesh(&mut self, mesh: &Mesh) -> io::Result<()> {
        let uvs = mesh.uv_numbers().next().map_or(&[][..], |set| mesh.uv_set(set));
        for DVec3 { x, y, z } in mesh.points() {
            writeln!(self.out, "v {x} {y} {z}")?;
        }
        for uv in uvs {
            writeln!(self.out, "vt {} {}", uv.x, uv.y)?;
        }
        for DVec3 { x, y, z } in mesh.normals() {
            writeln!(self.out, "vn {x} {y} {z}")?;
        }
        let (mut tag, mut triangulator, mut triangles) = (FaceTag::PLAIN, Triangulator::new(), Vec::new());
        for face in mesh.faces() {
            self.tag(mesh, &mut tag, face.tag())?;
            if face.holes().len() == 0 && !face.is_bent() {
                self.polygon(mesh, uvs.len(), face.corner_range())?;
                continue;
            }
            triangles.clear();
            triangulator.face(mesh, face.index(), &mut triangles);
            for triangle in &triangles {
                self.polygon(mesh, uvs.len(), triangle.iter().map(|corner| *corner as usize))?;
            }
        }
        let added = [mesh.points().len(), uvs.len(), mesh.normals().len()];
        self.counts.iter_mut().zip(added).for_each(|(count, added)| *count += added);
        Ok(())
    }

    /// Writes the group and the material of a face where they differ from the last ones. A name is never empty: a statement without
    /// a name ends a group.
    fn tag(&mut self, mesh: &Mesh, last: &mut FaceTag, tag: FaceTag) -> io::Result<()> {
        let materials = mesh.materials::<String>();
        let lists = [
            ("g", mesh.groups(), std::mem::replace(&mut last.group, tag.group), tag.group),
            ("usemtl", materials, std::mem::replace(&mut last.material, tag.material), tag.material),
        ];
        for (keyword, names, last, now) in lists {
            if last != now && !names.is_empty() {
                match names.get(now as usize) {
                    Some(name) => writeln!(self.out, "{keyword} {}", line_name(name))?,
                    None => writeln!(self.out, "{keyword}")?,
                }
            }
        }
        Ok(())
    }

    fn polygon(&mut self, mesh: &Mesh, uvs: usize, corners: impl Iterator<Item = usize>) -> io::Result<()> {
        let [points, first_uv, first_normal] = self.counts;
        write!(self.out, "f")?;
        for corner in corners {
            write!(self.out, " {}", points + mesh.corners()[corner] as usize)?;
            match (uvs != 0, !mesh.normals().is_empty()) {
                (false, false) => Ok(()),
                (true, false) => write!(self.out, "/{}", first_uv + corner),
                (false, true) => write!(self.out, "//{}", first_normal + corner),
                (true, true) => write!(self.out, "/{}/{}", first_uv + corner, first_normal + corner),
            }?;
        }
        writeln!(self.out)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::mesh::MeshBuilder;
    use crate::obj::read;
    use crate::primitive;

    fn text(mesh: &Mesh) -> String {
        let mut bytes = Vec::new();
        write(mesh, &mut bytes).expect("memory takes it");
        String::from_utf8(bytes).expect("text")
    }

    fn framed() -> Mesh {
        let mut builder = MeshBuilder::new();
        let ring = |low: f64, high: f64| [[low, 0.0, low], [low, 0.0, high], [high, 0.0, high], [high, 0.0, low]];
        let outline = ring(0.0, 3.0).map(|p| builder.point(p));
        let mut hole = ring(1.0, 2.0).map(|p| builder.point(p));
        hole.reverse();
        builder.face(&outline, &[&hole], FaceTag::PLAIN);
        builder.build().expect("a frame")
    }

    #[test]
    fn what_is_written_is_read_back() {
        let mut builder = MeshBuilder::new();
        let points = [[0.1, 0.0, 0.0], [1.0 / 3.0, 1e-9, 0.0], [1e9, -1.0, 2.5], [0.0, 7.0, 1.0]];
        let points = points.map(|point| builder.point(point));
        builder.groups(["a wall".to_owned(), "roof".to_owned()]).materials(["brick".to_owned()]);
        for (face, group, material) in [([0, 1, 2], 0, 0), ([0, 2, 3], 0, FaceTag::NONE), ([1, 3, 2], 1, 0)] {
            let tag = FaceTag { group, material, ..FaceTag::PLAIN };
            builder.face(&face.map(|k: usize| points[k]), &[], tag);
            builder.uvs(&[DVec2::ZERO, DVec2::X, DVec2::new(0.1, 0.7)]).normals(&[DVec3::Y, DVec3::Z, DVec3::X]);
        }
        let mesh = builder.build().expect("faces");
        assert_eq!(read(text(&mesh).as_bytes()).expect("it is valid").mesh, mesh);
    }

    #[test]
    fn holes_become_triangles() {
        let read = read(text(&framed()).as_bytes()).expect("it is valid").mesh;
        assert_eq!((read.face_count(), read.area()), (8, 8.0));
    }

    #[test]
    fn names_that_would_end_a_line_are_changed() {
        let cube = primitive::cube();
        let mut bytes = Vec::new();
        write_objects([("a\n# b", &cube), (" c", &cube)], &mut bytes).expect("memory takes it");
        let file = read(&bytes).expect("it is valid");
        assert_eq!(file.mesh.groups(), ["a__ b", "_c"]);
        // Both cubes are at one place, so they share points.
        assert_eq!((file.mesh.face_count(), file.mesh.points().len(), file.warnings.finish().len()), (12, 8, 0));
    }
}
