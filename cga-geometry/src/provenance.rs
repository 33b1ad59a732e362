//! The origin of a face, and the tags that `extrude` gives.

use crate::mesh::{FaceTag, Mesh, TagSet};

/// The part of an extrusion that a face is: the original face, a side at its outline, a side at a hole, or the face
/// that moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extruded {
    /// The original face, turned over.
    Bottom,
    /// A side at the outline.
    Outer,
    /// A side at a hole.
    Inner,
    /// The face that moved.
    Top,
}

impl Extruded {
    pub(crate) const ALL: [Extruded; 4] = [Extruded::Bottom, Extruded::Outer, Extruded::Inner, Extruded::Top];

    /// The tag of the part.
    pub(crate) fn tag(self) -> &'static str {
        match self {
            Extruded::Bottom => "extrude.bottom",
            Extruded::Outer => "extrude.side.outer",
            Extruded::Inner => "extrude.side.inner",
            Extruded::Top => "extrude.top",
        }
    }

    /// The part whose tag is the only tag of a set.
    pub(crate) fn of(set: &TagSet) -> Option<Self> {
        let [name] = set.names() else { return None };
        Extruded::ALL.into_iter().find(|extruded| **name == *extruded.tag())
    }
}

/// The origin of a face, if its mesh records it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Provenance {
    /// Unknown origin.
    #[default]
    Unknown,
    /// A cut that the face closes.
    Cut,
    /// The same, and an operation on texture coordinates has reached the face.
    MappedCut,
    /// An extrusion, without any other tag.
    Extruded(Extruded),
}

impl Provenance {
    /// The number of origins.
    pub const COUNT: usize = 3 + Extruded::ALL.len();

    /// The number of an origin, from 0.
    #[inline]
    pub fn number(self) -> usize {
        match self {
            Provenance::Unknown => 0,
            Provenance::Cut => 1,
            Provenance::MappedCut => 2,
            Provenance::Extruded(extruded) => 3 + extruded as usize,
        }
    }

    /// The origin of a face with the given tag. `None` if it has other tags, a group or a material.
    pub fn of(mesh: &Mesh, tag: FaceTag) -> Option<Self> {
        let set = mesh.tag_sets().get(tag.tags as usize).filter(|set| !set.names().is_empty());
        match (set, tag.cap) {
            _ if tag.group != FaceTag::NONE || tag.material != FaceTag::NONE => None,
            (Some(set), false) => Extruded::of(set).map(Provenance::Extruded),
            (Some(_), true) => None,
            (None, true) => Some(if tag.mapped { Provenance::MappedCut } else { Provenance::Cut }),
            (None, false) => Some(Provenance::Unknown),
        }
    }

    /// The tag of a face with this origin, in a mesh with the sets of [`tag_sets`].
    pub(crate) fn face_tag(self) -> FaceTag {
        match self {
            Provenance::Unknown => FaceTag::PLAIN,
            Provenance::Cut => FaceTag::CAP,
            Provenance::MappedCut => FaceTag { mapped: true, ..FaceTag::CAP },
            Provenance::Extruded(extruded) => FaceTag { tags: extruded as u32, ..FaceTag::PLAIN },
        }
    }

    /// The tag, if it has one.
    pub fn tag(self) -> Option<&'static str> {
        match self {
            Provenance::Extruded(extruded) => Some(extruded.tag()),
            _ => None,
        }
    }
}

/// The tag set of each of [`Extruded::ALL`].
pub(crate) fn tag_sets() -> Vec<TagSet> {
    Extruded::ALL.iter().map(|extruded| TagSet::new([extruded.tag()])).collect()
}
