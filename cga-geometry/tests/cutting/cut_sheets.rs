//! Sheets, closed pieces without thickness, stay whole when a plane goes through them.

use std::sync::Arc;

use crate::cut_support::{Rng, closed_by_position};
use cga_geometry::Axis;
use cga_geometry::cut::{Plane, Slabs, halves, slabs};
use cga_geometry::glam::DVec3;
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};

type Rectangle = [f64; 4];

/// Builds faces across z from the corners of their rectangles, and boxes.
#[derive(Default)]
struct Model(MeshBuilder);

impl Model {
    fn face(&mut self, corners: &[[f64; 2]], z: f64, up: bool) {
        let mut corners: Vec<u32> = corners.iter().map(|&[x, y]| self.0.point([x, y, z])).collect();
        if !up {
            corners.reverse();
        }
        self.0.face(&corners, &[], FaceTag::PLAIN);
    }

    /// A rectangle as one face, or as two triangles along one of the diagonals.
    fn side(&mut self, [x0, y0, x1, y1]: Rectangle, z: f64, up: bool, pattern: usize) {
        let [a, b, c, d] = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
        match pattern {
            0 => self.face(&[a, b, c, d], z, up),
            1 => [[a, b, c], [a, c, d]].iter().for_each(|corners| self.face(corners, z, up)),
            _ => [[a, b, d], [b, c, d]].iter().for_each(|corners| self.face(corners, z, up)),
        }
    }

    fn sheet(&mut self, rectangle: Rectangle, z: f64, patterns: [usize; 2]) {
        self.side(rectangle, z, true, patterns[0]);
        self.side(rectangle, z, false, patterns[1]);
    }

    /// A box, or a cavity, which is inside out.
    fn cuboid(&mut self, [x0, y0, x1, y1]: Rectangle, [low, high]: [f64; 2], is_solid: bool) {
        self.side([x0, y0, x1, y1], high, is_solid, 0);
        self.side([x0, y0, x1, y1], low, !is_solid, 0);
        let ground = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
        for i in 0..4 {
            let (p, q) = (ground[i], ground[(i + 1) % 4]);
            let mut wall = [(p, low), (q, low), (q, high), (p, high)].map(|([x, y], z)| self.0.point([x, y, z]));
            if !is_solid {
                wall.reverse();
            }
            self.0.face(&wall, &[], FaceTag::PLAIN);
        }
    }

    fn build(self) -> Arc<Mesh> {
        let mesh = self.0.build().unwrap();
        assert!(mesh.is_closed());
        Arc::new(mesh)
    }
}

/// The areas of a part's faces in a plane: of the mesh upwards and downwards, of caps upwards and downwards.
fn areas(part: &Mesh, z: f64) -> [f64; 4] {
    let mut sums = [0.0; 4];
    for face in part.faces().filter(|face| face.loops().flatten().all(|&point| part.points()[point as usize].z == z)) {
        let at = 2 * usize::from(face.tag().cap) + usize::from(face.normal().z < 0.0);
        sums[at] += face.area();
    }
    sums
}

/// Cuts across z and checks the laws of every cut. Returns the areas below and above each plane.
fn cut(mesh: &Arc<Mesh>, planes: &[f64]) -> (Slabs, Vec<[[f64; 4]; 2]>) {
    let cut = slabs(mesh, Axis::Z, planes);
    let parts: Vec<&Arc<Mesh>> = cut.parts.iter().flatten().collect();
    assert!(cut.open.is_empty() && parts.iter().all(|part| part.is_closed() && closed_by_position(part)));
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a}, not {b}");
    near(parts.iter().map(|part| part.volume()).sum(), mesh.volume());
    let old = |part: &&Arc<Mesh>| part.faces().filter(|face| !face.tag().cap).map(|face| face.area()).sum::<f64>();
    near(parts.iter().map(old).sum(), mesh.area());
    let of = |slab: usize, z: f64| cut.parts[slab].as_ref().map_or([0.0; 4], |part| areas(part, z));
    let found = planes.iter().enumerate().map(|(i, &z)| [of(i, z), of(i + 1, z)]).collect();
    (cut, found)
}

const NONE: [f64; 4] = [0.0; 4];

#[test]
fn a_sheet_goes_below_as_a_whole_however_its_sides_are_divided() {
    for patterns in [[0, 0], [0, 1], [1, 1], [1, 2], [2, 0]] {
        // Between a box below and one above, so that the plane is inside the mesh.
        let mut model = Model::default();
        model.cuboid([0.0, 0.0, 1.0, 1.0], [0.0, 1.0], true);
        model.sheet([5.0, 0.0, 7.0, 3.0], 2.0, patterns);
        model.cuboid([0.0, 0.0, 1.0, 1.0], [3.0, 4.0], true);
        let mesh = model.build();
        let (parts, found) = cut(&mesh, &[2.0]);
        assert_eq!(found, [[[6.0, 6.0, 0.0, 0.0], NONE]], "{patterns:?}");
        let faces = parts.parts.iter().flatten().map(|part| part.face_count()).sum::<usize>();
        assert_eq!(faces, mesh.face_count());
    }
}

