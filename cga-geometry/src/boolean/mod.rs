//! Boolean operations on meshes.
//!
//! All faces of both operands are divided where they meet, until they only meet in common edges and points (`meeting`,
//! `noding`, `cell`). Faces that coincide become one (`sheet`). Each side of each face is then inside or outside of each
//! operand (`winding`, `surface`), and the faces between the inside and the outside of the result are the result
//! (`selection`). Parts of one face that are connected become one polygon again (`polygon`).
//!
//! Distances up to an epsilon, which is relative to the extent, count as rounding errors: points are merged, and edges are led
//! through points near them. Afterwards everything goes by the identity of points. Every step checks what it has found: areas
//! add up, the numbers of solids around all wedges of space agree, and the result of closed operands is closed. If a check
//! fails, the operation is repeated with another epsilon.

mod assembly;
mod budget;
mod cell;
mod component_tags;
mod edge_table;
mod face_values;
mod facet;
mod growing_lists;
mod lists;
mod meeting;
mod noding;
mod operation;
mod plane_group;
mod point_set;
mod polygon;
mod progress;
mod ray;
mod rim;
mod selection;
mod sheet;
mod shell;
mod straight;
mod surface;
mod winding;

use glam::{DAffine3, DVec3};

use super::mesh::join::join;
use super::mesh::{Bounds, Mesh};
use super::tol::{BOOLEAN_EPSILONS, THINNEST_SOLID};
use crate::bounds_tree::{BoundsTree, overlap};
use crate::each::Each;
use crate::small_sort::SmallSort;
use crate::unbent::bent_along;
use assembly::Assembly;
use budget::Budget;
use component_tags::{EdgeTags, vertex_tags};
use edge_table::{EdgeOwner, EdgeTable};
use facet::{Facet, Outlines};
use meeting::FacetMeeting;
pub use operation::{BooleanError, BooleanOp};
use plane_group::PlaneGroups;
use point_set::PointSet;
use polygon::PolygonMaker;
use progress::{ask, goes_on};
use ray::RayCaster;
use sheet::Sheets;
use shell::{Shell, ShellKind, close_shells, shells};
use winding::Windings;

/// The result of an operation on meshes in the same coordinates. The parts of an operand are united first. `rounding` is the
/// largest rounding error of coordinates, in metres; 0 if they are exact. It must be small beside the size of the meshes.
///
/// The faces of the first operand come first. A face keeps its group, its material, its tags and the values of corners; where
/// faces coincide, the first face keeps its own, with the tags of all. The result of closed operands is closed.
///
/// Pairs of faces are found by a tree of their boxes. The time and the memory grow with the faces, and with the pairs that
/// meet, up to a limit.
///
/// # Errors
/// - [`BooleanError::NotFinite`] if a coordinate or `rounding` is NaN or infinite;
/// - [`BooleanError::TooMany`] if the limit on time or memory is reached, which takes a few seconds and up to 0.6 GB;
/// - [`BooleanError::Tangled`] if faces that are nearly at one place cannot be told apart, or if `rounding` is more than a
///   hundredth of the size.
///
/// Faces must be planar: see [`planar_faces`](crate::unbent::planar_faces).
///
/// ```
/// use cga_geometry::boolean::{BooleanOp, combine};
/// use cga_geometry::glam::{DAffine3, DVec3};
/// use cga_geometry::primitive;
///
/// // Two cubes with sides of 1 that share a cube with sides of 0.5.
/// let cube = primitive::cube();
/// let other = cube.map(&DAffine3::from_translation(DVec3::splat(0.5)));
/// let volume = |op| combine(op, [&[cube.clone()], &[other.clone()]], 0.0).map(|made| made.volume());
/// assert_eq!(volume(BooleanOp::Intersect), Ok(0.125));
/// assert_eq!(volume(BooleanOp::Subtract), Ok(0.875));
/// assert_eq!(volume(BooleanOp::Union), Ok(1.875));
/// ```
pub fn combine(op: BooleanOp, operands: [&[Mesh]; 2], rounding: f64) -> Result<Mesh, BooleanError> {
    if 1 < operands.into_iter().flatten().filter(|mesh| mesh.bent != DVec3::ZERO).count() {
        let mut direction = DVec3::ZERO;
        let mut along = |mesh: &Mesh| bent_along(mesh.clone(), &mut direction);
        let [first, second]: [Vec<Mesh>; 2] = operands.map(|meshes| meshes.iter().map(&mut along).collect());
        return combine_within(Budget::DEFAULT, op, [&first, &second], rounding);
    }
    combine_within(Budget::DEFAULT, op, operands, rounding)
}

