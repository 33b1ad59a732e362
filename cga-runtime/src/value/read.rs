//! The values that a result depends on, compared by their bits.

use std::hash::Hash;

use crate::fixed_hash::FixedHasher;
use crate::value::Value;
use crate::value::array::Array;
use crate::value::text::Text;

/// A value that a repeated part or a change of a look reads: an argument of its rule, an attribute or a constant. Values are equal if their
/// bits are.
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

/// A value that was read, kept with the result.
#[derive(Clone, Debug)]
pub(crate) enum KeptRead {
    Value(Value),
    Run(u64),
}

/// Returns true if these values were kept.
#[inline]
pub(crate) fn are(kept: &[KeptRead], reads: &[Read<'_>]) -> bool {
    kept.len() == reads.len() && kept.iter().zip(reads).all(|(kept, read)| read.is(kept))
}

impl<'a> From<&'a Value> for Read<'a> {
    fn from(value: &'a Value) -> Self {
        match value {
            Value::Float(number) => Read::Float(*number),
            Value::Bool(truth) => Read::Bool(*truth),
            Value::Text(text) => Read::Text(text),
            Value::Floats(array) => Read::Floats(array),
            Value::Bools(array) => Read::Bools(array),
            Value::Texts(array) => Read::Texts(array),
        }
    }
}

impl Read<'_> {
    pub(crate) fn kept(&self) -> KeptRead {
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

    pub(crate) fn hash(&self, hasher: &mut FixedHasher) {
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
