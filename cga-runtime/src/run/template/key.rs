//! The values on which a template depends.

use std::hash::{Hash, Hasher};

use glam::{DMat3, DVec3};

use super::slot::RepeatedSlot;
use crate::fixed_hash::FixedHasher;
use crate::shape::ShapeRef;
use crate::shape::base::Form;
use crate::shape::look_id::LookId;
use crate::shape::state::Trim;
use crate::shape::unit::UnitMesh;
use crate::value::read::{KeptRead, Read, are};

/// The properties of a shape that determine its template, and the values that its rule reads.
#[derive(Debug)]
pub(super) struct TemplateKey {
    /// The number of the slot in the rules.
    place: u32,
    size: DVec3,
    form: Form,
    unit: UnitMesh,
    /// The look of the recorded shape; its colour is open if the template is painted.
    pub(super) look: LookId,
    /// The axes along which coordinates are constant. A move along another axis makes a shape with another base.
    constant: [bool; 3],
    /// The switches of trim planes, which faces below the shape have.
    trim: Trim,
    /// The axes of the shape, if they are read.
    pub(super) axes: Option<DMat3>,
    pub(super) reads: Box<[KeptRead]>,
}

impl TemplateKey {
    pub(super) fn of(slot: &RepeatedSlot<'_>, part: &ShapeRef<'_>, look: LookId) -> Self {
        TemplateKey {
            place: slot.place,
            size: part.size.get(),
            form: part.form,
            unit: part.unit.get(),
            look,
            constant: part.base.constant(),
            trim: part.base.shape.state.trim(),
            axes: slot.reads_axes.then_some(part.axes.matrix),
            reads: slot.reads.iter().map(Read::kept).collect(),
        }
    }

    pub(super) fn fits(&self, slot: &RepeatedSlot<'_>, part: &ShapeRef<'_>, look: LookId) -> bool {
        self.place == slot.place
            && self.size == part.size.get()
            && self.look == look
            && self.constant == part.base.constant()
            && self.trim == part.base.shape.state.trim()
            && self.form == part.form
            && self.unit.is(part.unit.get())
            && self.axes.as_ref().is_none_or(|axes| part.axes.is(axes))
            && are(&self.reads, slot.reads)
    }

    /// The hash of what [`TemplateKey::fits`] compares, without what follows from the rest almost always.
    pub(super) fn hash(slot: &RepeatedSlot<'_>, part: &ShapeRef<'_>, look: LookId) -> u64 {
        let mut hasher = FixedHasher::default();
        slot.place.hash(&mut hasher);
        // Zero and minus zero are equal.
        part.size.get().to_array().map(|extent| (extent + 0.0).to_bits()).hash(&mut hasher);
        look.0.hash(&mut hasher);
        if slot.reads_axes {
            part.axes.matrix.to_cols_array().map(f64::to_bits).hash(&mut hasher);
        }
        slot.reads.iter().for_each(|read| read.hash(&mut hasher));
        hasher.finish()
    }
}
