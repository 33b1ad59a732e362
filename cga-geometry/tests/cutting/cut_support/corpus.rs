//! Cases for the cutter as text. Cases that once failed are kept in `tests/corpus/cut.txt`, and failing cases are
//! printed in the same form.

use std::fmt::{self, Write as _};
use std::sync::Arc;

use cga_geometry::Axis;
use cga_geometry::mesh::{FaceTag, Flaw, Mesh, MeshBuilder};
use glam::DVec3;

use super::{AXES, check_closed_cut, closed_by_position};
use cga_geometry::cut::slabs;

/// A mesh with its cuts.
#[derive(Clone, Debug, Default)]
pub struct Case {
    pub name: String,
    pub quality: Quality,
    pub axis: usize,
    pub planes: Vec<f64>,
    pub points: Vec<[f64; 3]>,
    /// The loops of a face as corners: the outline, then holes.
    pub faces: Vec<Vec<Vec<u32>>>,
}

/// The known quality of a mesh, which determines its laws.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Quality {
    /// Nothing is known.
    #[default]
    Any,
    /// No face crosses itself: volumes and areas add up.
    Simple,
    /// No face crosses itself or another face: every law holds.
    Clean,
}

impl Case {
    pub fn of(name: &str, quality: Quality, mesh: &Mesh, axis: usize, planes: &[f64]) -> Case {
        let faces = mesh.faces().map(|face| face.loops().map(<[u32]>::to_vec).collect()).collect();
        let points = mesh.points().iter().map(|point| point.to_array()).collect();
        Case { name: name.into(), quality, axis, planes: planes.to_vec(), points, faces }
    }

    /// All cases of a file.
    pub fn read(text: &str) -> Vec<Case> {
        let mut list: Vec<Case> = Vec::new();
        for (number, line) in text.lines().enumerate() {
            let mut words = line.split_whitespace();
            let Some(word) = words.next().filter(|word| !word.starts_with('#')) else { continue };
            let rest: Vec<&str> = words.collect();
            let numbers =
                || rest.iter().map(|word| word.parse::<f64>().unwrap_or_else(|_| panic!("line {}", number + 1)));
            let corners = || numbers().map(|number| number as u32).collect::<Vec<_>>();
            if word == "case" {
                list.push(Case { name: rest.join(" "), ..Case::default() });
                continue;
            }
            let case = list.last_mut().expect("a case first");
            match word {
                "simple" => case.quality = Quality::Simple,
                "clean" => case.quality = Quality::Clean,
                "axis" => case.axis = "xyz".find(rest[0]).expect("x, y or z"),
                "planes" => case.planes = numbers().collect(),
                "point" => case.points.push(numbers().collect::<Vec<_>>().try_into().expect("three numbers")),
                "face" => case.faces.push(vec![corners()]),
                "hole" => case.faces.last_mut().expect("a face first").push(corners()),
                other => panic!("line {}: what is `{other}`?", number + 1),
            }
        }
        list
    }

    pub fn mesh(&self) -> Arc<Mesh> {
        let mut builder = MeshBuilder::new();
        let points: Vec<u32> = self.points.iter().map(|point| builder.point(*point)).collect();
        for face in &self.faces {
            let loops: Vec<Vec<u32>> =
                face.iter().map(|corners| corners.iter().map(|&corner| points[corner as usize]).collect()).collect();
            let holes: Vec<&[u32]> = loops[1..].iter().map(Vec::as_slice).collect();
            builder.face(&loops[0], &holes, FaceTag::PLAIN);
        }
        Arc::new(builder.build().unwrap())
    }

    /// Cuts the mesh and checks the laws of its quality. A failure prints the case as text.
    pub fn check(&self) {
        let print = PrintOnPanic(self);
        let (mesh, axis) = (self.mesh(), AXES[self.axis]);
        if self.quality == Quality::Clean {
            check_closed_cut(&self.name, &mesh, axis, &self.planes);
        } else {
            check_any_cut(&self.name, &mesh, axis, &self.planes, self.quality == Quality::Simple);
        }
        std::mem::forget(print);
    }
}

