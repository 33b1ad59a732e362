//! A building with two towers, a window and a shaft, cut by four planes.

use std::error::Error;
use std::sync::Arc;

use cga::glam::DVec3;
use cga::mesh::{FaceRef, FaceTag};
use cga::sink::picture::Camera;
use cga::{Axis, Mesh, MeshBuilder};
use cga_runtime::geometry::cut;

use crate::pen::{BLUE, GREEN, INK, ORANGE, Paint, Pen, RED, STONE, edges, hue, places, rings};
use crate::sheet::Cell;

/// The heights of the planes. The second plane contains the lower roof.
const PLANES: [f64; 4] = [1.5, 3.0, 4.6, 6.2];

/// The width of bars and dots.
const BAR: f64 = 0.07;
const DOT: f64 = 0.3;

/// The depth of the building.
const DEPTH: f64 = 4.0;

/// The front from the lower left corner on, and the window in it, as (x, y).
const FRONT: [[f64; 2]; 8] =
    [[0.0, 0.0], [12.0, 0.0], [12.0, 7.4], [8.0, 5.6], [8.0, 3.0], [4.0, 3.0], [4.0, 8.0], [0.0, 8.0]];
const WINDOW: [[f64; 2]; 4] = [[5.0, 0.7], [5.0, 2.3], [7.0, 2.3], [7.0, 0.7]];

/// The shaft in the left tower, from the ground to the roof, as (x, z).
const SHAFT: [[f64; 2]; 4] = [[1.2, 1.2], [1.2, 2.8], [2.8, 2.8], [2.8, 1.2]];

fn building() -> Result<Mesh, Box<dyn Error>> {
    let mut builder = MeshBuilder::new();
    let mut ring =
        |corners: &[[f64; 2]], z: f64| -> Vec<u32> { corners.iter().map(|&[x, y]| builder.point([x, y, z])).collect() };
    let [front, back] = [DEPTH, 0.0].map(|z| [ring(&FRONT, z), ring(&WINDOW, z)]);
    let mut shaft = |y: f64| SHAFT.map(|[x, z]| builder.point([x, y, z]));
    let [floor, roof] = [0.0, 8.0].map(&mut shaft);
    let turned = |ring: &[u32]| ring.iter().rev().copied().collect::<Vec<u32>>();
    builder.face(&front[0], &[&front[1]], FaceTag::PLAIN);
    builder.face(&turned(&back[0]), &[&turned(&back[1])], FaceTag::PLAIN);
    for (front, back) in front.iter().zip(&back) {
        for at in 0..front.len() {
            let next = (at + 1) % front.len();
            let side = [back[at], back[next], front[next], front[at]];
            // The ground and the roof of the left tower have the shaft as a hole.
            let (ground, top) = (floor.to_vec(), turned(&roof));
            let hole = match (front.len(), at) {
                (8, 0) => Some(&ground),
                (8, 6) => Some(&top),
                _ => None,
            };
            let holes: Vec<&[u32]> = hole.into_iter().map(Vec::as_slice).collect();
            builder.face(&side, &holes, FaceTag::PLAIN);
        }
    }
    for at in 0..4 {
        let next = (at + 1) % 4;
        builder.polygon(&[floor[next], floor[at], roof[at], roof[next]]);
    }
    Ok(builder.build()?)
}

/// The picture's cells, one for each group of steps.
pub(crate) fn cells() -> Result<Vec<Cell>, Box<dyn Error>> {
    let mesh = Arc::new(building()?);
    assert!(mesh.is_closed() && 0.0 < mesh.volume(), "a solid");
    let slabs = cut::slabs(&mesh, Axis::Y, &PLANES);
    let parts: Vec<Arc<Mesh>> = slabs.parts.into_iter().flatten().collect();
    assert!(parts.iter().all(|part| part.is_closed()), "closed parts");
    let view = |pen: Pen, caption: &str| Cell {
        camera: Camera { margin: 0.03, ..Camera::auto(pen.model.bounds()) }
            .looking_from(28.0, 24.0)
            .field_of_view(14.0),
        model: pen.model,
        borders: true,
        caption: caption.to_owned(),
    };
    Ok(vec![
        view(classes(&mesh), CLASSES),
        view(crossings(&mesh, &parts), CROSSINGS),
        Cell {
            camera: Camera::auto(mesh.bounds()).looking_from(0.0, 0.0).orthographic(),
            ..view(pieces(&parts), PIECES)
        },
        view(contours(&parts), CONTOURS),
        view(caps(&parts), CAPS),
        view(exploded(&parts), PARTS),
    ])
}

const CLASSES: &str =
    "A  planes 0 to 3 and points: red on a plane, else the\n   colour of the slab; a roof lies in plane 1";
const CROSSINGS: &str = "B  crossings: one point for each edge and plane,\n   shared by all faces and both sides";
const PIECES: &str = "C  the front, concave with a hole, in pieces;\n   edges in planes are red";
const CONTOURS: &str =
    "D  contours: edges in a plane without a partner;\n   outlines blue, holes orange; the roof is green";
const CAPS: &str = "E  nesting and caps: each hole belongs to the\n   smallest outline around it";
const PARTS: &str = "F  parts, pulled apart: caps are orange, the roof\n   in plane 1 closes the part below it";

