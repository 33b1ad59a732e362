//! Extrudes edges to faces.
//!
//! Each edge gives one face, which begins with the edge. Edges that are extruded along their own normals separate where
//! they meet at an angle. Edges that are extruded along the normals of their points, or along one vector, stay
//! connected. A face has the tags of its edge, an upright edge the tags of its vertex.

use glam::DVec3;

use super::extrude::{Extrude, flat_top};
use crate::each::Each;
use crate::mesh::{FaceTag, Mesh, MeshBuilder, MeshError, TagSet, TagSetTable, unit};
use crate::provenance::Extruded;
use crate::wire::Wire;

/// The faces on the edges of a wire, by a distance in metres. Edges without a normal are not extruded along it.
///
/// # Errors
/// An error if a coordinate overflows, or if an edge has a point that does not exist: its number takes the place of the face's.
///
/// ```
/// use cga_geometry::extrude::Extrude;
/// use cga_geometry::extrude_wire::extrude_wire;
/// use cga_geometry::glam::DVec3;
/// use cga_geometry::wire::Wire;
///
/// let wall = extrude_wire(&Wire::edge(4.0), Extrude::Vector(DVec3::Y), 3.0)?;
/// assert_eq!(wall.area(), 12.0);
/// # Ok::<(), cga_geometry::mesh::MeshError>(())
/// ```
pub fn extrude_wire(wire: &Wire, along: Extrude, distance: f64) -> Result<Mesh, MeshError> {
    let count = wire.points.len();
    for (face, edge) in wire.edges.iter().enumerate() {
        if let Some(&index) = edge.iter().find(|&&end| count <= end as usize) {
            return Err(MeshError::OutOfRange { face, index });
        }
    }
    let at_points: Vec<DVec3> = match along {
        Extrude::FaceNormal => Vec::new(),
        Extrude::VertexNormal => point_normals(wire).into_iter().map(|normal| normal * distance).collect(),
        Extrude::Vector(vector) => vec![vector * distance; wire.points.len()],
        Extrude::FlatTop(vector) => flat_top(&wire.points, vector, distance),
    };
    let (mut builder, mut sets) = (MeshBuilder::new(), TagSetTable::default());
    let side = TagSet::new([Extruded::Outer.tag()]);
    let low: Vec<u32> = wire.points.iter().map(|&point| builder.point(point)).collect();
    for (edge, normal) in wire.edges.iter().zip(&wire.normals) {
        let way = |point: u32| at_points.get(point as usize).copied().unwrap_or(*normal * distance);
        if edge.iter().all(|&point| way(point) == DVec3::ZERO) {
            continue;
        }
        let [a, b] = *edge;
        let [high_a, high_b] = [a, b].each(|point| builder.point(wire.points[point as usize] + way(point)));
        let face = [low[a as usize], low[b as usize], high_b, high_a];
        let own = wire.tags.edge(*edge);
        let tags = sets.number(&own.map_or_else(|| side.clone(), |own| own.union(&side)));
        builder.face(&face, &[], FaceTag { tags, ..FaceTag::PLAIN });
        if let Some(own) = own {
            builder.edge_tags([face[0], face[1]], own);
        }
        for (point, [low, high]) in [(a, [face[0], face[3]]), (b, [face[1], face[2]])] {
            if let Some(own) = wire.tags.vertex(point) {
                builder.vertex_tags(low, own).edge_tags([low, high], own);
            }
        }
    }
    builder.tag_sets(sets.into_sets());
    builder.build()
}

/// The normals of the points of a wire, one for each: the mean of the normals of the edges at the point, of length 1 or zero.
///
/// # Panics
/// Panics if an edge has a point that does not exist.
pub fn point_normals(wire: &Wire) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; wire.points.len()];
    for (edge, normal) in wire.edges.iter().zip(&wire.normals) {
        edge.iter().for_each(|&end| normals[end as usize] += *normal);
    }
    if wire.edges.is_empty() {
        normals.clone_from(&wire.normals);
    }
    normals.into_iter().map(unit).collect()
}
