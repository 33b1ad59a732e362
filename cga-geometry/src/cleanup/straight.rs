//! Removes points between edges that form a straight line.

use glam::DVec3;

use super::crossing::will_break;
use super::values::are_between;
use super::{Limits, add_loops, spend, without_faces};
use crate::each::Each;
use crate::mesh::{Mesh, unit};

/// The mesh without points between two edges that form a straight line in all faces at the point. An edge that replaces others
/// deviates from them by less than the limits, so that an arc of many edges keeps its form. Points with tags stay, and so do those
/// between edges with different tags, and those at which the texture bends. `None` if no point is removed.
pub(super) fn without_straight_points(mesh: &Mesh, limits: &Limits) -> Option<Mesh> {
    mesh.adjacency_in_time()?;
    let link = |point: usize| {
        spend(2)?;
        Some(link(mesh, point, limits))
    };
    let links: Vec<Option<[u32; 2]>> = (0..mesh.points.len()).map(link).collect::<Option<_>>()?;
    let mut lines = Lines {
        mesh,
        limits,
        links: &links,
        is_seen: vec![false; links.len()],
        targets: (0..links.len() as u32).collect(),
    };
    // Lines that end at other points, and then those that are loops, from the first corner of a face on.
    for point in 0..links.len() as u32 {
        spend(1)?;
        if links[point as usize].is_none() {
            for &corner in mesh.adjacency().at(point as usize) {
                for next in [mesh.adjacency().next(corner), mesh.adjacency().before(corner)] {
                    lines.follow(point, mesh.corners[next as usize]);
                }
            }
        }
    }
    for &point in &mesh.corners {
        spend(1)?;
        if let Some([_, next]) = links[point as usize].filter(|_| !lines.is_seen[point as usize]) {
            lines.is_seen[point as usize] = true;
            lines.follow(point, next);
        }
    }
    let mut targets = lines.targets;
    keep_large_loops(mesh, limits, &mut targets)?;
    keep_broken_faces(mesh, &mut targets)?;
    let is_any = (0..).zip(&targets).any(|(point, &target)| point != target);
    if is_any { without(mesh, &targets) } else { None }
}

/// The neighbours of a point that may be removed; `None` for other points.
fn link(mesh: &Mesh, point: usize, limits: &Limits) -> Option<[u32; 2]> {
    let adjacency = mesh.adjacency();
    let corners = adjacency.at(point);
    let around =
        |corner: u32| [adjacency.before(corner), adjacency.next(corner)].each(|near| mesh.corners[near as usize]);
    let [a, b] = around(*corners.first()?);
    let is_same = |corner: &u32| [[a, b], [b, a]].contains(&around(*corner));
    if a == b || !corners.iter().all(is_same) || mesh.vertex_tags(point as u32).is_some() {
        return None;
    }
    let [from, at, to] = [a, point as u32, b].each(|point| mesh.points[point as usize]);
    let is_straight = limits.are_parallel(unit(at - from), unit(to - at));
    let have_same_tags = mesh.edge_tags([a, point as u32]) == mesh.edge_tags([point as u32, b]);
    (is_straight && have_same_tags && corners.iter().all(|&corner| are_between(mesh, corner, limits))).then_some([a, b])
}

struct Lines<'m> {
    mesh: &'m Mesh,
    limits: &'m Limits,
    links: &'m [Option<[u32; 2]>],
    /// True for points of lines that are done.
    is_seen: Vec<bool>,
    /// For each point itself, or if it is removed, the point that stays before it in the line.
    targets: Vec<u32>,
}

