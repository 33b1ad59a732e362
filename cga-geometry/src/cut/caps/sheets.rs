//! The sides of faces in the cut planes.

/// The sides of the faces in the planes.
#[derive(Default)]
pub(crate) struct Sheets {
    /// The faces in the planes with their sides by the rule, in the order of the mesh.
    pub(super) flat: Vec<Flat>,
    /// The faces that go to the other side, sorted.
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

    /// Records the side of a face by the rule. Returns its actual side.
    pub(crate) fn place(&mut self, face: usize, plane: u32, is_above: bool) -> bool {
        self.flat.push(Flat { face: face as u32, plane, is_above });
        self.is_above(face, is_above)
    }

    /// Returns true if a face goes above its plane, given its side by the rule.
    pub(crate) fn is_above(&self, face: usize, by_rule: bool) -> bool {
        by_rule != self.moved.binary_search(&(face as u32)).is_ok()
    }
}
