//! The pieces of shapes that do not simply fill their scopes: meshes, wires, lines, mirrored boxes.

use std::ops::ControlFlow;
use std::sync::Arc;

use glam::DVec3;

use super::row::Row;
use super::{Adjust, Piece};
use crate::fault::FaultKind;
use crate::geometry::Axis;
use crate::geometry::cut;
use crate::geometry::mesh::Mesh;
use crate::geometry::tol::{PLANAR_EPSILON, SNAP_EPSILON};
use crate::geometry::wire::Wire;
use crate::run::env::Env;
use crate::run::sink::Flow;
use crate::shape::PlacedWire;
use crate::shape::scope::Scope;
use crate::shape::unit::Band;
use crate::shape::{Geometry, Inserted, Placed, Shape};

/// The parts of a shape, in order.
#[derive(Debug)]
pub(super) struct SplitParts<'s> {
    parent: &'s Shape,
    axis: Axis,
    adjust: Adjust,
    /// The direction of the scope along the axis, from its origin.
    along: DVec3,
    sign: f64,
    index: usize,
    total: usize,
    /// The meshes of the pieces, if the geometry is a mesh.
    slabs: Vec<Option<Arc<Mesh>>>,
}

impl<'s> SplitParts<'s> {
    /// Counts the pieces and cuts the geometry. `Break` when a limit is reached.
    pub(super) fn new(
        env: &mut Env,
        shape: &'s Shape,
        axis: Axis,
        adjust: Adjust,
        row: impl Row,
    ) -> ControlFlow<(), Self> {
        let total = row.total() as usize;
        let slabs = match &shape.geometry {
            Geometry::Mesh(placed) if 0 < total => slabs(env, placed, axis, &shape.scope, row)?,
            _ => Vec::new(),
        };
        // A negative size extends in the other direction from the origin.
        let sign = if shape.scope.size[axis.index()] < 0.0 { -1.0 } else { 1.0 };
        let along = shape.scope.axes.col(axis.index()) * sign;
        ControlFlow::Continue(SplitParts { parent: shape, axis, adjust, along, sign, index: 0, total, slabs })
    }

    pub(super) fn total(&self) -> usize {
        self.total
    }

    /// The shape of the next piece. It has the seed and the counters of the whole.
    pub(super) fn next(&mut self, env: &mut Env, piece: Piece) -> Shape {
        let parent = self.parent;
        let index = self.index;
        self.index += 1;
        let mut scope = Scope { origin: parent.scope.origin + self.along * piece.start, ..parent.scope };
        scope.size[self.axis.index()] = self.sign * piece.length;
        let geometry = self.geometry(env, index, piece, &mut scope);
        let mut part = Shape { scope, geometry, ..parent.clone() };
        env.begin_part(&mut part);
        part
    }

    /// The geometry of a part. With `adjust`, its scope shrinks.
    ///
    /// The reference does not say whether a slot without geometry is a part. Here it is one, with the slot as its
    /// scope, so that inserted geometry has its place and `split.index` counts slots.
    #[inline]
    fn geometry(&self, env: &mut Env, index: usize, piece: Piece, scope: &mut Scope) -> Geometry {
        match &self.parent.geometry {
            Geometry::Empty => Geometry::Empty,
            Geometry::Box(unit) => Geometry::Box(unit.part(self.axis, self.band(piece))),
            Geometry::Rect(across, unit) if *across != self.axis => {
                if self.adjust == Adjust::Adjust {
                    scope.size[across.index()] = 0.0;
                }
                Geometry::Rect(*across, unit.part(self.axis, self.band(piece)))
            }
            Geometry::Edge if self.axis == Axis::X => Geometry::Edge,
            Geometry::Mesh(whole) => {
                let slab = self.slabs.get(index).and_then(Option::as_ref);
                slab.map_or(Geometry::Empty, |mesh| self.part(whole, mesh, piece, scope))
            }
            Geometry::Wire(whole) => {
                let near = if piece.start == 0.0 { f64::NEG_INFINITY } else { piece.start };
                let along = DVec3::AXES[self.axis.index()] * self.sign;
                let whole = whole.in_scope(self.parent.scope.size);
                let (mut wire, points) = whole.between(along, near, piece.start + piece.length);
                if !whole.trace.is_empty() {
                    wire.trace = env.cut_trace(&whole.trace, &points);
                }
                self.wire(wire, scope)
            }
            // Geometry that is flat along the axis in a thick scope is at the low end.
            flat if piece.start == 0.0 => {
                if self.adjust == Adjust::Adjust {
                    scope.size[self.axis.index()] = 0.0;
                }
                flat.clone()
            }
            Geometry::Rect(..) | Geometry::Edge | Geometry::Vertex => Geometry::Empty,
        }
    }

