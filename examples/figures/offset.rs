//! An outline with a courtyard, offset inwards and outwards.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::sync::Arc;

use cga::glam::DVec3;
use cga::mesh::FaceTag;
use cga::sink::picture::Camera;
use cga::{Mesh, MeshBuilder, Shape, cga};

use crate::pen::{BLUE, GREEN, INK, ORANGE, Pen, RED, STONE, edges, hue, rings};
use crate::sheet::Cell;

cga! {
    /// The inside of the moved outlines, and the border faces.
    grammar Offset;
    attr distance = 1
    @StartRule
    Inside --> offset(distance, inside) Inside.
    @StartRule
    Border --> offset(distance, border) Border.
}

/// The width of bars and dots.
const BAR: f64 = 0.09;
const DOT: f64 = 0.55;

/// A distance at which everything is swept.
const FAR: f64 = 1000.0;

/// Corners as (x, z).
const OUTLINE: [[f64; 2]; 9] = [
    [0.0, 0.0],
    [11.0, 1.0],
    [13.0, 5.0],
    [19.0, 3.0],
    [30.0, 0.0],
    [28.0, 13.0],
    [17.0, 12.0],
    [14.0, 14.0],
    [1.0, 13.0],
];
const COURTYARD: [[f64; 2]; 4] = [[4.2, 5.6], [8.4, 4.2], [9.8, 8.2], [5.4, 9.4]];

/// A corridor of constant width around a courtyard: all its edges meet at once.
const CLOISTER: [[f64; 2]; 6] = [[0.0, 0.0], [30.0, 0.0], [30.0, 5.0], [22.0, 5.0], [22.0, 13.0], [0.0, 13.0]];
const COURT: [[f64; 2]; 4] = [[4.0, 4.0], [18.0, 4.0], [18.0, 9.0], [4.0, 9.0]];

/// A roof that is not planar, and the corners' heights.
const ROOF: [[f64; 3]; 6] =
    [[0.0, 0.0, 0.0], [0.0, 3.0, 12.0], [12.0, 0.0, 12.0], [14.0, 1.5, 7.0], [26.0, 0.0, 7.0], [26.0, 7.0, 0.0]];

/// The picture's cells, one for each group of steps.
pub(crate) fn cells() -> Result<Vec<Cell>, Box<dyn Error>> {
    let lot = Shape::footprint(&OUTLINE, &[COURTYARD.to_vec()])?;
    let cloister = Shape::footprint(&CLOISTER, &[COURT.to_vec()])?;
    let mut builder = MeshBuilder::new();
    let corners = ROOF.map(|corner| builder.point(corner));
    builder.polygon(&corners);
    let roof = Shape::mesh_axis_aligned(builder.build()?);
    let flat = |pen: Pen, caption: &str| Cell {
        camera: Camera { margin: 0.03, ..Camera::auto(pen.model.bounds()) }.looking_from(0.0, 90.0).orthographic(),
        model: pen.model,
        borders: true,
        caption: caption.to_owned(),
    };
    let mut relief = Pen::default();
    strips(&mut relief, &border(&roof, -2.0)?);
    let left = inside(&roof, -2.0)?;
    relief.faces(left.faces(), &left, STONE, DVec3::ZERO);
    let relief = Cell {
        camera: Camera::auto(relief.model.bounds()).looking_from(24.0, 42.0).field_of_view(10.0),
        ..flat(relief, RELIEF)
    };
    Ok(vec![
        flat(wavefront(&lot)?, WAVEFRONT),
        flat(skeleton(&lot)?, &format!("B  {SKELETON}")),
        flat(result(&lot, -1.5)?, INWARDS),
        flat(result(&lot, 1.2)?, OUTWARDS),
        flat(skeleton(&cloister)?, CLUSTERS),
        relief,
    ])
}

const WAVEFRONT: &str = "A  edges with the region on their left (black),\n   and the wavefront every 0.6 m (blue)";
const SKELETON: &str =
    "paths of vertices, and events: edge gone (green),\n   edge split (red), loop gone (blue), several (orange)";
const INWARDS: &str = "C  offset(-1.5, all): a border face for each edge,\n   and the region that is left (grey)";
const OUTWARDS: &str = "D  offset(1.2, all): the loops are turned over\n   and sweep the outside";
const CLUSTERS: &str = "E  corridors of one width: parallel walls meet\n   along their whole length at one time";
const RELIEF: &str =
    "F  a face that is not planar: its corners stay, new\n   points get heights from the edges beside them";

/// The only leaf of a run, in the world; an empty mesh if there is none.
fn run(shape: &Shape, start: &str, distance: f64) -> Result<Mesh, Box<dyn Error>> {
    let settings = cga::Settings { start: Some(start.into()), ..Default::default() };
    let model = Offset { distance }.generate_with(shape, &settings)?;
    let mut builder = MeshBuilder::new();
    for leaf in model.leaves() {
        let (mesh, place) = leaf.mesh();
        let numbers: Vec<u32> =
            mesh.points().iter().map(|&point| builder.point(place.transform_point3(point))).collect();
        for face in mesh.faces() {
            let rings: Vec<Vec<u32>> =
                face.loops().map(|ring| ring.iter().map(|&corner| numbers[corner as usize]).collect()).collect();
            let holes: Vec<&[u32]> = rings[1..].iter().map(Vec::as_slice).collect();
            builder.face(&rings[0], &holes, FaceTag::PLAIN);
        }
    }
    Ok(builder.build()?)
}

