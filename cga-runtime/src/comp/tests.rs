//! Laws and documented behaviour of the component split, on boxes, prisms with holes, spheres, concave lots and
//! edges.

use glam::{DAffine3, DMat3, DQuat, DVec3};

use super::select::Word;
use super::{Align, Arm, AssignedComponents, Components, Mode, Select, comp_values, never};
use crate::geometry::extrude::{Extrude, extrude};
use crate::geometry::mesh::{Mesh, MeshBuilder};
use crate::geometry::primitive;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::unit::UnitMesh;
use crate::shape::{Geometry, Shape};

mod kept;
mod roofs;
mod single_faces;

const KINDS: [Components; 8] = [
    Components::Faces,
    Components::Edges,
    Components::FaceEdges,
    Components::Vertices,
    Components::FaceVertices,
    Components::Groups,
    Components::Materials,
    Components::Holes,
];

fn arm(word: Word, mode: Mode) -> Arm {
    Arm { select: Select::Word(word), mode, text: "".into() }
}

/// The parts of a comp: arm, members and shape of each.
fn parts(shape: &Shape, components: Components, align: Align, arms: &[Arm]) -> Vec<(u32, Vec<u32>, Shape)> {
    let (env, shape) = (&mut Env::for_tests(), shape.clone());
    let mut out = Vec::new();
    let parts = AssignedComponents::of(env, &shape, components, align, arms, never);
    let std::ops::ControlFlow::Continue(parts) = parts else { panic!("no limit is near") };
    let _: Flow = parts.each(|arm, members, part| {
        out.push((arm, members.to_vec(), part.clone()));
        Flow::Continue(())
    });
    out
}

fn all(shape: &Shape, components: Components, align: Align) -> Vec<Shape> {
    parts(shape, components, align, &[arm(Word::All, Mode::Each)]).into_iter().map(|part| part.2).collect()
}

fn prism_with_hole() -> Mesh {
    let square = |low: f64, high: f64| {
        [(low, low), (high, low), (high, high), (low, high)].map(|(x, z)| DVec3::new(x, 0.0, -z)).to_vec()
    };
    extrude(&Mesh::from_polygon(&square(0.0, 10.0), &[square(3.0, 6.0)]).unwrap(), Extrude::FaceNormal, 4.0)
}

fn concave_prism() -> Mesh {
    let u = [(0., 0.), (9., 0.), (9., 7.), (6., 7.), (6., 3.), (3., 3.), (3., 7.), (0., 7.)];
    let u: Vec<DVec3> = u.iter().map(|&(x, z)| DVec3::new(x, 0.0, -z)).collect();
    extrude(&Mesh::from_polygon(&u, &[]).unwrap(), Extrude::FaceNormal, 5.0)
}

/// A ball of triangles and rectangles.
fn ball() -> Mesh {
    let (around, up) = (16, 8);
    let mut builder = MeshBuilder::new();
    let point = |i: u32, j: u32| {
        let (turn, rise) = (f64::from(i % around) / f64::from(around), f64::from(j) / f64::from(up));
        let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
        let (y, r) = (-libm::cos(rise * std::f64::consts::PI), libm::sin(rise * std::f64::consts::PI));
        if j == 0 || j == up { DVec3::Y * y.signum() } else { DVec3::new(cos * r, y, -sin * r) }
    };
    for j in 0..up {
        for i in 0..around {
            let mut ring: Vec<u32> =
                [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| builder.point(point(i, j))).to_vec();
            ring.dedup();
            if ring[0] == ring[ring.len() - 1] {
                ring.pop();
            }
            builder.face(&ring, &[], Default::default());
        }
    }
    builder.build().unwrap()
}

/// Two leaves on a stem, in groups and materials.
fn tree() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.groups(["stem".to_owned(), "leaf".to_owned()]);
    builder.materials(
        ["bark", "green"]
            .map(|name| crate::material::Material { name: Some(name.into()), ..crate::material::Material::UNSET }),
    );
    for (at, group) in [(0.0, 1), (2.0, 0), (4.0, 1)] {
        let cube = primitive::cube();
        let points: Vec<u32> = cube.points().iter().map(|p| builder.point(*p + DVec3::X * at)).collect();
        for face in cube.faces() {
            let ring: Vec<u32> = face.outer().iter().map(|&c| points[c as usize]).collect();
            builder.face(&ring, &[], crate::geometry::mesh::FaceTag { group, material: group, ..Default::default() });
        }
    }
    builder.build().unwrap()
}

