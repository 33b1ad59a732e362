//! Gable roofs: hip roofs with upright pediments at their ends.
//!
//! An end does not move while the wavefront runs. So its strip has no area, and its points are the pediment when they get
//! heights. Other planes end at the pediment, and continue in front of it as overhangs.

use glam::DVec2;

use super::arcs::{FaceArcs, arcs, joined};
use super::hip::overhang_in_plan;
use super::plan::{Outside, OutsideStrip, Plan};
use super::{Outline, Rise, Roof};
use crate::each::Each;
use crate::skeleton::SkeletonError;

/// The distance of a corner of a pediment from the outer edge of its overhang, as a share of the overhang, at which there is
/// an overhang. It is 1 in straight pediments.
const NEAREST: f64 = 0.5;

/// A gable roof with one face for each edge; `ends` are the edges with pediments. `[across, along]` are the overhangs at
/// the eaves and beyond the pediments.
///
/// If the wavefront with edges that do not move is not determined, all edges get roof planes. Overhangs beyond pediments that
/// would touch another part of the roof are left out.
pub(super) fn gable(
    outline: &Outline<'_>,
    ends: &[bool],
    rise: Rise,
    [across, along]: [f64; 2],
    even: bool,
) -> Result<Roof, SkeletonError> {
    let speeds: Vec<f64> = ends.iter().map(|&end| if end { 0.0 } else { 1.0 }).collect();
    let (mut plan, ends) = match Plan::of(outline, &speeds) {
        Ok(plan) => (plan, ends.to_vec()),
        Err(SkeletonError::TooMany) => return Err(SkeletonError::TooMany),
        Err(SkeletonError::Tangled) => (Plan::of(outline, &vec![1.0; ends.len()])?, vec![false; ends.len()]),
    };
    if even {
        plan.level_ridges(outline);
    }
    let slope = rise.slope(plan.top());
    let eave = if 0.0 < across { overhang_in_plan(across, slope) } else { 0.0 };
    let gables = gables(outline, &ends);
    let mut beyond: Vec<f64> = gables.iter().map(|_| along.max(0.0)).collect();
    while 0.0 < eave || beyond.iter().any(|&along| 0.0 < along) {
        let mut distances: Vec<f64> = ends.iter().map(|&end| if end { 0.0 } else { eave }).collect();
        for (gable, &along) in gables.iter().zip(&beyond) {
            gable.iter().for_each(|&edge| distances[edge as usize] = along);
        }
        match overhang(&mut plan, outline, &ends, &gables, &beyond, &distances, eave) {
            Ok(()) => break,
            Err(NoOverhang::Without(gables)) => gables.into_iter().for_each(|gable| beyond[gable] = 0.0),
            Err(NoOverhang::Tangled) if beyond.iter().any(|&along| 0.0 < along) => beyond.fill(0.0),
            // With one speed the wavefront is always determined. Eaves then reach around the corners of pediments.
            Err(NoOverhang::Tangled) => {
                let distances = vec![eave; ends.len()];
                let found = overhang(&mut plan, outline, &ends, &gables, &beyond, &distances, eave);
                found.map_err(|_| SkeletonError::Tangled)?;
                break;
            }
        }
    }
    plan.take_back(outline, &ends, [overhang_in_plan((-across).max(0.0), slope), (-along).max(0.0)])?;
    Ok(plan.roof(slope, &|edge| ends[edge as usize]))
}

/// The gables: neighbouring edges that are ends, in their order. A ring whose edges are all ends has no gable: its
/// pediments have no room for overhangs.
fn gables(outline: &Outline<'_>, ends: &[bool]) -> Vec<Vec<u32>> {
    let (mut gables, mut first): (Vec<Vec<u32>>, _) = (Vec::new(), 0);
    for ring in outline.rings {
        let count = ring.len();
        let is_end = |i: usize| ends[first + i % count];
        for start in (0..count).filter(|&i| is_end(i) && !is_end(i + count - 1)) {
            let run = (start..start + count).take_while(|&i| is_end(i));
            gables.push(run.map(|i| (first + i % count) as u32).collect());
        }
        first += count;
    }
    gables
}

/// The reason why there are no overhangs.
enum NoOverhang {
    /// The numbers of gables that have no room for theirs.
    Without(Vec<usize>),
    /// The outside has no wavefront.
    Tangled,
}

/// Adds overhangs. After an error the plan has only more points.
fn overhang(
    plan: &mut Plan,
    outline: &Outline<'_>,
    ends: &[bool],
    gables: &[Vec<u32>],
    beyond: &[f64],
    distances: &[f64],
    eave: f64,
) -> Result<(), NoOverhang> {
    let outside = plan.outside(outline, distances, eave).map_err(|_| NoOverhang::Tangled)?;
    let face_arcs = plan.face_arcs();
    let mut regions: Vec<(u32, Vec<u32>)> = Vec::new();
    let mut without = Vec::new();
    for (number, gable) in gables.iter().enumerate().filter(|(number, _)| 0.0 < beyond[*number]) {
        match in_front(plan, outline, gable, beyond[number], &outside, &face_arcs) {
            Some(found) => regions.extend(found),
            None => without.push(number),
        }
    }
    if !without.is_empty() {
        return Err(NoOverhang::Without(without));
    }
    let is_end = |edge: u32| ends[edge as usize];
    let is_eave = |strip: &OutsideStrip| !is_end(strip.edge) && 0.0 < distances[strip.edge as usize];
    let fronts = outside.fronts(is_eave);
    regions.extend(outside.strips.into_iter().filter(is_eave).map(|strip| (strip.edge, strip.ring)));
    plan.join(regions, &fronts);
    plan.drop_straight(&|edge| !is_end(edge));
    if eave == 0.0 {
        plan.begin_at_eaves(outline, is_end);
    }
    Ok(())
}

