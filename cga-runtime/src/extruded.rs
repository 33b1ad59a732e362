//! The tags that `extrude` gives to faces (*Geometry tagging*, auto-tags).

use crate::mesh::TagSet;
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

/// The set of each of [`Extruded::ALL`].
pub(crate) fn tag_sets() -> Vec<TagSet> {
    Extruded::ALL.iter().map(|extruded| TagSet::new([Text::from(extruded.tag())])).collect()
}