fn models() -> Vec<Shape> {
    let turned = |mesh: &Mesh| {
        let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(1.0, 2.0, -0.5).normalize(), 0.7));
        Shape::mesh_axis_aligned(mesh.map(&DAffine3 { matrix3: turn, translation: DVec3::new(5.0, -2.0, 1.0) }))
    };
    let meshes = [prism_with_hole(), concave_prism(), ball(), tree(), primitive::cylinder(7)];
    let mut models: Vec<Shape> = meshes.iter().map(turned).collect();
    models.extend(meshes.into_iter().map(Shape::mesh));
    models.extend([Shape::cuboid(2.0, 3.0, 4.0), Shape::rectangle(5.0, 4.0)]);
    models.push(Shape::line([1.0, 2.0, 3.0], [4.0, 2.0, 7.0]).unwrap());
    models
}

fn world_area(shape: &Shape) -> f64 {
    crate::query::geometry_area(&Env::for_tests(), shape, Word::All)
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs()).max(1.0)
}

#[test]
fn all_hands_out_every_component_once() {
    for shape in models() {
        for kind in KINDS {
            for mode in [Mode::Each, Mode::Together, Mode::Connected] {
                let parts = parts(&shape, kind, Align::ZUp, &[arm(Word::Top, mode), arm(Word::All, mode)]);
                let mut members: Vec<u32> = parts.iter().flat_map(|part| part.1.clone()).collect();
                members.sort_unstable();
                let count = all(&shape, kind, Align::ZUp).len() as u32;
                assert_eq!(members, (0..count).collect::<Vec<_>>(), "{kind:?} {mode:?}");
            }
        }
    }
}

#[test]
fn areas_add_up_and_nothing_moves() {
    for shape in models() {
        for kind in [Components::Faces, Components::Groups, Components::Materials] {
            for align in [Align::ZUp, Align::Keep] {
                let sum: f64 = all(&shape, kind, align).iter().map(world_area).sum();
                assert!(close(sum, world_area(&shape)), "{kind:?} {sum} {}", world_area(&shape));
            }
        }
    }
}

#[test]
fn frames_are_right_handed_and_scopes_hold_what_they_should() {
    for shape in models() {
        for kind in KINDS {
            for part in all(&shape, kind, Align::ZUp) {
                for axes in [part.scope.axes, part.pivot.axes] {
                    assert!((axes.transpose() * axes).abs_diff_eq(DMat3::IDENTITY, 1e-12), "{kind:?} {axes:?}");
                    assert!(close(axes.determinant(), 1.0));
                }
                let size = part.scope.size;
                match kind {
                    Components::Faces | Components::Holes => {
                        assert!(size.z.abs() <= 1e-12 * size.max_element(), "{size:?}");
                        assert_eq!(part.scope.axes, part.pivot.axes);
                    }
                    Components::Edges | Components::FaceEdges => {
                        assert!(matches!(part.geometry, Geometry::Edge));
                        assert!(0.0 < size.x && size.y == 0.0 && size.z == 0.0);
                        assert_eq!(part.scope.origin, part.pivot.origin);
                    }
                    Components::Vertices | Components::FaceVertices => {
                        assert!(matches!(part.geometry, Geometry::Vertex));
                        assert_eq!(size, DVec3::ZERO);
                    }
                    Components::Groups | Components::Materials => assert_eq!(part.pivot, shape.pivot),
                }
            }
        }
    }
}

#[test]
fn no_align_keeps_pivot_and_axes() {
    for shape in models() {
        for kind in KINDS {
            let kept = all(&shape, kind, Align::Keep);
            let aligned = all(&shape, kind, Align::ZUp);
            assert_eq!(kept.len(), aligned.len());
            for (kept, aligned) in kept.iter().zip(&aligned) {
                assert_eq!((kept.pivot, kept.scope.axes), (shape.pivot, shape.scope.axes));
                assert!(close(world_area(kept), world_area(aligned)));
                let length = crate::query::geometry_boundary_length;
                assert!(close(length(kept), length(aligned)), "{kind:?}");
                // Both boxes contain the same geometry.
                assert!((kept.scope.centre() - aligned.scope.centre()).length() < 20.0);
            }
        }
    }
}