/// The regions in front of a pediment, each with the edge whose plane continues there. Their outer edge is straight. `None`
/// if the pediment has a corner that is not far behind that edge, if the strip of the gable outside has more than two sides
/// beside its outer edge, or if the ridge does not reach the outer edge.
fn in_front(
    plan: &mut Plan,
    outline: &Outline<'_>,
    gable: &[u32],
    along: f64,
    outside: &Outside,
    face_arcs: &FaceArcs,
) -> Option<Vec<(u32, Vec<u32>)>> {
    let edges = outline.edges();
    let (a, b) = (edges[*gable.first()? as usize][0], edges[*gable.last()? as usize][1]);
    // The outer ends of the strip: `a` to `outer[0]`, and `outer[1]` to `b`.
    let strips = || outside.strips.iter().filter(|strip| gable.contains(&strip.edge));
    let fronts: Vec<[u32; 2]> = strips().flat_map(OutsideStrip::fronts).collect();
    let rings = joined(strips().map(|strip| &strip.ring[..]));
    let [ring] = &rings[..] else { return None };
    let own: Vec<[u32; 2]> = gable.iter().map(|&edge| edges[edge as usize]).collect();
    let sides: Vec<[u32; 2]> =
        arcs(ring).filter(|arc| !own.contains(&[arc[1], arc[0]]) && !fronts.contains(arc)).collect();
    let outer = match sides[..] {
        [p, q] if p[0] == a && q[1] == b => [p[1], q[0]],
        [q, p] if p[0] == a && q[1] == b => [p[1], q[0]],
        _ => return None,
    };
    let [p, q] = outer.each(|point| plan.points[point as usize]);
    let behind = (q - p).normalize_or_zero().perp();
    let mut corners = gable[1..].iter().map(|&edge| outline.at(edges[edge as usize][0]));
    if corners.any(|corner| behind.dot(corner - p) < NEAREST * along) {
        return None;
    }
    // The upper rim of the pediment, from `b` to `a`.
    let pediment = plan.faces.iter().filter(|face| gable.contains(&face.edge));
    let rings = joined(pediment.map(|face| &face.ring[..]));
    let [ring] = &rings[..] else { return None };
    let rim: Vec<[u32; 2]> = {
        let mut rim: Vec<[u32; 2]> = arcs(ring).filter(|arc| !own.contains(arc)).collect();
        let first = rim.iter().position(|arc| arc[0] == b)?;
        rim.rotate_left(first);
        rim
    };
    if rim.last()?[1] != a || rim.windows(2).any(|pair| pair[0][1] != pair[1][0]) {
        return None;
    }
    let face_of = |arc: &[u32; 2]| face_arcs.left_of([arc[1], arc[0]]).map(|face| plan.faces[face].edge);
    let faces: Vec<u32> = rim.iter().map(face_of).collect::<Option<_>>()?;
    // The planes beside the pediment must border on the strip, and not belong to another gable at a corner.
    let borders = |arc: [u32; 2], edge: u32| {
        let others = outside.strips.iter().filter(|strip| !gable.contains(&strip.edge));
        others.filter(|strip| arcs(&strip.ring).any(|other| other == [arc[1], arc[0]])).all(|strip| strip.edge == edge)
    };
    if !borders([a, outer[0]], faces[faces.len() - 1]) || !borders([outer[1], b], faces[0]) {
        return None;
    }
    let plane =
        |edge: u32, p: DVec2| outline.along(edges[edge as usize]).perp().dot(p - outline.at(edges[edge as usize][0]));
    let mut regions = Vec::new();
    let (mut start, mut from) = (0, outer[1]);
    while start < rim.len() {
        let edge = faces[start];
        let end = (start..rim.len()).find(|&i| faces[i] != edge).unwrap_or(rim.len());
        let to = match faces.get(end) {
            None => outer[0],
            Some(&other) => {
                // Both planes are equally high there.
                let lead = |p: DVec2| plane(edge, p) - plane(other, p);
                let share = lead(p) / (lead(p) - lead(q));
                if !(0.0 < share && share < 1.0) {
                    return None;
                }
                let (at, ridge) = (p.lerp(q, share), rim[end][0]);
                let here = plan.points[ridge as usize];
                plan.beyond(ridge, at, plane(edge, at) - plane(edge, here))
            }
        };
        let mut region: Vec<u32> = rim[start..end].iter().map(|arc| arc[0]).collect();
        region.extend([rim[end - 1][1], to, from]);
        regions.push((edge, region));
        (start, from) = (end, to);
    }
    Some(regions)
}
