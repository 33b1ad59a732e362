//! Slopes that end at each other: a wavefront with one speed for each edge, which starts again at each base height.
//!
//! Heights are measured from the plane of the face along the direction of the volume. So the slope of an edge rises by the
//! tangent of its angle less the rise of the face itself. An edge with a height below its base stays where it is, and its
//! strip is upright. Strips of one edge in several layers are joined by the sides that they share.

use std::collections::BTreeMap;

use glam::{DVec2, DVec3};

use super::{EnvelopePart, EnvelopeRefusal, Ground, capped};
use crate::cut::{Plane, halves};
use crate::each::Each;
use crate::mesh::{FaceTag, Mesh, flip};
use crate::nesting::Nest;
use crate::nesting::contour::Contour;
use crate::skeleton::{self, SkeletonError, Speeds, Strip};
use crate::small_sort::SmallSort;
use crate::tol::PLANAR_EPSILON;
use crate::work;

impl From<SkeletonError> for EnvelopeRefusal {
    fn from(failure: SkeletonError) -> Self {
        match failure {
            SkeletonError::TooMany => EnvelopeRefusal::TooMany,
            SkeletonError::Tangled => EnvelopeRefusal::Tangled,
        }
    }
}

/// A volume in the making.
struct Stack {
    /// Points: their places in the plan, and their heights over the face.
    points: Vec<(DVec2, f64)>,
    /// The sides of each part, in the direction in which it runs around them.
    sides: BTreeMap<EnvelopePart, Vec<[u32; 2]>>,
}

/// A loop of edges: the points where they begin, and the corner of the face whose edge each is on.
type Front = Vec<(u32, usize)>;

/// The volume over a face. The faces have marks of their parts in place of tags.
pub(super) fn stack(ground: &Ground<'_>) -> Result<Mesh, EnvelopeRefusal> {
    let plan = FaceProjection::of(ground)?;
    let mut stack = Stack { points: plan.points.iter().map(|&p| (p, 0.0)).collect(), sides: BTreeMap::new() };
    let mut fronts: Vec<Front> = vec![ground.flat.corners.iter().copied().zip(0..).collect()];
    let mut levels: Vec<f64> = ground.slopes().map(|corner| ground.sides[corner].base).chain([0.0]).collect();
    levels.retain(|level| *level < plan.top);
    levels.small_sort_by(f64::total_cmp);
    levels.dedup();
    levels.push(plan.top);
    for pair in levels.windows(2) {
        if !fronts.is_empty() {
            fronts = stack.layer(ground, &plan, &fronts, [pair[0], pair[1]])?;
        }
    }
    let points = stack.points.iter().map(|&(p, height)| plan.place(ground, p, height)).collect();
    let mut mesh = Mesh { points, ..Mesh::default() };
    // The bottom is the face itself.
    for (point, &own) in mesh.points.iter_mut().zip(&ground.flat.points) {
        *point = ground.flat.face.mesh.points()[own as usize];
    }
    let mut ring = ground.flat.corners.clone();
    flip(&mut ring);
    mesh.corners.extend(ring);
    mesh.end_loop();
    mesh.end_face(FaceTag { tags: EnvelopePart::Bottom.to_mark(), ..FaceTag::PLAIN });
    let tops: Vec<[u32; 2]> = fronts.iter().flat_map(sides_of).collect();
    let plain: Vec<DVec2> = stack.points.iter().map(|point| point.0).collect();
    add_faces(&mut mesh, &tops, &plain, EnvelopePart::Top)?;
    for (&part, sides) in &stack.sides {
        if !work::spend(stack.points.len()) {
            return Err(EnvelopeRefusal::Tangled);
        }
        match part {
            EnvelopePart::Slope(_) => add_faces(&mut mesh, sides, &plain, part)?,
            EnvelopePart::Base(corner) => {
                let ends = plan.ends[corner as usize].each(|end| plan.points[end as usize]);
                let along = (ends[1] - ends[0]).normalize_or_zero();
                let upright = |&(p, height): &(DVec2, f64)| DVec2::new(along.dot(p - ends[0]), height);
                add_faces(&mut mesh, sides, &stack.points.iter().map(upright).collect::<Vec<_>>(), part)?;
            }
            EnvelopePart::Bottom | EnvelopePart::Top | EnvelopePart::Inner(_) => {}
        }
    }
    mesh.number_used();
    if !mesh.is_closed() || mesh.points.iter().any(|point| !point.is_finite()) {
        return Err(EnvelopeRefusal::Tangled);
    }
    if plan.is_level {
        return Ok(mesh);
    }
    let plane = Plane { point: ground.up * ground.top, normal: ground.up };
    let below = halves(&mesh.into(), &plane, 0.0).parts.swap_remove(0).ok_or(EnvelopeRefusal::Empty)?;
    Ok(capped(&below, EnvelopePart::Top))
}

