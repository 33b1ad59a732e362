//! The sides of a box, as far as they carry tags: a box is no mesh, and yet `extrude` tags its faces (*Geometry tagging*,
//! auto-tags).

use crate::mesh::TagSet;
use crate::scope::Axis;
use crate::sink::{Cuboid, Quad};
use crate::text::Text;

/// Where `extrude` made a face: the face that was there, what rises from its outline and from its holes, and the face that
/// moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extruded {
    Bottom,
    Outer,
    Inner,
    Top,
}

impl Extruded {
    pub(crate) const ALL: [Extruded; 4] = [Extruded::Bottom, Extruded::Outer, Extruded::Inner, Extruded::Top];

    /// Its tag.
    pub(crate) fn tag(self) -> &'static str {
        match self {
            Extruded::Bottom => "extrude.bottom",
            Extruded::Outer => "extrude.side.outer",
            Extruded::Inner => "extrude.side.inner",
            Extruded::Top => "extrude.top",
        }
    }

    /// Whose tag is the only one of a set.
    pub(crate) fn of(set: &TagSet) -> Option<Self> {
        let [name] = set.names() else { return None };
        Extruded::ALL.into_iter().find(|extruded| **name == *extruded.tag())
    }
}

/// Which sides of a box are as `extrude` made them, a bit each: front, right, back, left, top, bottom. One more bit is for
/// the boxes that `primitiveCube` makes, which number their faces otherwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Sides(u8);

impl Sides {
    /// None.
    pub(crate) const PLAIN: Sides = Sides(0);
    /// None, of what `primitiveCube` makes.
    pub(crate) const CUBE: Sides = Sides(0b100_0000);
    /// All.
    pub(crate) const GROWN: Sides = Sides(0b11_1111);

    /// Of a part between two planes across an axis: a side that a cut made is new.
    #[inline]
    pub(crate) fn part(self, axis: Axis, is_first: bool, is_last: bool) -> Self {
        let (low, high) = match axis {
            Axis::X => (3, 1),
            Axis::Y => (5, 4),
            Axis::Z => (2, 0),
        };
        let gone = |side: u8, kept: bool| if kept { 0 } else { 1u8 << side };
        Sides(self.0 & !gone(low, is_first) & !gone(high, is_last))
    }

    /// Whether there is nothing to be said of the faces.
    pub(crate) fn is_plain(self) -> bool {
        self.0 == 0
    }

    /// The side that is a face: faces are numbered as sides are, but those of `primitiveCube` begin with the top and end
    /// with the front. (*comp operation*, trim planes, shows that 5 is an upright one, and no more.)
    #[inline]
    pub(crate) fn side_of(self, face: usize) -> usize {
        const OF_CUBE: [usize; 6] = [4, 5, 3, 2, 1, 0];
        if self.0 & Sides::CUBE.0 == 0 { face } else { OF_CUBE[face] }
    }

    /// The faces of a box by number.
    pub(crate) fn faces(self, cuboid: &Cuboid) -> [Quad; 6] {
        let sides = cuboid.faces();
        [0, 1, 2, 3, 4, 5].map(|face| sides[self.side_of(face)])
    }

    /// The tag of a side.
    #[inline]
    pub(crate) fn tag(self, side: usize) -> Option<Extruded> {
        let tag = match side {
            4 => Extruded::Top,
            5 => Extruded::Bottom,
            _ => Extruded::Outer,
        };
        (self.0 >> side & 1 == 1).then_some(tag)
    }
}

/// The set of each of [`Extruded::ALL`].
pub(crate) fn tag_sets() -> Vec<TagSet> {
    Extruded::ALL.iter().map(|extruded| TagSet::new([Text::from(extruded.tag())])).collect()
}