#[test]
fn turning_the_input_turns_the_frames() {
    let turn = DMat3::from_quat(DQuat::from_axis_angle(DVec3::new(0.3, -1.0, 0.8).normalize(), 1.1));
    for shape in models() {
        let mut turned = shape.clone();
        turned.scope.axes = turn * shape.scope.axes;
        turned.scope.origin = turn * shape.scope.origin;
        for kind in KINDS {
            for (before, after) in all(&shape, kind, Align::ZUp).iter().zip(&all(&turned, kind, Align::ZUp)) {
                if !matches!(kind, Components::Groups | Components::Materials) {
                    assert!((turn * before.pivot.axes).abs_diff_eq(after.pivot.axes, 1e-9), "{kind:?}");
                    assert!((turn * before.pivot.origin).abs_diff_eq(after.pivot.origin, 1e-9));
                }
                assert!((turn * before.scope.axes).abs_diff_eq(after.scope.axes, 1e-9));
                assert!(before.scope.size.abs_diff_eq(after.scope.size, 1e-9));
            }
        }
    }
}

#[test]
fn counts_of_a_box_and_of_a_prism_with_a_hole() {
    let counts = |shape: &Shape| KINDS.map(|kind| all(shape, kind, Align::ZUp).len());
    assert_eq!(counts(&Shape::cuboid(1.0, 2.0, 3.0)), [6, 12, 24, 8, 24, 1, 1, 0]);
    assert_eq!(counts(&Shape::rectangle(1.0, 2.0)), [1, 4, 4, 4, 4, 1, 1, 0]);
    assert_eq!(counts(&Shape::mesh_axis_aligned(prism_with_hole())), [10, 24, 48, 16, 48, 1, 1, 2]);
    assert_eq!(counts(&Shape::mesh_axis_aligned(tree())), [18, 36, 72, 24, 72, 2, 2, 0]);
    assert_eq!(counts(&Shape::line([0.0; 3], [1.0, 0.0, 0.0]).unwrap()), [0, 1, 1, 2, 2, 0, 0, 0]);
}

#[test]
fn opposite_sides_are_connected_through_what_is_between() {
    let shape = Shape::cuboid(1.0, 1.0, 1.0);
    let sets = |words: &[Word], mode| {
        let arms: Vec<Arm> = words.iter().map(|&word| arm(word, mode)).collect();
        parts(&shape, Components::Faces, Align::ZUp, &arms).into_iter().map(|part| part.1.len()).collect::<Vec<_>>()
    };
    assert_eq!(sets(&[Word::Horizontal, Word::All], Mode::Connected), [1, 1, 4]);
    assert_eq!(sets(&[Word::Side], Mode::Connected), [4]);
    assert_eq!(sets(&[Word::Top, Word::All], Mode::Together), [1, 5]);
    // A U-shaped lot: five walls look to the front, the back or a side, some of them disconnected.
    let u = Shape::mesh_axis_aligned(concave_prism());
    let fronts = parts(&u, Components::Faces, Align::ZUp, &[arm(Word::Front, Mode::Each)]);
    let connected = parts(&u, Components::Faces, Align::ZUp, &[arm(Word::Front, Mode::Connected)]);
    assert_eq!((fronts.len(), connected.len()), (1, 1));
    let backs = parts(&u, Components::Faces, Align::ZUp, &[arm(Word::Back, Mode::Connected)]);
    assert_eq!(backs.len(), 3, "the ends of both wings and the bottom of the yard");
}

#[test]
fn edges_point_to_the_mean_of_their_faces() {
    let shape = Shape::cuboid(2.0, 2.0, 2.0);
    for part in all(&shape, Components::Edges, Align::ZUp) {
        let middle = part.scope.centre() - DVec3::ONE;
        assert!(part.scope.axes.z_axis.abs_diff_eq(middle.normalize(), 1e-12));
    }
    for part in all(&shape, Components::Vertices, Align::ZUp) {
        assert!(part.scope.axes.z_axis.abs_diff_eq((part.scope.origin - DVec3::ONE).normalize(), 1e-12));
    }
}

#[test]
fn face_edges_point_out_of_their_face() {
    // The four edges of a rectangle: front, right, back, left of a lot seen from above.
    let shape = Shape::rectangle(6.0, 4.0);
    let found = all(&shape, Components::FaceEdges, Align::ZUp);
    let outwards: Vec<DVec3> = found.iter().map(|part| part.scope.axes.z_axis).collect();
    assert_eq!(outwards, [DVec3::Z, DVec3::X, -DVec3::Z, -DVec3::X]);
    assert!(found.iter().all(|part| part.scope.axes.y_axis == DVec3::Y));
    assert_eq!(found.iter().map(|part| part.scope.size.x).collect::<Vec<_>>(), [6.0, 4.0, 6.0, 4.0]);
    let words = [Word::Front, Word::Right, Word::Back, Word::Left].map(|word| arm(word, Mode::Each));
    let arms: Vec<u32> = parts(&shape, Components::FaceEdges, Align::ZUp, &words).iter().map(|part| part.0).collect();
    assert_eq!(arms, [0, 1, 2, 3]);
    // The corners: outwards along the diagonals.
    for part in all(&shape, Components::FaceVertices, Align::ZUp) {
        let z = part.scope.axes.z_axis;
        assert!(close(z.x.abs(), z.z.abs()) && 0.0 < z.dot(part.scope.origin - shape.scope.centre()));
        assert!(part.scope.axes.y_axis.abs_diff_eq(DVec3::Y, 1e-12));
    }
}