fn is_cap(face: &FaceRef<'_>) -> bool {
    face.tag().cap
}

fn outline_all(pen: &mut Pen, mesh: &Mesh) {
    rings(mesh).iter().for_each(|ring| pen.ring(ring, 0.4 * BAR, INK, DVec3::ZERO));
}

/// The slab at a height; `None` at a plane.
fn slab(y: f64) -> Option<usize> {
    (!PLANES.contains(&y)).then(|| PLANES.partition_point(|&plane| plane < y))
}

fn classes(mesh: &Arc<Mesh>) -> Pen {
    let mut pen = Pen::default();
    pen.mesh(mesh, STONE, DVec3::ZERO);
    planes(&mut pen);
    for &point in mesh.points() {
        let strong = |paint: Paint| paint.map(|channel| channel * channel * 0.9);
        pen.dot(point, DOT, slab(point.y).map_or(RED, |slab| strong(hue(slab))));
    }
    pen
}

/// A frame around the building at each height.
fn planes(pen: &mut Pen) {
    for y in PLANES {
        let corners = [[-0.7, -0.7], [12.7, -0.7], [12.7, DEPTH + 0.7], [-0.7, DEPTH + 0.7]];
        pen.ring(&corners.map(|[x, z]| DVec3::new(x, y, z)), 0.5 * BAR, RED, DVec3::ZERO);
    }
}

fn crossings(mesh: &Arc<Mesh>, parts: &[Arc<Mesh>]) -> Pen {
    let mut pen = Pen::default();
    pen.mesh(mesh, STONE, DVec3::ZERO);
    outline_all(&mut pen, mesh);
    for part in parts {
        let made = part.points().iter().filter(|point| !mesh.points().contains(point));
        made.for_each(|&point| pen.dot(point, DOT, RED));
    }
    pen
}

fn pieces(parts: &[Arc<Mesh>]) -> Pen {
    let mut pen = Pen::default();
    for (number, part) in parts.iter().enumerate() {
        let front = part.faces().filter(|face| 0.9 < face.normal().z && face_depth(part, face) == DEPTH);
        for face in front {
            pen.faces([face], part, hue(number), DVec3::ZERO);
            for ring in face.loops() {
                for (from, to) in edges(&places(part, ring)) {
                    let along_plane = from.y == to.y && PLANES.contains(&from.y);
                    pen.bar(from, to, BAR, if along_plane { RED } else { INK });
                }
            }
        }
    }
    pen
}

fn face_depth(mesh: &Mesh, face: &FaceRef<'_>) -> f64 {
    mesh.points()[face.outer()[0] as usize].z
}

/// The caps that look up, at the upper ends of the slabs, each with its part.
fn upward(parts: &[Arc<Mesh>]) -> impl Iterator<Item = (&Arc<Mesh>, FaceRef<'_>)> {
    parts.iter().flat_map(|part| {
        part.faces().filter(|face| is_cap(face) && 0.0 < face.normal().y).map(move |face| (part, face))
    })
}

/// The distance by which planes are pulled apart.
const APART: f64 = 1.0;

fn lift(y: f64) -> DVec3 {
    DVec3::Y * (APART * PLANES.partition_point(|&plane| plane < y) as f64)
}

fn contours(parts: &[Arc<Mesh>]) -> Pen {
    let mut pen = Pen::default();
    for (part, face) in upward(parts) {
        for (number, ring) in face.loops().enumerate() {
            let ring = places(part, ring);
            let by = lift(ring[0].y);
            for (from, to) in edges(&ring) {
                pen.arrow(from + by, to + by, 1.3 * BAR, if number == 0 { BLUE } else { ORANGE });
            }
        }
    }
    roofs(&mut pen, parts);
    pen
}

/// The faces in planes.
fn roofs(pen: &mut Pen, parts: &[Arc<Mesh>]) {
    for part in parts {
        let in_plane = |face: &FaceRef<'_>| {
            !is_cap(face) && face.outer().iter().all(|&corner| slab(part.points()[corner as usize].y).is_none())
        };
        for face in part.faces().filter(|face| in_plane(face) && 0.9 < face.normal().y) {
            let by = lift(part.points()[face.outer()[0] as usize].y);
            pen.faces([face], part, GREEN, by);
        }
    }
}

fn caps(parts: &[Arc<Mesh>]) -> Pen {
    let mut pen = Pen::default();
    for (part, face) in upward(parts) {
        let by = lift(places(part, face.outer())[0].y);
        pen.faces([face], part, [0.93, 0.62, 0.30], by);
        face.loops().for_each(|ring| pen.ring(&places(part, ring), 0.6 * BAR, INK, by));
    }
    roofs(&mut pen, parts);
    pen
}

fn exploded(parts: &[Arc<Mesh>]) -> Pen {
    let mut pen = Pen::default();
    for (number, part) in parts.iter().enumerate() {
        let by = DVec3::Y * (1.6 * number as f64);
        pen.faces(part.faces().filter(|face| !is_cap(face)), part, hue(number), by);
        pen.faces(part.faces().filter(is_cap), part, [0.93, 0.62, 0.30], by);
    }
    pen
}
