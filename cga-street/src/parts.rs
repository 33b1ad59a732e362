//! From pieces to the parts of a network: owners of faces, outlines, meshes with texture coordinates.

use glam::{DVec2, DVec3};

use super::grid::{GridMap, Point, is_sliver};
use super::mesh::{StreetFace, mesh};
use super::outline::faces_of;
use super::pieces::{Chart, JunctionDraft, Plot, StreetPieces};
use super::progress::{EDGE, spend};
use super::subdivision::{NONE, Subdivision};
use super::{Kind, NetworkPart, Side, StreetError};
use cga_geometry::disjoint::DisjointSets;
use cga_geometry::each::Each;
use cga_geometry::small_sort::SmallSort;

/// Three arms make a `Junction` if two of them are straight within this many degrees; otherwise a `Crossing`.
const STRAIGHT_ON: f64 = 30.0;

/// The parts of a network.
pub(super) fn parts(plan: &JunctionDraft, pieces: &StreetPieces) -> Result<Vec<NetworkPart>, StreetError> {
    let rings: Vec<Vec<Point>> = pieces.list.iter().map(Plot::ring).collect();
    let faces = Subdivision::new(&rings)?;
    let owners = owners(pieces, &faces)?;
    let mut loops: Vec<Vec<Vec<Point>>> = vec![Vec::new(); pieces.list.len()];
    for (owner, ring) in faces.outlines(&owners) {
        loops[owner as usize].push(ring);
    }
    let mut heights: GridMap<Point, f64> = GridMap::default();
    // Roadways first: their heights take precedence over the heights of sidewalks, and junctions have the heights around them.
    for order in 0..3 {
        for (at, piece) in pieces.list.iter().enumerate() {
            let (cell, rings) = match (order, piece) {
                (0, Plot::Road { cell, free: true, .. }) | (1, Plot::Walk { cell, .. }) => (cell, &loops[at][..]),
                (2, Plot::Road { cell, free: false, .. }) => (cell, std::slice::from_ref(&rings[at])),
                _ => continue,
            };
            spend(EDGE * rings.iter().map(Vec::len).sum::<usize>())?;
            for &point in rings.iter().flatten() {
                heights.entry(point).or_insert_with(|| cell.value(point).z);
            }
        }
    }
    let mut parts = Vec::new();
    let mut by_run: Vec<Vec<usize>> = vec![Vec::new(); pieces.runs.len()];
    for (at, piece) in pieces.list.iter().enumerate() {
        if let Plot::Road { run, free: true, .. } | Plot::Walk { run, .. } = piece {
            by_run[*run as usize].push(at);
        }
    }
    for (run, list) in pieces.runs.iter().zip(&by_run) {
        parts.extend(street(run, list, pieces, &loops, &heights)?);
    }
    let arms = arms(&owners, plan, pieces, &faces);
    for (owner, loops) in loops.iter().enumerate() {
        if !loops.is_empty() && is_junction(&pieces.list[owner]) {
            let arms = arms.get(&(owner as u32)).map(Vec::as_slice).unwrap_or_default();
            parts.extend(junction(loops, arms, &heights)?);
        }
    }
    Ok(parts)
}

/// The owner of each cycle: the number of a piece. The first piece of a junction owns all its pieces.
fn owners(pieces: &StreetPieces, faces: &Subdivision) -> Result<Vec<u32>, StreetError> {
    let is_free = |&&at: &&u32| matches!(pieces.list[at as usize], Plot::Road { free: true, .. });
    let is_walk = |at: u32| matches!(pieces.list[at as usize], Plot::Walk { .. });
    let owner = |covers: &Vec<u32>| {
        let free = covers.iter().find(is_free);
        let junction = || covers.iter().find(|&&at| !is_walk(at));
        free.or_else(junction).or(covers.first()).copied().unwrap_or(NONE)
    };
    let mut of_cycle: Vec<u32> = faces.covers.iter().map(owner).collect();
    give_slivers_away(&mut of_cycle, faces)?;
    // Pieces that overlap or touch form one junction.
    let is_part = |at: u32| at != NONE && is_junction(&pieces.list[at as usize]);
    let mut junctions = DisjointSets::new(pieces.list.len());
    for (cycle, covers) in faces.covers.iter().enumerate().filter(|(cycle, _)| is_part(of_cycle[*cycle])) {
        covers.iter().filter(|&&other| is_part(other)).for_each(|&other| junctions.unite(of_cycle[cycle], other));
    }
    for half in (0..faces.cycle.len()).step_by(2) {
        let [a, b] = [half, half + 1].each(|half| of_cycle[faces.cycle[half] as usize]);
        if is_part(a) && is_part(b) {
            junctions.unite(a, b);
        }
    }
    junctions.flatten();
    for owner in of_cycle.iter_mut().filter(|owner| is_part(**owner)) {
        *owner = junctions.find(*owner);
    }
    Ok(of_cycle)
}

/// Returns true for a piece that belongs to a junction.
fn is_junction(piece: &Plot) -> bool {
    !matches!(piece, Plot::Walk { .. } | Plot::Road { free: true, .. })
}