#[test]
fn a_plane_in_any_direction_keeps_sheets_whole() {
    let mut model = Model::default();
    model.cuboid([0.0, 0.0, 1.0, 1.0], [0.0, 4.0], true);
    model.sheet([5.0, 0.0, 7.0, 3.0], 2.0, [0, 1]);
    let mesh = model.build();
    for (normal, side) in [(DVec3::Z, 0), (DVec3::NEG_Z, 1)] {
        let plane = Plane { point: DVec3::new(0.0, 0.0, 2.0), normal };
        let cut = halves(&mesh, &plane, 0.0);
        let of = |side: usize| areas(cut.parts[side].as_ref().unwrap(), 2.0);
        let cap = |side: usize| if side == 0 { [0.0, 0.0, 1.0, 0.0] } else { [0.0, 0.0, 0.0, 1.0] };
        let below = [of(side), of(1 - side)];
        let with_sheet = |[_, _, up, down]: [f64; 4]| [6.0, 6.0, up, down];
        let expected = if side == 0 { [with_sheet(cap(0)), cap(1)] } else { [cap(0), with_sheet(cap(1))] };
        assert_eq!(below, expected, "{normal}");
    }
}

#[test]
fn a_sheet_in_a_solid_goes_below_and_leaves_the_caps_whole() {
    // Inside, half outside, and all around it.
    for (sheet, area) in [([1.0, 1.0, 2.0, 2.0], 1.0), ([3.0, 1.0, 5.0, 2.0], 2.0), ([-1.0, -1.0, 5.0, 5.0], 36.0)] {
        let mut model = Model::default();
        model.cuboid([0.0, 0.0, 4.0, 4.0], [0.0, 4.0], true);
        model.sheet(sheet, 2.0, [0, 0]);
        let (_, found) = cut(&model.build(), &[2.0]);
        assert_eq!(found, [[[area, area, 16.0, 0.0], [0.0, 0.0, 0.0, 16.0]]], "{sheet:?}");
    }
}

#[test]
fn sheets_that_lie_on_each_other_all_go_below() {
    for patterns in [[0, 0], [1, 1], [1, 2], [0, 2]] {
        for inside in [false, true] {
            let mut model = Model::default();
            model.cuboid([0.0, 0.0, 4.0, 4.0], [0.0, 4.0], true);
            let x = if inside { 1.0 } else { 5.0 };
            // Three at one place, one beside them with a common edge, one that overlaps them partly.
            (0..3).for_each(|_| model.sheet([x, 1.0, x + 1.0, 2.0], 2.0, patterns));
            model.sheet([x + 1.0, 1.0, x + 2.0, 2.0], 2.0, patterns);
            model.sheet([x + 0.5, 1.5, x + 1.5, 3.0], 2.0, patterns);
            let (_, found) = cut(&model.build(), &[2.0]);
            assert_eq!(found, [[[5.5, 5.5, 16.0, 0.0], [0.0, 0.0, 0.0, 16.0]]], "{patterns:?} {inside}");
        }
    }
}

#[test]
fn sheets_in_several_planes_of_one_cut() {
    let mut model = Model::default();
    model.cuboid([0.0, 0.0, 4.0, 4.0], [0.0, 10.0], true);
    for z in 1..=4 {
        model.sheet([5.0, 0.0, 5.0 + f64::from(z), 1.0], f64::from(2 * z), [0, z as usize % 3]);
    }
    let mesh = model.build();
    let (_, found) = cut(&mesh, &[2.0, 3.0, 4.0, 6.0, 8.0]);
    let at = |area: f64| [[area, area, 16.0, 0.0], [0.0, 0.0, 0.0, 16.0]];
    assert_eq!(found, [at(1.0), at(0.0), at(2.0), at(3.0), at(4.0)]);
    // One sheet crosses planes that contain another sheet.
    let (_, found) = cut(&mesh, &[4.0]);
    assert_eq!(found, [at(2.0)]);
}