/// The face as seen along the direction of the volume.
struct FaceProjection {
    axes: [DVec3; 2],
    origin: DVec3,
    /// The points of the face.
    points: Vec<DVec2>,
    /// The height of the face over the level plane through its origin, by metre along each axis.
    rise: DVec2,
    /// The points at the ends of each edge, by corner.
    ends: Vec<[u32; 2]>,
    /// The horizontal way of a slope for a metre of height over the face, by corner; 0 for upright sides.
    ways: Vec<f64>,
    /// The height over the face at which the stack ends.
    top: f64,
    /// True if the face is across the direction of the volume.
    is_level: bool,
}

impl FaceProjection {
    fn of(ground: &Ground<'_>) -> Result<Self, EnvelopeRefusal> {
        let (flat, up) = (&ground.flat, ground.up);
        let origin = flat.origin;
        let x = crate::mesh::unit(flat.axes[0] - up * flat.axes[0].dot(up));
        let axes = [x, up.cross(x)];
        let in_plan = |at: DVec3| DVec2::new((at - origin).dot(axes[0]), (at - origin).dot(axes[1]));
        let points: Vec<DVec2> =
            flat.points.iter().map(|&point| in_plan(flat.face.mesh.points()[point as usize])).collect();
        // On the face a step along an axis rises so that it stays across the normal.
        let rise = DVec2::from_array(axes.each(|axis| -axis.dot(flat.normal) / up.dot(flat.normal)));
        let is_level = rise.length() <= PLANAR_EPSILON;
        let rise = if is_level { DVec2::ZERO } else { rise };
        let ends: Vec<[u32; 2]> =
            ground.corners().map(|corner| [corner, ground.next(corner)].each(|end| flat.corners[end])).collect();
        let mut ways = vec![0.0; ends.len()];
        let heights = points.iter().map(|p| ground.top - origin.dot(up) - rise.dot(*p));
        let mut top = heights.fold(0.0, f64::max);
        for corner in ground.slopes() {
            let [a, b] = ends[corner].each(|end| points[end as usize]);
            let inwards = (b - a).normalize_or_zero().perp();
            let slope = libm::tan(ground.sides[corner].angle.to_radians()) - rise.dot(inwards);
            if slope <= PLANAR_EPSILON {
                // A slope parallel to the face reaches everywhere at once. Over a level face it is the top, and the side is
                // upright below it. Over a slanted face it leads below the face.
                if !is_level || ground.sides[corner].base <= 0.0 {
                    return Err(EnvelopeRefusal::Empty);
                }
                top = top.min(ground.sides[corner].base);
                continue;
            }
            ways[corner] = 1.0 / slope;
        }
        Ok(FaceProjection { axes, origin, points, rise, ends, ways, top, is_level })
    }

    fn place(&self, ground: &Ground<'_>, p: DVec2, height: f64) -> DVec3 {
        self.origin + self.axes[0] * p.x + self.axes[1] * p.y + ground.up * (height + self.rise.dot(p))
    }
}

