//! The abstract shape: sizes, filling and trim planes.

use super::interval::Interval;
use crate::ops::{Directions, MOST_SIZE, Selector, THINNEST};
use crate::span::Span;

/// The tolerance of bounding boxes of parts of meshes, in metres and relative: points far from the origin are rounded. It
/// suffices up to a million kilometres.
const ROUGH: f64 = 1e-7;

/// The geometry in the scope. It decides whether parts have the sizes of their slots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Filling {
    /// A box.
    Box,
    /// A rectangle normal to the z axis.
    Sheet,
    /// Level faces, without extent along y.
    Lot,
    /// Upright walls, as of an extruded lot, that are as high as the scope.
    Prism,
    /// Faces that look along the y axis, unless the geometry has no footprint.
    Footprint,
    /// A point.
    Point,
    /// Any geometry.
    Unknown,
}

/// A face of a comp.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Face {
    /// A face that is always planar.
    Flat,
    Any,
}

/// The abstract shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shape {
    /// The scope's size along each axis.
    pub(crate) size: [Interval; 3],
    /// By axis: the step that sets the size, if one step does.
    pub(crate) since: [Option<Span>; 3],
    pub(crate) filling: Filling,
    /// True if trim planes may cut inserted geometry.
    pub(crate) trimmed: bool,
    /// The kind of face, for a part of a comp, also after stretching in x and y: flat along z if it is planar.
    pub(super) is_face: bool,
}

impl Shape {
    /// An unknown shape. Sizes are finite and may be negative.
    pub(crate) const ANY: Shape = Shape {
        size: [Interval::FINITE; 3],
        since: [None; 3],
        filling: Filling::Unknown,
        trimmed: true,
        is_face: false,
    };

    /// An initial shape: without trim planes.
    pub(super) const INITIAL: Shape = Shape { trimmed: false, ..Shape::ANY };

    /// An initial shape without height.
    pub(super) const LOT: Shape =
        Shape { size: [Interval::EXTENT, Interval::ZERO, Interval::EXTENT], filling: Filling::Lot, ..Shape::INITIAL };

    /// The shape with an unknown scope.
    pub(super) fn moved_on(&self) -> Shape {
        Shape { trimmed: self.trimmed, ..Shape::ANY }
    }

    /// A point without extent.
    pub(super) fn point(&self, from: Span) -> Shape {
        let (size, since) = ([Interval::ZERO; 3], [Some(from); 3]);
        Shape { size, since, filling: Filling::Point, trimmed: self.trimmed, is_face: false }
    }

    /// A face from a comp. A face that is not planar has a depth.
    pub(super) fn face(from: Span) -> Shape {
        Shape { size: [Interval::EXTENT; 3], since: [None, None, Some(from)], is_face: true, ..Shape::ANY }
    }

    /// A face of a box from a comp, by its selector: a rectangle. Without a selector, any face.
    pub(super) fn face_of_box(&self, selector: Option<&Selector>, from: Span) -> Shape {
        let [x, y, z] = [0, 1, 2].map(|axis| (self.extent(axis), self.since[axis]));
        let either =
            |a: (Interval, Option<Span>), b: (Interval, Option<Span>)| (a.0.or(b.0), a.1.filter(|_| a.1 == b.1));
        // The sides are vertical; the top and bottom faces follow the scope.
        let takes = |faces| selector.is_none_or(|row| row.directions.meet(faces));
        let across = takes(Directions::FRONT_FACE) || takes(Directions::BACK_FACE);
        let along = takes(Directions::LEFT_FACE) || takes(Directions::RIGHT_FACE);
        let flat = takes(Directions::TOP_FACE) || takes(Directions::BOTTOM_FACE);
        let (width, height) = match (across, along, flat) {
            (true, false, false) => (x, y),
            (false, true, false) => (z, y),
            (true, true, false) => (either(x, z), y),
            (false, false, true) => (x, z),
            _ => (either(x, z), either(y, z)),
        };
        let (size, since) = ([width.0, height.0, Interval::ZERO], [width.1, height.1, Some(from)]);
        Shape { size, since, filling: Filling::Sheet, trimmed: true, is_face: true }
    }

    /// A face of a prism from a comp, by its selector. The sides are rectangles.
    pub(super) fn face_of_prism(&self, selector: Option<&Selector>, from: Span) -> Shape {
        let is_level = Directions::TOP_FACE.and(Directions::BOTTOM_FACE);
        if selector.is_none_or(|row| row.directions == Directions::NONE || row.directions.meet(is_level)) {
            return Shape::face(from);
        }
        let size = [Interval::EXTENT, self.extent(1), Interval::ZERO];
        Shape { size, since: [None, self.since[1], Some(from)], filling: Filling::Sheet, trimmed: true, is_face: true }
    }

    /// The extent along an axis, never negative.
    pub(crate) fn extent(&self, axis: usize) -> Interval {
        self.size[axis].abs()
    }

    /// Returns true if it never has an extent along an axis, provided that a face is planar.
    pub(crate) fn is_flat(&self, axis: usize) -> bool {
        self.extent(axis) == Interval::ZERO || self.is_face && axis == 2
    }