#[test]
fn a_hole_is_filled_as_its_face_looks() {
    let shape = Shape::mesh_axis_aligned(prism_with_hole());
    let holes = all(&shape, Components::Holes, Align::ZUp);
    assert!(holes.iter().all(|hole| close(world_area(hole), 9.0)));
    let mut looks: Vec<f64> = holes.iter().map(|hole| hole.scope.axes.z_axis.y).collect();
    looks.sort_by(f64::total_cmp);
    assert_eq!(looks, [-1.0, 1.0]);
}

#[test]
fn border_and_inside_of_a_grid() {
    let mut builder = MeshBuilder::new();
    for i in 0..16 {
        let (x, z) = (f64::from(i % 4), f64::from(i / 4));
        let ring = [(x, z), (x, z + 1.0), (x + 1.0, z + 1.0), (x + 1.0, z)].map(|(x, z)| builder.point([x, 0.0, z]));
        builder.face(&ring, &[], Default::default());
    }
    let shape = Shape::mesh_axis_aligned(builder.build().unwrap());
    let counts = |kind| {
        let arms = [Word::Border, Word::Inside].map(|word| arm(word, Mode::Each));
        let found = parts(&shape, kind, Align::ZUp, &arms);
        [0, 1].map(|arm| found.iter().filter(|part| part.0 == arm).count())
    };
    assert_eq!(counts(Components::Faces), [12, 4]);
    assert_eq!(counts(Components::Edges), [16, 24]);
    assert_eq!(counts(Components::FaceEdges), [16, 48]);
    assert_eq!(counts(Components::Vertices), [16, 9]);
    assert_eq!(counts(Components::FaceVertices), [28, 36]);
    assert_eq!(counts(Components::Groups), [1, 0]);
}

#[test]
fn values_are_in_the_order_of_components() {
    let env = &mut Env::for_tests();
    let mut lot = Shape::rectangle(6.0, 4.0);
    let each = [arm(Word::All, Mode::Each)];
    let index = |_: &mut Env, _: u32, part: &mut crate::shape::Shape| f64::from(part.comp.index());
    let found = comp_values(env, &mut lot, Components::Vertices, Align::ZUp, &each, never, index);
    assert_eq!(found.as_slice(), [0.0, 1.0, 2.0, 3.0]);
    let arms = [Word::Front, Word::Right].map(|word| arm(word, Mode::Together));
    let found = comp_values(env, &mut lot, Components::FaceEdges, Align::ZUp, &arms, never, |_, _, _| 5.0);
    assert_eq!(found.as_slice(), [5.0, 5.0, 0.0, 0.0]);
}

/// A hip roof over a rectangle, as in the reference's picture, and the same with a floor.
fn hip_roofs() -> [Mesh; 2] {
    let mut builder = MeshBuilder::new();
    let p = [[0., 0., 4.], [10., 0., 4.], [10., 0., 0.], [0., 0., 0.], [2., 2., 2.], [8., 2., 2.]]
        .map(|p| builder.point(p));
    let roof: [&[u32]; 4] =
        [&[p[0], p[1], p[5], p[4]], &[p[1], p[2], p[5]], &[p[2], p[3], p[4], p[5]], &[p[3], p[0], p[4]]];
    roof.iter().for_each(|face| _ = builder.face(face, &[], Default::default()));
    let mut closed = builder.clone();
    closed.face(&[p[3], p[2], p[1], p[0]], &[], Default::default());
    [builder, closed].map(|builder| builder.build().unwrap())
}

