//! The sides that faces in the cut planes go to.

/// Where the faces in the planes go.
#[derive(Default)]
pub(crate) struct Sheets {
    /// The faces in the planes by the rule, in the order of the mesh.
    pub(super) flat: Vec<Flat>,
    /// Faces that go to the other side, sorted.
    pub(super) moved: Vec<u32>,
}

#[derive(Clone, Copy)]
pub(super) struct Flat {
    pub(super) face: u32,
    pub(super) plane: u32,
    pub(super) is_above: bool,
}

impl Sheets {
    pub(crate) fn clear(&mut self) {
        self.flat.clear();
        self.moved.clear();
    }

    /// Notes where the rule takes a face; gives where it goes.
    pub(crate) fn place(&mut self, face: usize, plane: u32, is_above: bool) -> bool {
        self.flat.push(Flat { face: face as u32, plane, is_above });
        self.is_above(face, is_above)
    }

    /// Whether a face goes above its plane, given what the rule says.
    pub(crate) fn is_above(&self, face: usize, by_rule: bool) -> bool {
        by_rule != self.moved.binary_search(&(face as u32)).is_ok()
    }
}