/// The largest rounding error, relative to the extent.
const LARGEST_ROUNDING: f64 = 1e-2;

fn combine_within(
    mut budget: Budget,
    op: BooleanOp,
    operands: [&[Mesh]; 2],
    rounding: f64,
) -> Result<Mesh, BooleanError> {
    let all = operands.into_iter().flatten();
    let mesh = join(all);
    let mut mesh_of_face = Vec::with_capacity(mesh.face_count());
    for (number, part) in (0..).zip(operands.into_iter().flatten()) {
        mesh_of_face.resize(mesh_of_face.len() + part.face_count(), number);
    }
    if mesh.is_empty() {
        return Ok(Mesh::default());
    }
    if !rounding.is_finite() || !mesh.points().iter().all(|point| point.is_finite()) {
        return Err(BooleanError::NotFinite);
    }
    let is_closed: Vec<bool> = operands.into_iter().flatten().map(Mesh::is_closed).collect();
    let firsts = operands[0].len() as u32;
    let bounds = mesh.bounds();
    let scale = bounds.scale_to_one();
    let size = (bounds.high * scale - bounds.low * scale).max_element();
    // All points would be one.
    if LARGEST_ROUNDING * size < rounding * scale {
        return Err(BooleanError::Tangled);
    }
    let thinnest = THINNEST_SOLID * size + 16.0 * rounding * scale;
    for (epsilon, is_repeated) in BOOLEAN_EPSILONS.into_iter().zip([false, true, true, true]) {
        let epsilon = (epsilon * size).max(16.0 * rounding * scale);
        let input = Input {
            mesh: &mesh,
            mesh_of_face: &mesh_of_face,
            is_closed: &is_closed,
            operands,
            thinnest,
            firsts,
            scale,
            epsilon,
        };
        match input.result(op, &mut budget) {
            Err(BooleanError::Tangled) => {}
            // The work that failed before is not the reason.
            Err(BooleanError::TooMany) if is_repeated => break,
            made => return made,
        }
    }
    Err(BooleanError::Tangled)
}

/// The faces of all operands as one mesh.
struct Input<'m> {
    mesh: &'m Mesh,
    /// The number of the mesh to which each face belongs.
    mesh_of_face: &'m [u32],
    /// True for each mesh without border edges.
    is_closed: &'m [bool],
    operands: [&'m [Mesh]; 2],
    /// Closed meshes that are thinner are flat areas.
    thinnest: f64,
    /// The number of meshes of the first operand.
    firsts: u32,
    /// Coordinates are scaled to about 1.
    scale: f64,
    epsilon: f64,
}

