//! The values on which a template depends.

use std::hash::{Hash, Hasher};

use glam::DVec3;

use crate::fixed_hash::FixedHasher;
use crate::shape::ShapeRef;
use crate::shape::base::Form;
use crate::shape::look_id::LookId;
use crate::shape::unit::UnitMesh;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// A value that a repeated part reads: an argument of its rule, an attribute or a constant. Values are equal if their bits are.
#[derive(Clone, Copy, Debug)]
pub enum Read<'a> {
    /// A number.
    Float(f64),
    /// A truth value.
    Bool(bool),
    /// Text.
    Text(&'a Text),
    /// An array of numbers.
    Floats(&'a Array<f64>),
    /// An array of truth values.
    Bools(&'a Array<bool>),
    /// An array of texts.
    Texts(&'a Array<Text>),
    /// A value that other runs may not have.
    Run(u64),
}

/// The properties of a shape that determine its template, and the values that its rule reads.
#[derive(Debug)]
pub(super) struct TemplateKey {
    /// The number of the slot in the rules.
    place: u32,
    size: DVec3,
    form: Form,
    unit: UnitMesh,
    look: LookId,
    /// The axes along which coordinates are constant. A move along another axis makes a shape with another base.
    constant: [bool; 3],
    pub(super) reads: Box<[KeptRead]>,
}

/// A value that a template has read.
#[derive(Clone, Debug)]
pub(super) enum KeptRead {
    Value(Value),
    Run(u64),
}

impl TemplateKey {
    pub(super) fn of(place: u32, part: &ShapeRef<'_>, reads: &[Read<'_>]) -> Self {
        TemplateKey {
            place,
            size: part.size.get(),
            form: part.form,
            unit: part.unit.get(),
            look: part.look.get(),
            constant: part.base.constant(),
            reads: reads.iter().map(Read::kept).collect(),
        }
    }

    pub(super) fn fits(&self, place: u32, part: &ShapeRef<'_>, reads: &[Read<'_>]) -> bool {
        self.place == place
            && self.size == part.size.get()
            && self.look == part.look.get()
            && self.constant == part.base.constant()
            && self.form == part.form
            && self.unit.is(part.unit.get())
            && are(&self.reads, reads)
    }

    /// The hash of what [`TemplateKey::fits`] compares, without what follows from the rest almost always.
    pub(super) fn hash(place: u32, part: &ShapeRef<'_>, reads: &[Read<'_>]) -> u64 {
        let mut hasher = FixedHasher::default();
        place.hash(&mut hasher);
        // Zero and minus zero are equal.
        part.size.get().to_array().map(|extent| (extent + 0.0).to_bits()).hash(&mut hasher);
        part.look.get().0.hash(&mut hasher);
        reads.iter().for_each(|read| read.hash(&mut hasher));
        hasher.finish()
    }
}

/// Returns true if these values were kept.
#[inline]
pub(super) fn are(kept: &[KeptRead], reads: &[Read<'_>]) -> bool {
    kept.len() == reads.len() && kept.iter().zip(reads).all(|(kept, read)| read.is(kept))
}

impl Read<'_> {
    fn kept(&self) -> KeptRead {
        KeptRead::Value(match *self {
            Read::Float(number) => Value::Float(number),
            Read::Bool(truth) => Value::Bool(truth),
            Read::Text(text) => Value::Text(text.clone()),
            Read::Floats(array) => Value::Floats(array.clone()),
            Read::Bools(array) => Value::Bools(array.clone()),
            Read::Texts(array) => Value::Texts(array.clone()),
            Read::Run(run) => return KeptRead::Run(run),
        })
    }

    #[inline]
    fn is(&self, kept: &KeptRead) -> bool {
        let KeptRead::Value(kept) = kept else {
            return matches!((self, kept), (Read::Run(run), KeptRead::Run(kept)) if run == kept);
        };
        match (self, kept) {
            (Read::Float(number), Value::Float(kept)) => number.to_bits() == kept.to_bits(),
            (Read::Bool(truth), Value::Bool(kept)) => truth == kept,
            (Read::Text(text), Value::Text(kept)) => **text == *kept,
            (Read::Floats(array), Value::Floats(kept)) => {
                let bits = |array: &Array<f64>| array.map(|number| number.to_bits());
                bits(array) == bits(kept)
            }
            (Read::Bools(array), Value::Bools(kept)) => **array == *kept,
            (Read::Texts(array), Value::Texts(kept)) => **array == *kept,
            _ => false,
        }
    }

    fn hash(&self, hasher: &mut FixedHasher) {
        match self {
            Read::Float(number) => number.to_bits().hash(hasher),
            Read::Bool(truth) => truth.hash(hasher),
            Read::Text(text) => text.as_str().hash(hasher),
            Read::Floats(array) => array.iter().for_each(|number| number.to_bits().hash(hasher)),
            Read::Bools(array) => array.iter().for_each(|truth| truth.hash(hasher)),
            Read::Texts(array) => array.iter().for_each(|text| text.as_str().hash(hasher)),
            Read::Run(run) => run.hash(hasher),
        }
    }
}