fn inside(shape: &Shape, distance: f64) -> Result<Mesh, Box<dyn Error>> {
    run(shape, "Inside", distance)
}

fn border(shape: &Shape, distance: f64) -> Result<Mesh, Box<dyn Error>> {
    run(shape, "Border", distance)
}

/// Above the faces, so that marks are seen from above.
const LIFT: DVec3 = DVec3::new(0.0, 0.2, 0.0);

fn wavefront(shape: &Shape) -> Result<Pen, Box<dyn Error>> {
    let mut pen = Pen::default();
    pen.mesh(&Arc::new(flat(shape)), [0.93, 0.92, 0.88], DVec3::ZERO);
    // An offset that leaves nothing changes nothing.
    for distance in (1..).map(|step| 0.6 * f64::from(step)).take_while(|&distance| !is_gone(shape, distance)) {
        let left = inside(shape, -distance)?;
        rings(&left).iter().for_each(|ring| pen.ring(ring, 0.8 * BAR, BLUE, LIFT));
    }
    for (from, to) in sides(shape) {
        pen.arrow(from + LIFT, to + LIFT, 1.6 * BAR, INK);
    }
    Ok(pen)
}

fn flat(shape: &Shape) -> Mesh {
    run(shape, "Inside", 0.0).expect("a shape as it is")
}

fn is_gone(shape: &Shape, distance: f64) -> bool {
    inside(shape, -distance).is_ok_and(|left| left.points() == flat(shape).points())
}

/// Border faces, each in the colour of its edge.
fn strips(pen: &mut Pen, border: &Mesh) {
    for (number, face) in border.faces().enumerate() {
        pen.faces([face], border, hue(number), 0.1 * LIFT);
    }
}

fn result(shape: &Shape, distance: f64) -> Result<Pen, Box<dyn Error>> {
    let mut pen = Pen::default();
    let (left, border) = (inside(shape, distance)?, border(shape, distance)?);
    pen.faces(left.faces(), &left, STONE, DVec3::ZERO);
    // Border faces outside of a face look down; they are drawn from the other side.
    let turned = |mesh: &Mesh| {
        let mut builder = MeshBuilder::new();
        for face in mesh.faces() {
            let mut ring: Vec<u32> = face.outer().iter().map(|&at| builder.point(mesh.points()[at as usize])).collect();
            if face.normal().y < 0.0 {
                ring.reverse();
            }
            builder.polygon(&ring);
        }
        builder.build()
    };
    strips(&mut pen, &turned(&border)?);
    sides(shape).into_iter().for_each(|(from, to)| pen.bar(from + LIFT, to + LIFT, 1.6 * BAR, INK));
    Ok(pen)
}

/// The whole skeleton with its events.
fn skeleton(shape: &Shape) -> Result<Pen, Box<dyn Error>> {
    let mut pen = Pen::default();
    let border = border(shape, -FAR)?;
    strips(&mut pen, &border);
    let (mut heights, mut arcs) = (BTreeMap::new(), BTreeSet::new());
    for (face, edge) in border.faces().zip(sides(shape)) {
        let along = (edge.1 - edge.0).normalize_or_zero();
        let height = |at: u32| (border.points()[at as usize] - edge.0).cross(along).length();
        let ring = face.outer();
        for (&a, &b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            heights.insert(a, height(a));
            arcs.insert([a.min(b), a.max(b)]);
        }
    }
    let at = |point: u32| border.points()[point as usize] + LIFT;
    for &[a, b] in &arcs {
        pen.bar(at(a), at(b), BAR, INK);
    }
    for (&node, &height) in heights.iter().filter(|(_, height)| NEAR < **height) {
        let others =
            arcs.iter().filter(|arc| arc.contains(&node)).map(|arc| heights[&arc[usize::from(arc[0] == node)]]);
        let (mut before, mut after, mut level) = (0, 0, 0);
        for other in others {
            match other - height {
                rise if rise < -NEAR => before += 1,
                rise if NEAR < rise => after += 1,
                _ => level += 1,
            }
        }
        let paint = match (before, after, level) {
            (2, 1, 0) => GREEN,
            (1, 2, 0) => RED,
            (3, 0, 0) => BLUE,
            _ => ORANGE,
        };
        pen.dot(at(node), DOT, paint);
    }
    Ok(pen)
}

/// Heights that differ by less are equal.
const NEAR: f64 = 1e-6;

/// The edges of a face, in their order.
fn sides(shape: &Shape) -> Vec<(DVec3, DVec3)> {
    rings(&flat(shape)).iter().flat_map(|ring| edges(ring).collect::<Vec<_>>()).collect()
}
