//! Bends an asset along the texture coordinates of a surface.
//!
//! The asset is stretched to a cell of texture space: its x is along u in [0, 1], its z is against v, and its y is the
//! height. It is repeated in each cell that a face of the carrier covers, cut at the edges of the face, and mapped to
//! the surface by the inverse of the face's coordinates. A triangle has an affine inverse. A quad whose coordinates are
//! a parallelogram has a bilinear inverse, so edges along u and v stay straight. Any other quad is divided into two
//! triangles.
//!
//! Faces with a common edge and equal coordinates there make the same points on it, bit for bit: crossings are computed
//! from ends in lexicographic order, and mapped to the surface by the edge alone. A polygon above a common edge belongs
//! to one of the faces. There are no caps: the asset is open where the border of the carrier cuts it.

mod clip;
mod patch;
mod unit;

use glam::DVec3;

use crate::mesh::{FaceTag, Mesh, MeshBuilder, TooManyCorners, flip, unit as unit_vector};
use crate::tol::PLANAR_EPSILON;
use crate::vector::area_vector;
use crate::work;
use clip::{Clip, ClipVertex};
use patch::{Patches, UvPatch};
use unit::UnitAsset;

/// The direction of an asset's height on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeightDirection {
    /// The y axis of the carrier's coordinates, for `scope.y`.
    ScopeY,
    /// The normals of the points of the carrier, which its faces interpolate, for `vertex.normal`.
    VertexNormal,
}

/// The alignment of an asset in the direction of the height.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum HeightAlignment {
    /// The lowest point of the asset is on the surface.
    AlignPosition,
    /// The origin of the asset is on the surface.
    KeepPosition,
}

/// The parameters of [`insert_along_uv`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AlongUv {
    /// The texture set of the carrier.
    pub set: usize,
    /// The height of the asset in metres. A negative height points inwards; 0 makes the asset flat.
    pub height: f64,
    /// The direction of the height.
    pub direction: HeightDirection,
    /// The position of height 0.
    pub alignment: HeightAlignment,
    /// The rounding errors of the carrier's positions, in metres, for coordinates that were computed from positions. A copy ends at a
    /// whole number that is not farther away on the surface.
    pub rounding: f64,
}

/// Puts the asset on the triangles and quads of a carrier, both in metres. Faces with more corners, with holes, or
/// without an area in texture space are skipped. A carrier without the set gives nothing.
///
/// Faces keep the groups, the materials and the texture coordinates of the asset; normals and tags are dropped. Faces
/// that would look inwards, because the height is negative or the coordinates are mirrored, are reversed. Faces of the
/// asset that are not convex are divided into triangles, and so are pieces that are no longer planar. An asset without
/// extent in x or z is in the middle of its cell. An asset without extent in y keeps its own height above the surface
/// with [`HeightAlignment::KeepPosition`].
///
/// # Errors
/// An error if the result would have more than `most` corners, or if far more corners must be visited. A result with
/// coordinates that overflow is empty, and so is the result of work that is to end.
pub fn insert_along_uv(carrier: &Mesh, asset: &Mesh, options: &AlongUv, most: usize) -> Result<Mesh, TooManyCorners> {
    let too_many = TooManyCorners { most };
    let mut made = MappedMesh { builder: MeshBuilder::new(), asset, corners: 0 };
    made.builder.groups(asset.groups.clone()).materials(asset.materials.clone());
    let unit = UnitAsset::of(asset, options);
    let patches = if unit.polygons.is_empty() { Patches::default() } else { Patches::of(carrier, options) };
    let (mut clip, mut looked_at) = (Clip::new(asset), 0usize);
    for (number, patch) in patches.list.iter().enumerate() {
        let turns_over = patch.is_mirrored != (options.height < 0.0);
        for row in patch.rows(most)? {
            for cell in patch.cells(row, most)? {
                if !work::spend(CUTTING * unit.corners.len()) {
                    return Ok(Mesh::default());
                }
                looked_at = looked_at.saturating_add(unit.corners.len());
                if most.saturating_mul(LOOKS) < looked_at {
                    return Err(too_many);
                }
                for polygon in &unit.polygons {
                    if !patch.may_meet(polygon.extent.low + cell, polygon.extent.high + cell) {
                        continue;
                    }
                    let Some(wall) = clip.cut(&unit, polygon, cell, patch) else { continue };
                    if wall.is_some_and(|edge| !patches.owns_wall(number, edge, cell)) {
                        continue;
                    }
                    made.add(&clip, patch, polygon.face, turns_over);
                    if most < made.corners {
                        return Err(too_many);
                    }
                }
            }
        }
    }
    Ok(made.builder.build_in_time().ok().flatten().unwrap_or_default())
}

/// The limit on visited corners of the asset per corner of the result. Small faces of a carrier use few of the visited
/// corners.
const LOOKS: usize = 64;

/// The units of work of a corner that is compared with a face of the carrier.
const CUTTING: usize = 16;

/// The mesh under construction.
struct MappedMesh<'a> {
    builder: MeshBuilder,
    asset: &'a Mesh,
    corners: usize,
}

impl MappedMesh<'_> {
    /// Adds a piece of a face of the asset.
    fn add(&mut self, clip: &Clip<'_>, patch: &UvPatch, face: usize, turns_over: bool) {
        let mut nodes: Vec<(DVec3, &ClipVertex)> = clip.nodes.iter().map(|node| (node.place(patch), node)).collect();
        nodes.dedup_by_key(|node| node.0);
        while nodes.len() > 1 && nodes[0].0 == nodes[nodes.len() - 1].0 {
            nodes.pop();
        }
        if nodes.len() < 3 {
            return;
        }
        if turns_over {
            flip(&mut nodes);
        }
        let tag = FaceTag { tags: FaceTag::NONE, ..self.asset.tags[face].uncapped() };
        if is_planar(&nodes) {
            self.face(clip, &nodes, tag);
        } else {
            (2..nodes.len()).for_each(|at| self.face(clip, &[nodes[0], nodes[at - 1], nodes[at]], tag));
        }
    }

    fn face(&mut self, clip: &Clip<'_>, nodes: &[(DVec3, &ClipVertex)], tag: FaceTag) {
        self.corners += nodes.len();
        let corners: Vec<u32> = nodes.iter().map(|(point, _)| self.builder.point(*point)).collect();
        self.builder.face(&corners, &[], tag);
        for (at, &set) in clip.sets.iter().enumerate() {
            let uvs: Vec<_> = nodes.iter().map(|(_, node)| clip.carried(node)[at]).collect();
            self.builder.uv_set(set, &uvs);
        }
    }
}

/// Returns true if the corners of a piece are in one plane, except for rounding.
fn is_planar(nodes: &[(DVec3, &ClipVertex)]) -> bool {
    if nodes.len() == 3 {
        return true;
    }
    let from = nodes[0].0;
    let normal = unit_vector(area_vector([nodes.iter().map(|node| node.0)].into_iter()));
    let (off, size) = nodes.iter().fold((0.0, 0.0), |(off, size): (f64, f64), (point, _)| {
        (off.max((*point - from).dot(normal).abs()), size.max((*point - from).length()))
    });
    off <= PLANAR_EPSILON * size
}

#[cfg(test)]
mod tests;