    /// The kind of face, if it is one: certainly flat, or flat if it is planar.
    pub(crate) fn is_face(&self) -> Option<Face> {
        match self.is_face {
            true if self.size[2] == Interval::ZERO => Some(Face::Flat),
            true => Some(Face::Any),
            false => None,
        }
    }

    /// The join of two shapes.
    pub(super) fn or(&self, other: &Shape) -> Shape {
        let size = [0, 1, 2].map(|axis| self.size[axis].or(other.size[axis]));
        let since = [0, 1, 2].map(|axis| self.since[axis].filter(|_| self.since[axis] == other.since[axis]));
        let filling = if self.filling == other.filling { self.filling } else { Filling::Unknown };
        let (trimmed, is_face) = (self.trimmed || other.trimmed, self.is_face && other.is_face);
        Shape { size, since, filling, trimmed, is_face }
    }

    pub(super) fn widen(&self, before: &Shape) -> Shape {
        Shape { size: [0, 1, 2].map(|axis| self.size[axis].widen(before.size[axis])), ..*self }
    }

    /// Returns true if it extends along all axes, whatever its values are. Sizes that are too thin only for some values count.
    pub(super) fn has_room(&self) -> bool {
        let size = self.size.map(Interval::abs);
        let least_width = size.iter().fold(0.0, |most: f64, size| most.max(size.lo));
        size.iter().all(|size| 0.0 < size.lo && THINNEST * least_width < size.hi)
    }

    /// The shape after `s`: the sizes in metres, and which axes keep their size.
    pub(super) fn sized(&self, size: [Interval; 3], kept: [bool; 3], by: Span) -> Shape {
        let since = [0, 1, 2].map(|axis| if kept[axis] { self.since[axis] } else { Some(by) });
        let filling = match self.filling {
            Filling::Box if size.iter().all(|size| size.hi < 0.0 || 0.0 < size.lo) => Filling::Box,
            Filling::Sheet if size[2] == Interval::ZERO && 0.0 < size[0].lo && 0.0 < size[1].lo => Filling::Sheet,
            Filling::Point => Filling::Point,
            _ => Filling::Unknown,
        };
        Shape { size, since, filling, is_face: self.is_face && kept[2], ..*self }
    }

    /// The shape with other geometry in the scope.
    pub(super) fn filled(&self, filling: Filling) -> Shape {
        Shape { filling, is_face: false, ..*self }
    }

    /// The shape after `extrude`: a rectangle without depth becomes a box with y along the extrusion, and a lot a prism.
    pub(super) fn extruded(&self, distance: Interval, by: Span) -> Shape {
        let [x, y, z] = self.size;
        if self.filling == Filling::Lot && 0.0 < distance.lo && distance.hi <= MOST_SIZE && !distance.is_odd() {
            let since = [self.since[0], Some(by), self.since[2]];
            return Shape { size: [x, distance, z], since, filling: Filling::Prism, ..*self };
        }
        if self.filling != Filling::Sheet || z != Interval::ZERO || x.lo < 0.0 || y.lo < 0.0 {
            return self.moved_on();
        }
        if distance.known() == Some(0.0) {
            return *self;
        }
        // A shape that would be too high stays as it is.
        let may_stay = distance.lo <= 0.0 && 0.0 <= distance.hi || MOST_SIZE < distance.abs().hi;
        if distance.is_odd() || may_stay {
            return self.moved_on();
        }
        let since = [self.since[0], Some(by), self.since[1]];
        Shape { size: [x, distance, y], since, filling: Filling::Box, is_face: false, ..*self }
    }

    /// A part that shrinks to its geometry: at most as large as its slot and the shape.
    fn shrunk(&self, axis: usize, length: Interval, by: Span) -> Shape {
        let mut part = Shape { filling: Filling::Unknown, ..*self };
        for (at, size) in part.size.iter_mut().enumerate() {
            let most = if at == axis { length.hi } else { size.abs().hi };
            let most = most + most * ROUGH + ROUGH;
            *size = Interval::finite(if 0.0 <= size.lo { 0.0 } else { -most }, most);
        }
        part.since[axis] = Some(by);
        part
    }

    /// A part of a split along an axis; `length` is the length of its slot.
    pub(super) fn part(&self, axis: usize, length: Interval, adjust: bool, by: Span) -> Shape {
        let fills = match self.filling {
            Filling::Box => true,
            Filling::Sheet => axis != 2,
            Filling::Prism => !adjust || axis == 1,
            Filling::Footprint | Filling::Lot | Filling::Point | Filling::Unknown => !adjust,
        };
        if !fills {
            let part = self.shrunk(axis, length, by);
            return match self.filling {
                Filling::Lot => {
                    Shape { size: [part.size[0], self.size[1], part.size[2]], filling: Filling::Lot, ..part }
                }
                _ => part,
            };
        }
        let mut part = *self;
        part.size[axis] = match self.size[axis] {
            size if 0.0 <= size.lo => length,
            size if size.hi < 0.0 => length.neg(),
            _ => length.or(length.neg()),
        };
        part.since[axis] = Some(by);
        part
    }
}