impl Stack {
    /// Adds a layer between two heights, and returns the loops that are left at its end.
    fn layer(
        &mut self,
        ground: &Ground<'_>,
        plan: &FaceProjection,
        fronts: &[Front],
        [low, high]: [f64; 2],
    ) -> Result<Vec<Front>, EnvelopeRefusal> {
        // Local numbers of points and edges.
        let mut numbers: Vec<u32> = fronts.iter().flatten().map(|edge| edge.0).collect();
        numbers.small_sort();
        numbers.dedup();
        let local = |point: u32| numbers.binary_search(&point).unwrap_or(0) as u32;
        let rings: Vec<Vec<u32>> =
            fronts.iter().map(|front| front.iter().map(|edge| local(edge.0)).collect()).collect();
        let corners: Vec<usize> = fronts.iter().flatten().map(|edge| edge.1).collect();
        let moves = |corner: usize| !ground.sides[corner].is_upright() && ground.sides[corner].base <= low;
        let ways: Vec<f64> = corners.iter().map(|&c| if moves(c) { plan.ways[c] } else { 0.0 }).collect();
        let part = |corner: usize| {
            if moves(corner) { EnvelopePart::Slope(corner as u32) } else { EnvelopePart::Base(corner as u32) }
        };
        let most = ways.iter().copied().fold(0.0, f64::max);
        if most == 0.0 {
            return Ok(self.upright(fronts, part, high));
        }
        let flat: Vec<DVec2> = numbers.iter().map(|&point| self.points[point as usize].0).collect();
        let speeds: Vec<f64> = ways.iter().map(|way| way / most).collect();
        let swept = skeleton::sweep_at(&flat, &rings, Speeds::Slopes(&speeds), (high - low) * most)?;
        let first = self.points.len();
        let height = |time: f64| if time == (high - low) * most { high } else { low + time / most };
        let new = swept.points.iter().zip(&swept.times).skip(flat.len());
        self.points.extend(new.map(|(&p, &time)| (p, height(time))));
        let global = |point: u32| match numbers.get(point as usize) {
            Some(&number) => number,
            None => (first + point as usize - numbers.len()) as u32,
        };
        for Strip { edge, ring, .. } in &swept.strips {
            let Some(&corner) = corners.get(*edge as usize) else { return Err(EnvelopeRefusal::Tangled) };
            let sides = (0..ring.len()).map(|k| [global(ring[k]), global(ring[(k + 1) % ring.len()])]);
            self.sides.entry(part(corner)).or_default().extend(sides);
        }
        let left = swept.left.iter().map(|ring| {
            ring.iter()
                .map(|left| corners.get(left.edge as usize).map(|&corner| (global(left.point), corner)))
                .collect()
        });
        left.collect::<Option<_>>().ok_or(EnvelopeRefusal::Tangled)
    }

    /// A layer in which no edge moves.
    fn upright(&mut self, fronts: &[Front], part: impl Fn(usize) -> EnvelopePart, high: f64) -> Vec<Front> {
        let mut above = BTreeMap::new();
        for &(point, _) in fronts.iter().flatten() {
            above.entry(point).or_insert_with(|| {
                let (p, _) = self.points[point as usize];
                self.points.push((p, high));
                self.points.len() as u32 - 1
            });
        }
        for front in fronts {
            for (side, &(_, corner)) in sides_of(front).zip(front) {
                let [a, b] = side;
                let [c, d] = [above[&b], above[&a]];
                self.sides.entry(part(corner)).or_default().extend([[a, b], [b, c], [c, d], [d, a]]);
            }
        }
        fronts.iter().map(|front| front.iter().map(|&(point, corner)| (above[&point], corner)).collect()).collect()
    }
}

fn sides_of(front: &Front) -> impl Iterator<Item = [u32; 2]> + '_ {
    (0..front.len()).map(|k| [front[k].0, front[(k + 1) % front.len()].0])
}

/// Adds the faces within some sides, as seen in a plane. Sides back and forth cancel.
fn add_faces(mesh: &mut Mesh, sides: &[[u32; 2]], flat: &[DVec2], part: EnvelopePart) -> Result<(), EnvelopeRefusal> {
    let mut count: BTreeMap<[u32; 2], i32> = BTreeMap::new();
    for &[a, b] in sides {
        *count.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
    }
    let mut kept = Vec::new();
    for (&[a, b], &count) in &count {
        match count {
            0 => {}
            1 => kept.push([a, b]),
            -1 => kept.push([b, a]),
            _ => return Err(EnvelopeRefusal::Tangled),
        }
    }
    let (mut contour, mut open) = (Contour::default(), false);
    contour.follow(&kept, flat, |_| open = true);
    if open {
        return Err(EnvelopeRefusal::Tangled);
    }
    let section = contour.section(flat);
    let mut nest = Nest::default();
    nest.sort_as(&section, false);
    for rings in nest.groups() {
        for ring in rings {
            mesh.corners.extend_from_slice(section.ring(ring));
            mesh.end_loop();
        }
        mesh.end_face(FaceTag { tags: part.to_mark(), ..FaceTag::PLAIN });
    }
    Ok(())
}
