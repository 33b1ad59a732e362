//! The sides of a box, as far as they carry tags: a box is no mesh, and yet `extrude` tags its faces (*Geometry tagging*,
//! auto-tags).

use crate::mesh::TagSet;
use crate::scope::Axis;
use crate::text::Text;

/// Tags of the original face, what rises from its outline and from its holes, and the face that was moved.
pub(crate) const EXTRUDED: [&str; 4] = ["extrude.bottom", "extrude.side.outer", "extrude.side.inner", "extrude.top"];

/// Which sides of a box are as `extrude` made them: front, right, back, left, top, bottom.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Sides(u8);

impl Sides {
    /// None: a box that a primitive made.
    pub(crate) const PLAIN: Sides = Sides(0);
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

    /// Whether no side has a tag.
    pub(crate) fn is_plain(self) -> bool {
        self.0 == 0
    }

    /// The tag of a side, as a number in [`EXTRUDED`].
    pub(crate) fn tag(self, side: usize) -> Option<usize> {
        let tag = match side {
            4 => 3,
            5 => 0,
            _ => 1,
        };
        (self.0 >> side & 1 == 1).then_some(tag)
    }
}

/// The sets of tags that [`Sides::tag`] counts in.
pub(crate) fn tag_sets() -> Vec<TagSet> {
    EXTRUDED.iter().map(|name| TagSet::new([Text::from(*name)])).collect()
}
