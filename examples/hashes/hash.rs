//! Hashes of outputs.

use std::fmt;

use cga::sink::buffers::{Buffers, Submesh};

/// An FNV-1a hash.
pub(crate) struct Hash(pub(crate) u64);

impl Hash {
    /// The hash of no bytes.
    pub(crate) fn new() -> Self {
        Hash(0xcbf2_9ce4_8422_2325)
    }

    /// The hash of bytes.
    pub(crate) fn of(bytes: &[u8]) -> u64 {
        let mut hash = Hash::new();
        hash.add(bytes);
        hash.0
    }

    /// Adds bytes.
    pub(crate) fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

impl fmt::Write for Hash {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.add(text.as_bytes());
        Ok(())
    }
}

/// The hash of all contents of buffers.
pub(crate) fn buffers(buffers: &Buffers) -> u64 {
    let mut hash = Hash::new();
    let submesh = |submesh: Submesh| {
        let Submesh { rule, material, indices, vertices } = submesh;
        format!("Part {{ rule: {rule}, material: {material}, indices: {indices:?}, vertices: {vertices:?} }}")
    };
    let submeshes = buffers.submeshes().map(submesh).collect::<Vec<_>>().join(", ");
    // The text of earlier versions, so that hashes can be compared with theirs.
    hash.add(format!("{:?}{:?}[{submeshes}]", buffers.rules(), buffers.materials()).as_bytes());
    let floats = buffers.vertices().iter().flatten().chain(buffers.uvs().iter().flatten());
    floats.for_each(|float| hash.add(&float.to_bits().to_le_bytes()));
    buffers.indices().iter().for_each(|index| hash.add(&index.to_le_bytes()));
    hash.0
}
