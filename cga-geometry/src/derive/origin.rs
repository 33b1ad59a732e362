//! Where the faces and edges of a new mesh come from.

use crate::each::Each;
use crate::mesh::FaceRef;

/// The part that a new face has in an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// The old face, or a piece of it.
    Piece,
    /// A face in a hole of the old face, without its attributes.
    Filling,
    /// A face over the old face, with a tag of the operation such as `extrude.top`.
    Over(&'static str),
    /// A face at an edge, which is given by its two corners in the old mesh, with or without a tag of the operation.
    Beside([u32; 2], Option<&'static str>),
}

/// The origin of a new face: a face of the old mesh, and the part that the new face has in the operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceOrigin {
    pub(super) face: u32,
    role: Role,
    is_turned: bool,
}

impl FaceOrigin {
    /// The old face itself, or a piece of it.
    #[inline]
    pub fn piece(face: &FaceRef<'_>) -> Self {
        FaceOrigin { face: face.index() as u32, role: Role::Piece, is_turned: false }
    }

    /// A face in a hole of the old face. It has no attributes of the old face.
    pub fn filling(face: &FaceRef<'_>) -> Self {
        FaceOrigin { role: Role::Filling, ..Self::piece(face) }
    }

    /// A piece of the old face that grows out of an edge, given by its two corners in the old mesh.
    pub fn strip(face: &FaceRef<'_>, edge: [usize; 2]) -> Self {
        FaceOrigin { role: Role::Beside(edge.each(|corner| corner as u32), None), ..Self::piece(face) }
    }

    /// A face over the old face. Its tag replaces the other tags below the first word of the tag.
    pub fn over(face: &FaceRef<'_>, tag: &'static str) -> Self {
        FaceOrigin { role: Role::Over(tag), ..Self::piece(face) }
    }

    /// A face over an edge of the old face, given by its two corners in the old mesh.
    pub fn over_edge(face: &FaceRef<'_>, tag: &'static str, edge: [usize; 2]) -> Self {
        FaceOrigin { role: Role::Beside(edge.each(|corner| corner as u32), Some(tag)), ..Self::piece(face) }
    }

    /// The same origin of a face that looks in the opposite direction.
    pub fn turned(self) -> Self {
        FaceOrigin { is_turned: !self.is_turned, ..self }
    }

    /// Returns true for a face that looks in the opposite direction of the old one.
    pub(super) fn is_turned(&self) -> bool {
        self.is_turned
    }

    /// Returns true for the old face itself, or a piece of it.
    #[inline]
    pub(super) fn is_piece(&self) -> bool {
        self.role == Role::Piece
    }

    /// Returns true for a piece that grows out of an edge, without a tag of the operation.
    #[inline]
    pub(super) fn is_strip(&self) -> bool {
        matches!(self.role, Role::Beside(_, None))
    }

    /// Returns true for a face in a hole.
    pub(super) fn is_filling(&self) -> bool {
        self.role == Role::Filling
    }

    /// The tag of the operation.
    pub(super) fn tag(&self) -> Option<&'static str> {
        match self.role {
            Role::Piece | Role::Filling => None,
            Role::Over(tag) => Some(tag),
            Role::Beside(_, tag) => tag,
        }
    }

    /// The corners of the edge out of which the face grows.
    pub(super) fn edge(&self) -> Option<[u32; 2]> {
        if let Role::Beside(edge, _) = self.role { Some(edge) } else { None }
    }
}

/// The component of the old mesh whose tags an edge has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EdgeSource {
    /// The edge between two points.
    Edge([u32; 2]),
    /// The vertex at a point.
    Vertex(u32),
    /// Tags of their own, by number.
    Own(u32),
    /// An edge without tags of the old mesh.
    New,
}

/// The origin of a new edge, where it does not follow from the origins of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct EdgeOrigin {
    pub(crate) source: EdgeSource,
    /// A tag of the operation, in place of other tags below its first word.
    pub(crate) tag: Option<&'static str>,
}