/// For each junction the directions of its streets, away from it.
fn arms(owners: &[u32], plan: &JunctionDraft, pieces: &StreetPieces, faces: &Subdivision) -> GridMap<u32, Vec<DVec2>> {
    let mut found: Vec<(u32, u32, bool)> = Vec::new();
    for half in 0..faces.cycle.len() {
        let [here, there] = [half, half ^ 1].each(|half| owners[faces.cycle[half] as usize]);
        if here == NONE || there == NONE || here == there || !is_junction(&pieces.list[here as usize]) {
            continue;
        }
        if let Plot::Road { cell, free: true, .. } = &pieces.list[there as usize] {
            let reach = cell.corners.iter().map(|corner| corner.value.x);
            let middle = reach.clone().sum::<f64>() / cell.corners.len() as f64;
            let [a, b] = faces.ends(half);
            let along = (cell.value(a).x + cell.value(b).x) / 2.0;
            found.push((here, there, along < middle));
        }
    }
    found.small_sort();
    found.dedup();
    let mut arms: GridMap<u32, Vec<DVec2>> = GridMap::default();
    for (junction, road, at_start) in found {
        if let Plot::Road { chain, segment, .. } = pieces.list[road as usize] {
            let along = plan.chains[chain as usize].direction(segment as usize);
            arms.entry(junction).or_default().push(if at_start { along } else { -along });
        }
    }
    arms
}

/// Gives faces that are due to rounding to the owner at their longest edge.
fn give_slivers_away(of_cycle: &mut [u32], faces: &Subdivision) -> Result<(), StreetError> {
    let is_sliver = |cycle: usize| {
        let ring = faces.ring(cycle);
        spend(EDGE * ring.len())?;
        Ok(is_sliver(&ring))
    };
    let is_sliver: Vec<bool> = (0..of_cycle.len()).map(is_sliver).collect::<Result<_, StreetError>>()?;
    let mut longest: GridMap<u32, (f64, u32)> = GridMap::default();
    for (half, &cycle) in faces.cycle.iter().enumerate() {
        let other = faces.cycle[half ^ 1];
        if is_sliver[cycle as usize] && !is_sliver[other as usize] {
            let [a, b] = faces.ends(half);
            let length = a.place().distance(b.place());
            let best = longest.entry(cycle).or_insert((length, other));
            if best.0 < length {
                *best = (length, other);
            }
        }
    }
    for (cycle, (_, other)) in longest {
        of_cycle[cycle as usize] = of_cycle[other as usize];
    }
    Ok(())
}

/// A street or a sidewalk.
fn street(
    run: &Chart,
    list: &[usize],
    pieces: &StreetPieces,
    loops: &[Vec<Vec<Point>>],
    heights: &GridMap<Point, f64>,
) -> Result<Option<NetworkPart>, StreetError> {
    let forward = run.line.is_none_or(|(_, forward)| forward);
    let length = run.along[1] - run.along[0];
    let is_road = run.kind == Kind::Street;
    let coordinates = |value: DVec3| {
        let [from, to] = [value.x - run.along[0], run.along[1] - value.x];
        let (from, to) = if forward { (from, to) } else { (to, from) };
        let across = if is_road && !forward { run.width - value.y } else { value.y };
        [DVec2::new(from / length, across / run.width), DVec2::new(from, across), DVec2::new(to, across)]
    };
    let mut faces = Vec::new();
    let cells: Vec<usize> = if forward { list.to_vec() } else { list.iter().rev().copied().collect() };
    for at in cells {
        let (Plot::Road { cell, .. } | Plot::Walk { cell, .. }) = &pieces.list[at] else { continue };
        // A quad begins with the edge on the right, along the street, or at the kerb.
        let first = if is_road && !forward { cell.corners.len() / 2 } else { 0 };
        let first = cell.corners[first].point;
        for mut rings in faces_of(&loops[at])? {
            if let Some(start) = rings[0].iter().position(|&point| point == first) {
                rings[0].rotate_left(start);
            }
            let uvs = rings.iter().flatten().map(|&point| coordinates(cell.value(point))).collect();
            faces.push(StreetFace { rings, uvs });
        }
    }
    let side = run.side.map(|side| match side {
        Side::Left if !forward => Side::Right,
        Side::Right if !forward => Side::Left,
        side => side,
    });
    let mesh = mesh(&faces, heights, if run.line.is_some() { 3 } else { 1 });
    Ok(mesh.map(|mesh| NetworkPart {
        kind: run.kind,
        side,
        line: run.line.map(|(line, _)| line as usize),
        length,
        width: run.width,
        arms: 0,
        mesh,
    }))
}

/// A junction, with coordinates from 0 to 1 along and across its first arm.
fn junction(
    loops: &[Vec<Point>],
    arms: &[DVec2],
    heights: &GridMap<Point, f64>,
) -> Result<Option<NetworkPart>, StreetError> {
    let along = arms.first().copied().unwrap_or(DVec2::X);
    let flat = |point: Point| {
        let place = point.place();
        DVec2::new(place.dot(along), along.perp_dot(place))
    };
    let all = || loops.iter().flatten().map(|&point| flat(point));
    let low = all().fold(DVec2::INFINITY, DVec2::min);
    let size = all().fold(DVec2::NEG_INFINITY, DVec2::max) - low;
    let face = |rings: Vec<Vec<Point>>| {
        let uvs = rings.iter().flatten().map(|&point| [(flat(point) - low) / size; 3]).collect();
        StreetFace { rings, uvs }
    };
    let faces: Vec<StreetFace> = faces_of(loops)?.into_iter().map(face).collect();
    let least = -libm::cos(STRAIGHT_ON.to_radians());
    let straight = (0..arms.len()).any(|a| arms[a + 1..].iter().any(|b| arms[a].dot(*b) < least));
    let kind = match arms.len() {
        0..=2 => Kind::Joint,
        3 if straight => Kind::Junction,
        _ => Kind::Crossing,
    };
    let part =
        |mesh| NetworkPart { kind, side: None, line: None, length: size.x, width: size.y, arms: arms.len(), mesh };
    Ok(mesh(&faces, heights, 1).map(part))
}