/// Prints the case when dropped, which only a panic does.
struct PrintOnPanic<'c>(&'c Case);

impl Drop for PrintOnPanic<'_> {
    fn drop(&mut self) {
        eprintln!("\nto be kept in tests/corpus/cut.txt:\n\n{}", self.0);
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut line = |word: &str, numbers: &[f64]| {
            let mut text = word.to_owned();
            numbers.iter().for_each(|number| write!(text, " {number:?}").expect("room"));
            writeln!(f, "{text}")
        };
        line(&format!("case {}", self.name), &[])?;
        match self.quality {
            Quality::Any => {}
            Quality::Simple => line("simple", &[])?,
            Quality::Clean => line("clean", &[])?,
        }
        line(&format!("axis {}", ["x", "y", "z"][self.axis]), &[])?;
        line("planes", &self.planes)?;
        for point in &self.points {
            line("point", point)?;
        }
        for face in &self.faces {
            for (index, corners) in face.iter().enumerate() {
                let corners = corners.iter().map(u32::to_string).collect::<Vec<_>>().join(" ");
                line(&format!("{} {corners}", if index == 0 { "face" } else { "hole" }), &[])?;
            }
        }
        Ok(())
    }
}

/// Checks the laws of every mesh, even a flawed one: closed meshes stay closed, no part extends beyond its slab, and
/// a second cut at the same planes changes nothing. If no face crosses itself, volumes add up and all surface is
/// kept.
pub fn check_any_cut(name: &str, mesh: &Arc<Mesh>, axis: Axis, planes: &[f64], simple: bool) {
    let what = format!("{name} across {axis:?} at {planes:?}");
    let cut = slabs(mesh, axis, planes);
    let closed = mesh.is_closed();
    assert!(!closed || cut.open.is_empty(), "{what}: left open");
    let at = axis.index();
    let (mut volume, mut area) = (0.0, DVec3::ZERO);
    for (slab, part) in cut.parts.iter().enumerate() {
        let Some(part) = part else { continue };
        let broken = part.check().into_iter().find(|flaw| !matches!(flaw, Flaw::NotPlanar { .. } | Flaw::Hole { .. }));
        assert_eq!(broken, None, "{what}: part {slab}");
        assert!(!closed || closed_by_position(part), "{what}: part {slab} is open");
        let (low, high) = (part.bounds().low[at], part.bounds().high[at]);
        assert!(slab == 0 || planes[slab - 1] <= low, "{what}: part {slab} reaches down to {low}");
        assert!(slab == planes.len() || high <= planes[slab], "{what}: part {slab} reaches up to {high}");
        volume += part.volume();
        area += across(part, axis);
        let again = slabs(part, axis, planes);
        let same = again.parts[slab].as_ref().is_some_and(|same| Arc::ptr_eq(same, part));
        // A part in a plane is on neither side of it.
        assert!(same || low == high, "{what}: cutting part {slab} again changes it");
    }
    let scale = mesh.bounds().size().max_element();
    let near = |a: f64, b: f64, of: f64| (a - b).abs() <= 1e-11 * of * (1.0 + mesh.face_count() as f64);
    if !simple {
        return;
    }
    assert!(!closed || near(volume, mesh.volume(), scale * scale * scale), "{what}: {volume}, not {}", mesh.volume());
    // Caps look along the axis, so across it the sum of all area vectors is unchanged.
    let whole = across(mesh, axis);
    assert!((area - whole).length() <= 1e-11 * scale * scale * mesh.face_count() as f64, "{what}: {area}, not {whole}");
}

/// The sum of the area vectors of all faces, without their component along the axis.
fn across(mesh: &Mesh, axis: Axis) -> DVec3 {
    let mut sum: DVec3 = mesh.faces().map(|face| face.normal() * face.area()).sum();
    sum[axis.index()] = 0.0;
    sum
}