    /// The position of the last piece in a box or a rectangle.
    #[inline]
    fn band(&self, piece: Piece) -> Band {
        let is_last = self.index == self.total && {
            let extent = self.parent.scope.extent(self.axis).abs();
            extent - (piece.start + piece.length) <= PLANAR_EPSILON * extent
        };
        Band::of(piece.start == 0.0, is_last)
    }

    /// A part of a wire, in scope coordinates of the parent.
    fn wire(&self, wire: Wire, scope: &mut Scope) -> Geometry {
        if wire.points.is_empty() {
            return Geometry::Empty;
        }
        let mut placed = PlacedWire::fitted(wire);
        if self.adjust == Adjust::Adjust {
            scope.origin = self.parent.scope.frame().to_world(placed.low);
            scope.size = placed.size;
        } else {
            // The box that the scope stretches.
            let parent = &self.parent.scope;
            placed.low = parent.frame().to_local(scope.origin);
            placed.size = scope.size;
        }
        Geometry::Wire(Arc::new(placed))
    }

    fn part(&self, whole: &Placed, mesh: &Arc<Mesh>, piece: Piece, scope: &mut Scope) -> Geometry {
        let at = self.axis.index();
        let size = self.parent.scope.size;
        let stretch = whole.stretch(size);
        let (mut low, mut fit) = (whole.low, whole.size);
        low[at] += piece.start / stretch[at].abs();
        fit[at] = piece.length / stretch[at].abs();
        if self.adjust == Adjust::Adjust {
            let bounds = mesh.bounds();
            if !bounds.low.is_finite() {
                return Geometry::Empty;
            }
            // Along an axis that the part spans except for rounding, the slot is its scope, as for a box. Flat
            // geometry has no thickness, as a rectangle.
            let near = PLANAR_EPSILON * fit;
            let spans = fit.cmpgt(DVec3::ZERO)
                & (bounds.low - low).abs().cmple(near)
                & (bounds.high - (low + fit)).abs().cmple(near);
            let moved = DVec3::select(spans, DVec3::ZERO, (bounds.low - low) * stretch);
            scope.origin += scope.axes * moved;
            scope.size = DVec3::select(spans, scope.size, bounds.size() * stretch);
            (low, fit) = (bounds.low, bounds.size());
        }
        Geometry::Mesh(Arc::new(Placed {
            mesh: mesh.clone(),
            low,
            size: fit,
            inserted: Inserted::No,
            mirrored: whole.mirrored,
        }))
    }
}

/// `Break` if the pieces exceed the limit of shapes, before they are laid out.
#[cold]
#[inline(never)]
pub(super) fn within_limit(env: &mut Env, row: impl Row) -> Flow {
    let limit = env.most_shapes();
    let bound = row.at_most();
    if !env.has_room(0) {
        env.make_room(0)?;
    }
    let so_far = env.shape_count();
    if limit < so_far.saturating_add(bound) || env.measures_room() {
        // The bound counts slots that get no room. The exact number is computed if it is small enough to count.
        let exact = if bound <= limit.saturating_mul(4) { row.total() } else { bound };
        if limit < so_far.saturating_add(exact) {
            return env.too_many_shapes();
        }
        if env.measures_room() {
            return env.make_room(exact);
        }
    }
    Flow::Continue(())
}