#[test]
fn solids_that_meet_in_a_plane_part_there_all_the_same() {
    let mut model = Model::default();
    model.cuboid([0.0, 0.0, 2.0, 2.0], [0.0, 2.0], true);
    model.cuboid([0.0, 0.0, 2.0, 2.0], [2.0, 4.0], true);
    // The same with a further sheet, which shares an edge with both.
    let alone = [[[4.0, 0.0, 0.0, 0.0], [0.0, 4.0, 0.0, 0.0]]];
    let (_, found) = cut(&model.build(), &[2.0]);
    assert_eq!(found, alone);
    let mut model = Model::default();
    model.cuboid([0.0, 0.0, 2.0, 2.0], [0.0, 2.0], true);
    model.cuboid([0.0, 0.0, 2.0, 2.0], [2.0, 4.0], true);
    model.sheet([2.0, 0.0, 3.0, 2.0], 2.0, [0, 0]);
    let (_, found) = cut(&model.build(), &[2.0]);
    assert_eq!(found, [[[6.0, 2.0, 0.0, 0.0], [0.0, 4.0, 0.0, 0.0]]]);
}

#[test]
fn a_room_below_a_plane_keeps_its_ceiling_above() {
    // A cavity's ceiling in the plane; and a second one directly above it, without a gap.
    for (second, expected) in [
        (false, [[0.0, 0.0, 15.0, 0.0], [0.0, 1.0, 0.0, 15.0]]),
        (true, [[1.0, 1.0, 15.0, 0.0], [0.0, 0.0, 0.0, 15.0]]),
    ] {
        let mut model = Model::default();
        model.cuboid([0.0, 0.0, 4.0, 4.0], [0.0, 4.0], true);
        model.cuboid([1.0, 1.0, 2.0, 2.0], [1.0, 2.0], false);
        if second {
            model.cuboid([1.0, 1.0, 2.0, 2.0], [2.0, 3.0], false);
        }
        let (_, found) = cut(&model.build(), &[2.0]);
        assert_eq!(found, [expected]);
    }
}

#[test]
fn a_sheet_that_goes_on_from_a_roof_stays_with_it() {
    // One face is the top of a box and of an adjacent canopy without thickness.
    let mut model = Model::default();
    let mut ring = |z: f64| [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| model.0.point([x, y, z]));
    let (low, high) = (ring(0.0), ring(2.0));
    for i in 0..4 {
        let j = (i + 1) % 4;
        model.0.face(&[low[i], low[j], high[j], high[i]], &[], FaceTag::PLAIN);
    }
    model.0.face(&[low[3], low[2], low[1], low[0]], &[], FaceTag::PLAIN);
    model.face(&[[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [0.0, 1.0]], 2.0, true);
    model.side([1.0, 0.0, 3.0, 1.0], 2.0, false, 1);
    model.cuboid([8.0, 0.0, 9.0, 1.0], [0.0, 4.0], true);
    let (_, found) = cut(&model.build(), &[2.0]);
    assert_eq!(found, [[[3.0, 2.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]]);
}

#[test]
fn any_sheets_among_any_boxes_are_counted_once() {
    let mut rng = Rng(3);
    for round in 0..300 {
        let mut model = Model::default();
        let mut expected = 0.0;
        let rectangle = |rng: &mut Rng| {
            let (x, y) = (rng.below(6) as f64, rng.below(6) as f64);
            [x, y, x + 1.0 + rng.below(3) as f64, y + 1.0 + rng.below(3) as f64]
        };
        model.cuboid([20.0, 0.0, 21.0, 1.0], [0.0, 6.0], true);
        for _ in 0..rng.below(4) {
            let (low, height) = (rng.below(4) as f64, 1.0 + rng.below(3) as f64);
            let solid = rectangle(&mut rng);
            model.cuboid(solid, [low, low + height], true);
        }
        for _ in 0..1 + rng.below(4) {
            let sheet = rectangle(&mut rng);
            // Away from the boxes, or among them.
            let x = if rng.below(2) == 0 { 30.0 } else { 0.0 };
            model.sheet([sheet[0] + x, sheet[1], sheet[2] + x, sheet[3]], 3.0, [rng.below(3), rng.below(3)]);
            expected += if x == 0.0 { 0.0 } else { (sheet[2] - sheet[0]) * (sheet[3] - sheet[1]) };
        }
        let (cut, _) = cut(&model.build(), &[2.0, 3.0, 4.0]);
        // Geometry far from all boxes consists of sheets only.
        let far = |part: &Option<Arc<Mesh>>| {
            let Some(part) = part else { return [0.0; 2] };
            let mut sums = [0.0; 2];
            for face in part.faces().filter(|face| part.points()[face.loops().next().unwrap()[0] as usize].x > 25.0) {
                assert!(!face.tag().cap, "round {round}");
                sums[usize::from(face.normal().z < 0.0)] += face.area();
            }
            sums
        };
        let found: Vec<[f64; 2]> = cut.parts.iter().map(far).collect();
        assert_eq!(found, [[0.0; 2], [expected; 2], [0.0; 2], [0.0; 2]], "round {round}");
    }
}