impl Input<'_> {
    /// Returns true if a mesh without border edges is thicker than rounding errors.
    fn has_solid(&self) -> bool {
        let is_thick = |mesh: &Mesh| {
            let scaled = mesh.map(&DAffine3::from_scale(DVec3::splat(self.scale)));
            mesh.is_closed() && self.thinnest * scaled.area() < scaled.volume().abs()
        };
        self.operands.into_iter().flatten().any(is_thick)
    }

    fn result(&self, op: BooleanOp, budget: &mut Budget) -> Result<Mesh, BooleanError> {
        let bounds = self.mesh.bounds();
        let middle = bounds.low * 0.5 + bounds.high * 0.5;
        let mut points = PointSet::new(self.epsilon);
        let mut numbers = Vec::with_capacity(self.mesh.points().len());
        for point in self.mesh.points() {
            goes_on(1)?;
            numbers.push(points.number((*point - middle) * self.scale));
        }
        let outlines = Outlines::of(self.mesh, &points, &numbers)?;
        let mut facets = outlines.facets(&points)?;
        let mesh_of: Vec<u32> = facets.iter().map(|facet| self.mesh_of_face[facet.face as usize]).collect();
        let operands: Vec<u8> = mesh_of.iter().map(|mesh| u8::from(self.firsts <= *mesh)).collect();
        let mut edges = outline_edges(&points, &facets)?;
        let mut shells = shells(&points, &edges, &facets, &mesh_of)?;
        let boxes: Vec<Bounds> = facets.iter().map(|facet| facet.bounds).collect();
        let tree = BoundsTree::of(&boxes);
        let overlapping = meet_all(&mut points, &mut edges, &facets, &tree, budget)?;
        let groups = PlaneGroups::of(&points, &mut edges, &mut facets, &overlapping, budget)?;
        let divided = noding::divide_edges(&mut points, &mut edges, &facets, &groups, budget);
        budget.spend_edges(&edges);
        divided?;
        let mut cells = groups.cells(&points, &edges, &facets, budget)?;
        facets.truncate(mesh_of.len());
        close_shells(&edges, &facets, &mesh_of, &mut shells)?;
        if shells.iter().any(|shell| !shell.is_closed && self.is_closed[mesh_of[shell.facets[0] as usize] as usize]) {
            // Faces that are thinner than epsilon were left out.
            return Err(BooleanError::Tangled);
        }
        for facet in (0..facets.len() as u32).filter(|facet| !groups.is_member(*facet)) {
            cells.add_facet(&points, &edges, facet, &facets[facet as usize], budget)?;
        }
        let sheets = Sheets::of(&edges, &facets, cells)?;
        let mut kinds = vec![ShellKind::Open; facets.len()];
        let closed = shells.iter().filter(|shell| shell.is_closed).flat_map(|shell| &shell.facets);
        closed.for_each(|facet| kinds[*facet as usize] = ShellKind::Closed);
        let inverted = inverted_shells(&points, &facets, &tree, &kinds, &sheets, &mesh_of, &shells, budget)?;
        inverted.into_iter().for_each(|facet| kinds[facet as usize] = ShellKind::Inverted);
        let rays = RayCaster { points: &points, facets: &facets, tree: &tree, kinds: &kinds, operands: &operands };
        let is_flat = is_flat(&points, &facets);
        if is_flat && self.has_solid() {
            // A solid that is thinner than epsilon.
            return Err(BooleanError::Tangled);
        }
        let chosen = if is_flat {
            selection::choose_in_plane(op, &sheets, &rays)
        } else {
            let windings = Windings::of(&sheets, &rays, budget)?;
            selection::choose(op, &sheets, &rays, &windings, budget)?
        };
        let tags = EdgeTags::new(op, self.mesh, &edges, &facets, &sheets, &operands)?;
        let maker = PolygonMaker {
            points: &points,
            edges: &edges,
            facets: &facets,
            sheets: &sheets,
            tags: &tags,
            chosen: &chosen,
        };
        let mut polygons = maker.polygons(budget)?;
        straight::drop_straight(&points, &mut polygons)?;
        ask()?;
        drop(sheets);
        drop(edges);
        ask()?;
        // Points of the mesh keep their coordinates to the bit.
        let mut places: Vec<DVec3> = points.at.iter().map(|place| middle + *place / self.scale).collect();
        for (point, number) in self.mesh.points().iter().zip(&numbers).rev() {
            places[*number as usize] = *point;
        }
        let vertex_tags = vertex_tags(self.mesh, &numbers);
        let assembly = Assembly {
            mesh: self.mesh,
            facets: &facets,
            operands: &operands,
            places: &places,
            edge_tags: &tags,
            vertex_tags: &vertex_tags,
            op,
        };
        let made = assembly.mesh_of(&polygons)?;
        ask()?;
        let must_close = !kinds.contains(&ShellKind::Open) && !is_flat;
        if must_close && !made.is_empty() && !made.is_closed() {
            return Err(BooleanError::Tangled);
        }
        ask()?;
        let is_union = matches!(op, BooleanOp::Union | BooleanOp::Unify) && 1 < self.is_closed.len();
        if must_close && is_union && made.scaled_volume(self.scale) < self.least_union(&shells, &mesh_of) {
            // The volume of a part is returned where the work is to end.
            ask()?;
            // Something of an operand is missing.
            return Err(BooleanError::Tangled);
        }
        Ok(made)
    }

    /// A volume that no union of these closed shells is below, in scaled coordinates: of the mesh that encloses most, the largest
    /// shell without all cavities.
    fn least_union(&self, shells: &[Shell], mesh_of: &[u32]) -> f64 {
        const ROUNDING: f64 = 1e-6;
        let mut volumes = vec![[0.0_f64; 2]; self.is_closed.len()];
        for shell in shells {
            let [largest, cavities] = &mut volumes[mesh_of[shell.facets[0] as usize] as usize];
            *largest = largest.max(shell.volume / 6.0);
            *cavities += (-shell.volume / 6.0).max(0.0);
        }
        volumes.iter().map(|[largest, cavities]| largest - cavities).fold(0.0, f64::max) * (1.0 - ROUNDING)
    }
}