impl Lines<'_> {
    /// Follows a line from its first point over the next one to the first point that stays, and chooses the points to remove.
    fn follow(&mut self, first: u32, next: u32) {
        let (mut line, mut point) = (vec![first], next);
        while let Some([a, b]) = self.links[point as usize].filter(|_| !self.is_seen[point as usize]) {
            self.is_seen[point as usize] = true;
            let last = line[line.len() - 1];
            line.push(point);
            point = if a == last { b } else { a };
        }
        if line.len() == 1 {
            return;
        }
        line.push(point);
        let mut from = 0;
        while from + 1 < line.len() {
            let to = self.reach(&line, from);
            line[from + 1..to].iter().for_each(|&point| self.targets[point as usize] = line[from]);
            from = to;
        }
    }

    /// The place of a point to which one edge can replace those from `from`: the last one that a search with doubled steps finds.
    fn reach(&self, line: &[u32], from: usize) -> usize {
        let last = line.len() - 1;
        let (mut good, mut step) = (from + 1, 2);
        let mut bad = last + 1;
        while good < last {
            let to = (from + step).min(last);
            if !self.is_straight(&line[from..=to]) {
                bad = to;
                break;
            }
            good = to;
            step *= 2;
        }
        while good + 1 < bad {
            let middle = good + (bad - good) / 2;
            if self.is_straight(&line[from..=middle]) {
                good = middle;
            } else {
                bad = middle;
            }
        }
        good
    }

    /// Returns true if the edge between the ends of a line deviates from the line by less than the limits.
    fn is_straight(&self, line: &[u32]) -> bool {
        let at = |point: u32| self.mesh.points[point as usize];
        let (from, to) = (at(line[0]), at(line[line.len() - 1]));
        let along = unit(to - from);
        along != DVec3::ZERO
            && line.windows(2).all(|pair| {
                let [a, b] = [at(pair[0]), at(pair[1])];
                self.limits.are_parallel(unit(b - a), along) && (a - from).cross(along).length() <= self.limits.flat
            })
    }
}

/// Keeps all points of loops that would shrink to nothing although they have an area. `None` if the work is to end.
fn keep_large_loops(mesh: &Mesh, limits: &Limits, targets: &mut [u32]) -> Option<()> {
    for face in mesh.faces() {
        spend(face.corner_count())?;
        if face.area() <= limits.area {
            continue;
        }
        for ring in face.loops() {
            if ring.iter().filter(|&&point| targets[point as usize] == point).count() < 3 {
                keep(ring, targets);
            }
        }
    }
    Some(())
}

/// Keeps all points of faces that would turn over, cross themselves, or leave a hole outside. Their neighbours keep them, too.
/// `None` if the work is to end.
fn keep_broken_faces(mesh: &Mesh, targets: &mut [u32]) -> Option<()> {
    loop {
        spend(mesh.corners.len())?;
        let broken: Vec<usize> = (0..mesh.face_count()).filter(|&face| will_break(mesh, face, targets)).collect();
        if broken.is_empty() {
            return Some(());
        }
        broken.into_iter().for_each(|face| keep(&mesh.corners[mesh.face_corners(face)], targets));
    }
}

fn keep(points: &[u32], targets: &mut [u32]) {
    points.iter().for_each(|&point| targets[point as usize] = point);
}

/// `None` if the work is to end.
fn without(mesh: &Mesh, targets: &[u32]) -> Option<Mesh> {
    let mut made = without_faces(mesh);
    let is_kept = |corner: &u32| {
        let point = mesh.corners[*corner as usize];
        targets[point as usize] == point
    };
    let keeps_holes = mesh.whether_closed()?;
    for face in mesh.faces() {
        spend(2 * face.corner_count())?;
        let mut loops = Vec::with_capacity(face.loops().len());
        for ring in face.loop_ranges() {
            let (start, end) = (ring.start as u32, ring.end as u32);
            let mut kept: Vec<u32> = (start..end).filter(is_kept).collect();
            // The first edge stays, as a part of a longer one.
            if !is_kept(&start) && !kept.is_empty() {
                kept.rotate_right(1);
            }
            if !mesh.subcomponent_tags.is_empty() && 3 <= kept.len() {
                for (place, &corner) in kept.iter().enumerate() {
                    let next = kept[(place + 1) % kept.len()];
                    let after = mesh.adjacency().next(corner);
                    if after != next {
                        let [from, over, to] = [corner, after, next].each(|corner| mesh.corners[corner as usize]);
                        if let Some(tags) = mesh.edge_tags([from, over]) {
                            made.tag_edge([from, to], tags);
                        }
                    }
                }
            }
            loops.push(kept);
        }
        add_loops(&mut made, mesh, face.index(), &loops, keeps_holes, |point| point);
    }
    Some(made.finish())
}
