//! Shells: the connected parts of meshes, and whether they are closed.

use super::edge_table::EdgeTable;
use super::facet::Facet;
use super::operation::BooleanError;
use super::point_set::PointSet;
use super::progress::{goes_on, sort};
use crate::disjoint::DisjointSets;

/// The part that a facet has in its mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ShellKind {
    /// A part of the outline of a solid.
    Closed,
    /// A part of a closed shell that looks inwards, so it counts the other way round.
    Inverted,
    /// A part of a surface with a border.
    Open,
}

/// The facets of a shell.
pub(super) struct Shell {
    pub(super) facets: Vec<u32>,
    pub(super) is_closed: bool,
    /// Six times the enclosed volume.
    pub(super) volume: f64,
}

/// The shells of meshes. `mesh_of` has the mesh of each facet. The outlines of facets are the only edges yet.
pub(super) fn shells(
    points: &PointSet,
    edges: &EdgeTable,
    facets: &[Facet<'_>],
    mesh_of: &[u32],
) -> Result<Vec<Shell>, BooleanError> {
    let mut sets = DisjointSets::new(facets.len());
    unite_at_edges(edges, mesh_of, &mut sets, |_| true)?;
    let shell = |facets_here: Vec<u32>| {
        let is_closed = is_closed(edges, &facets_here)?;
        let volume = facets_here.iter().map(|facet| volume(points, &facets[*facet as usize])).sum();
        Ok(Shell { is_closed, volume, facets: facets_here })
    };
    sets.sets().into_iter().map(shell).collect()
}

/// Unites open shells of the same mesh that are closed together, because edges of one are parts of edges of the other.
/// The edges are divided where they meet.
pub(super) fn close_shells(
    edges: &EdgeTable,
    facets: &[Facet<'_>],
    mesh_of: &[u32],
    shells: &mut Vec<Shell>,
) -> Result<(), BooleanError> {
    let mut is_open = vec![false; facets.len()];
    let mut sets = DisjointSets::new(facets.len());
    let mut volumes = vec![0.0; facets.len()];
    for shell in shells.iter().filter(|shell| !shell.is_closed) {
        volumes[shell.facets[0] as usize] = shell.volume;
        for facet in &shell.facets {
            is_open[*facet as usize] = true;
            sets.unite(shell.facets[0], *facet);
        }
    }
    unite_at_edges(edges, mesh_of, &mut sets, |facet| is_open[facet as usize])?;
    shells.retain(|shell| shell.is_closed);
    for set in sets.sets().into_iter().filter(|set| is_open[set[0] as usize]) {
        let volume = set.iter().map(|facet| volumes[*facet as usize]).sum();
        shells.push(Shell { is_closed: is_closed(edges, &set)?, facets: set, volume });
    }
    Ok(())
}

/// Unites facets of the same mesh whose outlines have a common edge.
fn unite_at_edges(
    edges: &EdgeTable,
    mesh_of: &[u32],
    sets: &mut DisjointSets,
    counts: impl Fn(u32) -> bool,
) -> Result<(), BooleanError> {
    let mut first: Vec<(u32, u32)> = Vec::new();
    for edge in 0..edges.list.len() as u32 {
        let owners = edges.owners(edge);
        goes_on(owners.len())?;
        first.clear();
        for owner in owners.iter().filter(|owner| owner.count != 0 && counts(owner.facet)) {
            let mesh = mesh_of[owner.facet as usize];
            match first.iter().find(|known| known.0 == mesh) {
                Some((_, facet)) => sets.unite(*facet, owner.facet),
                None => first.push((mesh, owner.facet)),
            }
        }
    }
    Ok(())
}

/// Returns true if the outlines of facets follow each edge equally often in both directions.
fn is_closed(edges: &EdgeTable, shell: &[u32]) -> Result<bool, BooleanError> {
    let mut uses: Vec<(u32, i32)> = Vec::new();
    for &facet in shell {
        let lines = edges.lines(facet);
        goes_on(lines.len())?;
        uses.extend(lines.iter().map(|&line| (line, edges.owner(line, facet).map_or(0, |owner| owner.count))));
    }
    sort(&mut uses)?;
    Ok(uses.chunk_by(|a, b| a.0 == b.0).all(|here| here.iter().map(|used| used.1).sum::<i32>() == 0))
}

/// Six times the signed volume of the pyramid from the origin to a facet.
fn volume(points: &PointSet, facet: &Facet<'_>) -> f64 {
    let at = |point: u32| points.at[point as usize] - facet.origin;
    let fan = facet.rings.edges().map(|[a, b]| at(a).cross(at(b)));
    facet.origin.dot(fan.sum())
}