/// The cuts of a mesh.
pub(super) struct PieceBorders {
    /// The places of cuts in the coordinates of the mesh, so that no vertex moves.
    pub(super) rising: Vec<f64>,
    /// True for each piece that rounding reduces to nothing.
    flat: Vec<bool>,
}

impl PieceBorders {
    /// The borders of pieces of an extent. `place` maps a distance to the mesh's coordinate; `high` is the coordinate
    /// of the end.
    pub(super) fn of(row: impl Row, extent: f64, high: f64, place: impl Fn(f64) -> f64) -> Self {
        // Pieces touch, so after the first border every piece ends a slab, except pieces that rounding reduces to
        // nothing.
        let (mut rising, mut flat): (Vec<f64>, Vec<bool>) = (Vec::new(), Vec::new());
        let _ = row.each(|piece| {
            let end = place(piece.end);
            // The end of the extent is not a cut; rounding must not leave a sliver there.
            let inside = PLANAR_EPSILON * extent < extent - piece.end && end < high;
            flat.push(inside && rising.last() == Some(&end));
            if inside && rising.last() != Some(&end) {
                rising.push(end);
            }
            Flow::Continue(())
        });
        PieceBorders { rising, flat }
    }

    /// The mesh of each piece, counted. `Break` when a limit is reached.
    pub(super) fn one_a_piece(
        self,
        env: &mut Env,
        parts: Vec<Option<Arc<Mesh>>>,
    ) -> ControlFlow<(), Vec<Option<Arc<Mesh>>>> {
        let mut parts = parts.into_iter();
        let list: Vec<_> = self.flat.into_iter().map(|flat| if flat { None } else { parts.next().flatten() }).collect();
        for mesh in list.iter().flatten() {
            env.count_vertices(mesh)?;
        }
        ControlFlow::Continue(list)
    }
}

/// Cuts a mesh at the borders of all pieces in one pass, into one slab for each piece. `Break` when a limit is
/// reached.
fn slabs(
    env: &mut Env,
    placed: &Placed,
    axis: Axis,
    scope: &Scope,
    row: impl Row,
) -> ControlFlow<(), Vec<Option<Arc<Mesh>>>> {
    let at = axis.index();
    let (extent, stretch) = (scope.size[at].abs(), placed.stretch(scope.size)[at].abs());
    let plane = |distance: f64| placed.low[at] + distance / stretch;
    let borders = PieceBorders::of(row, extent, plane(extent), plane);
    // While a cut lasts, the crossings of edges take as much memory as the parts.
    const COPIES: u64 = 2;
    let most = env.corners_left(COPIES);
    // A part that is divided again where it was divided has no pieces that are thinner than rounding, in the world or in the mesh.
    let farthest = |origin: DVec3, size: DVec3| (origin.abs() + size.abs()).max_element();
    let in_world = farthest(scope.origin, scope.size) / stretch;
    let rounding = SNAP_EPSILON * in_world.max(farthest(placed.low, placed.size));
    let mesh = cut::snap(&placed.mesh, axis, &borders.rising, rounding.min(PLANAR_EPSILON * placed.size[at]));
    let Some(mut cut) = cut::slabs_within(&mesh, axis, &borders.rising, most) else {
        return env.too_many_corners(COPIES);
    };
    // *split operation*: surfaces get no caps. An asset is usually meant to be a solid, so it gets a fault; a single
    // face does not.
    if !cut.open.is_empty() && placed.inserted == Inserted::Asset && 1 < placed.mesh.face_count() {
        env.fault(FaultKind::Geometry, "the inserted mesh is not closed where it is split; the cut stays open there");
    }
    for (part, points) in cut.parts.iter_mut().zip(&cut.points) {
        if let Some(part) = part {
            env.with_cut_trace(&mesh, part, points);
        }
    }
    borders.one_a_piece(env, cut.parts)
}