#[test]
fn roof_edges_of_a_hip_roof_open_or_closed() {
    for mesh in hip_roofs() {
        let shape = Shape::mesh_axis_aligned(mesh);
        let words = [Word::Eave, Word::Hip, Word::Valley, Word::Ridge].map(|word| arm(word, Mode::Each));
        let found = parts(&shape, Components::Edges, Align::ZUp, &words);
        let count = |arm| found.iter().filter(|part| part.0 == arm).count();
        assert_eq!([0, 1, 2, 3].map(count), [4, 4, 0, 1]);
        for (arm, _, part) in &found {
            let x = part.scope.axes.x_axis;
            match arm {
                // Anti-clockwise around the roof's own face, which is left of the edge.
                0 => assert!(0.0 < DVec3::Y.cross(x).dot(DVec3::new(5.0, 0.0, 2.0) - part.scope.origin)),
                _ => assert!(0.0 <= x.y),
            }
        }
    }
}

#[test]
fn a_valley_is_concave() {
    // Two slopes towards each other.
    let mut builder = MeshBuilder::new();
    let p =
        [[0., 1., 0.], [0., 1., 2.], [2., 0., 2.], [2., 0., 0.], [4., 1., 2.], [4., 1., 0.]].map(|p| builder.point(p));
    builder.face(&[p[0], p[1], p[2], p[3]], &[], Default::default());
    builder.face(&[p[3], p[2], p[4], p[5]], &[], Default::default());
    let shape = Shape::mesh_axis_aligned(builder.build().unwrap());
    let found = parts(&shape, Components::Edges, Align::ZUp, &[arm(Word::Valley, Mode::Each)]);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].2.scope.size.x, 2.0);
}

#[test]
fn streets_decide_what_is_front() {
    // The street runs along the right side of the lot. Otherwise the lot has no front.
    let lot = Shape::rectangle(6.0, 4.0).streets([0.0, 8.0, 0.0, 0.0]);
    let words = [Word::StreetFront, Word::StreetBack, Word::StreetLeft, Word::StreetRight];
    let env_of = |lot: &Shape| Env::with_names(&crate::run::settings::Settings::default(), &["Lot"], lot, "Lot");
    let numbers = |lot: &Shape| {
        let arms = words.map(|word| arm(word, Mode::Each));
        let mut own = lot.clone();
        let value = |_: &mut Env, arm: u32, _: &mut crate::shape::Shape| f64::from(arm);
        comp_values(&mut env_of(lot), &mut own, Components::FaceEdges, Align::ZUp, &arms, never, value)
            .as_slice()
            .to_vec()
    };
    // Edges: front, right, back, left of the object.
    assert_eq!(numbers(&lot), [2.0, 0.0, 3.0, 1.0]);
    assert_eq!(numbers(&Shape::rectangle(6.0, 4.0)), [0.0, 3.0, 1.0, 2.0], "without streets, as of the object");
    // Walls over the lot have the directions of its edges.
    let mut walls = lot.clone();
    walls.geometry = Geometry::Box(UnitMesh::cuboid());
    walls.scope.size.y = 3.0;
    let arms = words.map(|word| arm(word, Mode::Each));
    let value = |_: &mut Env, arm: u32, _: &mut crate::shape::Shape| f64::from(arm) + 1.0;
    let found = comp_values(&mut env_of(&lot), &mut walls, Components::Faces, Align::ZUp, &arms, never, value);
    let mut found = found.as_slice().to_vec();
    found.sort_by(f64::total_cmp);
    assert_eq!(found, [0.0, 0.0, 1.0, 2.0, 3.0, 4.0]);
}

#[test]
fn what_is_flat_or_nothing_has_no_parts() {
    let mut nothing = Shape::rectangle(1.0, 1.0);
    nothing.geometry = Geometry::Empty;
    let mut flat = Shape::cuboid(1.0, 1.0, 1.0);
    flat.resize(DVec3::new(1.0, 0.0, 0.0));
    for kind in KINDS {
        assert!(all(&nothing, kind, Align::ZUp).is_empty());
        all(&flat, kind, Align::ZUp);
        all(&flat, kind, Align::Keep);
    }
    assert!(all(&flat, Components::Faces, Align::ZUp).is_empty(), "faces without area are never selected");
}

#[test]
fn mirrored_shapes_are_selected_by_where_faces_are() {
    let mut shape = Shape::mesh_axis_aligned(ball());
    shape.scope.size.x = -shape.scope.size.x;
    for (word, axis, sign) in [(Word::Top, 1, 1.0), (Word::Right, 0, 1.0), (Word::Back, 2, -1.0)] {
        let found = parts(&shape, Components::Faces, Align::ZUp, &[arm(word, Mode::Each)]);
        assert!(!found.is_empty());
        let centre = shape.scope.centre();
        let at = |part: &Shape| (part.scope.centre() - centre)[axis] * sign;
        assert!(found.iter().all(|part| 0.3 < at(&part.2)), "{word:?}");
    }
}
