//! The relation of a geometry to closed solids: inside, overlapping or touching.
//!
//! ```
//! use cga_geometry::glam::{DAffine3, DVec3};
//! use cga_geometry::relation::{Occluder, Occluders, QueryGeometry, Relation};
//!
//! // A house of 10 m, and a window on a wall of its neighbour, half of which is behind the house.
//! let house = Occluder::cuboid(DAffine3::from_scale(DVec3::splat(10.0)));
//! let houses = Occluders::new([house]);
//! let window = QueryGeometry::rectangle(DVec3::new(10.0, 4.0, 9.0), [DVec3::Z * 2.0, DVec3::Y * 2.0]);
//! let found = houses.query(&window, Relation::ALL, &mut |_| true);
//! assert_eq!(found, Relation { inside: false, overlaps: false, touches: true });
//! ```
//!
//! The solids are *occluders*. Each answer of a [`Relation`] holds for at least one of them; they are not united. A geometry is:
//!
//! - `inside`, if all of it is inside or on the surface of one occluder;
//! - `overlaps`, if a part with an area (a face), a volume (a closed mesh) or a length (a segment) is strictly inside. A closed mesh
//!   around an occluder overlaps it, too;
//! - `touches`, if it overlaps or is inside, or if a face is on the surface over an area, whichever way the normals point. Common
//!   lines and points do not count.
//!
//! A place is inside a mesh if the faces wind around it, as for [`boolean`](crate::boolean). So cavities are outside, and solids that
//! cross themselves have no walls inside.
//!
//! # The tolerance
//!
//! One length decides, in both directions: surfaces at most this far apart are in contact, and a part that is inside by no more is on the
//! surface. It is 1 mm ([`CONTACT_DISTANCE`](crate::tol::CONTACT_DISTANCE)); if the longest extent of the occluder or of the geometry is
//! below 1 m, a thousandth of it ([`CONTACT_EPSILON`](crate::tol::CONTACT_EPSILON)); but never less than rounding errors of the
//! coordinates. Façades that turned with their buildings are coplanar only up to rounding, and files have coordinates of 32 bits: both
//! errors are far below. Areas of contact narrower than the tolerance do not count. Details that are thinner than twice the tolerance may
//! count as a surface.
//!
//! # Time
//!
//! Candidates are found by a tree of boxes: a query in a city takes time proportional to log n for n occluders, and to the number of
//! occluders whose boxes meet the box of the geometry. Boxes and rectangles in any position are compared directly, in a fraction of a
//! microsecond. Other meshes are compared face by face, where faces are near each other. A pair of meshes has a limit on the
//! work; beyond it, the answers that were found count, and `inside` is false.

mod budget;
mod convex_polygon;
mod cuboid;
mod cuboid_pair;
mod near;
mod occluders;
mod oriented_box;
mod plane_cut;
mod query_geometry;
mod segment_pair;
mod subdivision;
mod surface;
mod surface_pair;
mod tolerance;

pub use near::NearOccluders;
pub use occluders::{Occluder, Occluders};
pub use oriented_box::OrientedBox;
pub use query_geometry::QueryGeometry;

/// The answers for a geometry. Whatever is `inside` or `overlaps` also `touches`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Relation {
    /// All of the geometry is inside or on the surface of one occluder.
    pub inside: bool,
    /// A part of the geometry with a positive measure is strictly inside an occluder, or a part of an occluder is inside the geometry.
    pub overlaps: bool,
    /// The geometry overlaps an occluder, is inside it, or has an area in common with its surface.
    pub touches: bool,
}

impl Relation {
    /// No relation.
    pub const NONE: Relation = Relation { inside: false, overlaps: false, touches: false };
    /// All three answers.
    pub const ALL: Relation = Relation { inside: true, overlaps: true, touches: true };
    /// The answer `inside` alone.
    pub const INSIDE: Relation = Relation { inside: true, ..Relation::NONE };
    /// The answer `overlaps` alone.
    pub const OVERLAPS: Relation = Relation { overlaps: true, ..Relation::NONE };
    /// The answer `touches` alone.
    pub const TOUCHES: Relation = Relation { touches: true, ..Relation::NONE };

    /// The answers that hold in one of two relations.
    #[must_use]
    pub const fn or(self, other: Relation) -> Relation {
        Relation {
            inside: self.inside | other.inside,
            overlaps: self.overlaps | other.overlaps,
            touches: self.touches | other.touches,
        }
    }

    /// The answers that hold in both of two relations.
    #[must_use]
    pub const fn and(self, other: Relation) -> Relation {
        Relation {
            inside: self.inside & other.inside,
            overlaps: self.overlaps & other.overlaps,
            touches: self.touches & other.touches,
        }
    }

    /// The answers that do not hold in another relation.
    #[must_use]
    pub const fn without(self, other: Relation) -> Relation {
        Relation {
            inside: self.inside & !other.inside,
            overlaps: self.overlaps & !other.overlaps,
            touches: self.touches & !other.touches,
        }
    }

    /// The relation with the answers that others imply.
    pub(crate) const fn of(inside: bool, overlaps: bool, contact: bool) -> Relation {
        Relation { inside, overlaps, touches: inside | overlaps | contact }
    }
}

#[cfg(test)]
mod tests;