/// The edges of the outlines of facets.
fn outline_edges(points: &PointSet, facets: &[Facet<'_>]) -> Result<EdgeTable, BooleanError> {
    let mut edges = EdgeTable::default();
    for (number, facet) in (0..).zip(facets) {
        let corners = facet.rings.corners;
        goes_on(2 * corners.len())?;
        for edge in facet.rings.rim() {
            let [a, b] = edge.each(|corner| points.at[corners[corner] as usize]);
            let owner = EdgeOwner { facet: number, count: 1, corner: edge[0] as u32 };
            edges.add(edge.each(|corner| corners[corner]), b - a, owner);
        }
    }
    Ok(edges)
}

/// Adds the lines in which facets meet. Returns the pairs that overlap in one plane.
fn meet_all(
    points: &mut PointSet,
    edges: &mut EdgeTable,
    facets: &[Facet<'_>],
    tree: &BoundsTree,
    budget: &mut Budget,
) -> Result<Vec<[u32; 2]>, BooleanError> {
    let mut meeting = FacetMeeting::default();
    let mut near = Vec::new();
    for number in 0..facets.len() as u32 {
        let bounds = facets[number as usize].bounds;
        near.clear();
        tree.visit(
            |other| overlap(other, &bounds),
            |other| {
                if number < other && overlap(&facets[other as usize].bounds, &bounds) {
                    near.push(other);
                }
                true
            },
        );
        near.small_sort();
        for &other in &near {
            meeting.meet(points, edges, facets, [number, other], budget)?;
            budget.check(edges, points)?;
        }
    }
    Ok(meeting.overlapping)
}

/// Returns true if all facets lie in one plane.
fn is_flat(points: &PointSet, facets: &[Facet<'_>]) -> bool {
    let Some(first) = facets.first() else { return true };
    let is_on_plane = |point: &u32| first.height(points.at[*point as usize]).abs() <= 2.0 * points.epsilon;
    facets.iter().all(|facet| facet.rings.corners.iter().all(is_on_plane))
}

/// The facets of closed shells that look inwards and are not cavities in another shell of their mesh.
#[expect(clippy::too_many_arguments, reason = "the parts of an arrangement")]
fn inverted_shells(
    points: &PointSet,
    facets: &[Facet<'_>],
    tree: &BoundsTree,
    kinds: &[ShellKind],
    sheets: &Sheets,
    mesh_of: &[u32],
    shells: &[Shell],
    budget: &mut Budget,
) -> Result<Vec<u32>, BooleanError> {
    let looks_inwards = |shell: &&Shell| shell.is_closed && shell.volume < -points.epsilon;
    if !shells.iter().any(|shell| looks_inwards(&shell)) {
        return Ok(Vec::new());
    }
    // A sheet of each facet. Facets of several shells may have it.
    let mut sheet_of = vec![None; facets.len()];
    for sheet in sheets.iter() {
        sheet.sources.iter().for_each(|source| sheet_of[source.facet as usize] = Some(sheet));
    }
    let mut shell_of = vec![0; facets.len()];
    for (number, shell) in shells.iter().enumerate() {
        shell.facets.iter().for_each(|facet| shell_of[*facet as usize] = number);
    }
    let none = vec![0; facets.len()];
    let rays = RayCaster { points, facets, tree, kinds, operands: &none };
    let mut found = Vec::new();
    for shell in shells.iter().filter(looks_inwards) {
        let first = shell.facets[0] as usize;
        let is_other =
            |facet: u32| mesh_of[facet as usize] == mesh_of[first] && shell_of[facet as usize] != shell_of[first];
        let around = sheet_of[first].map_or(Ok([0; 2]), |sheet| rays.around_front(sheet, is_other, budget))?;
        if around[0] <= 0 {
            found.extend(&shell.facets);
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests;
