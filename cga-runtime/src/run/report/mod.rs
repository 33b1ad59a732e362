//! Reports and printed lines of rules: data collected by a run besides its geometry (*report operation*, *print
//! operation*).

mod merge;
mod print;
mod quota;
mod report_table;
mod run;
#[cfg(feature = "serde")]
mod serde;

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

pub use print::Print;
pub(crate) use print::Prints;
use quota::Quota;
pub use run::Report;

use crate::value::text::Text;
use crate::value::{Value, ValueType};

/// The number of faults that are kept. Later ones are only counted, so that memory stays bounded.
pub(crate) const FAULTS_KEPT: usize = 1000;

/// All collections of a run, sorted by key. `to_string` makes a table of them.
///
/// A key and the type of the value name a collection. Dots in keys make groups: `windows.open` and `windows.closed`
/// belong to the group `windows`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reports {
    collections: BTreeMap<(Text, ValueType), Collection>,
    /// Its entries are the collections and the different texts.
    quota: Quota,
}

/// The values reported under one key with one type.
#[derive(Clone, Debug, PartialEq)]
pub struct Collection {
    key: Text,
    ty: ValueType,
    summary: Summary,
    texts: BTreeMap<Text, u64>,
}

/// The statistics of a collection. NaN is counted but takes no part in sum and extremes. Truth values are 1 and 0.
/// For text, only the count has a meaning.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// The number of values, `nans` included.
    pub count: u64,
    /// The number of values that are NaN.
    pub nans: u64,
    /// The number of values in `sum` and the extremes.
    pub numbers: u64,
    /// The sum, added up in the order of the run.
    pub sum: f64,
    /// The smallest and the largest value.
    extremes: Option<(f64, f64)>,
}

impl Summary {
    fn add(&mut self, value: &Value) {
        self.count += 1;
        match *value {
            Value::Float(number) if number.is_nan() => self.nans += 1,
            Value::Float(number) => self.add_number(number),
            Value::Bool(truth) => self.add_number(f64::from(u8::from(truth))),
            _ => {}
        }
    }

    fn add_number(&mut self, number: f64) {
        self.numbers += 1;
        self.sum += number;
        let (low, high) = self.extremes.unwrap_or((number, number));
        self.extremes = Some((low.min(number), high.max(number)));
    }

    fn merge(&mut self, other: &Summary) {
        self.count += other.count;
        self.nans += other.nans;
        self.numbers += other.numbers;
        self.sum += other.sum;
        self.extremes = match (self.extremes, other.extremes) {
            (Some((low, high)), Some((l, h))) => Some((low.min(l), high.max(h))),
            (mine, theirs) => mine.or(theirs),
        };
    }

    /// The mean of the numbers, if there are any.
    pub fn average(&self) -> Option<f64> {
        (self.numbers != 0).then(|| self.sum / self.numbers as f64)
    }

    /// The smallest number, if there are any.
    pub fn min(&self) -> Option<f64> {
        self.extremes.map(|(low, _)| low)
    }

    /// The largest number, if there are any.
    pub fn max(&self) -> Option<f64> {
        self.extremes.map(|(_, high)| high)
    }
}

impl Collection {
    /// The key.
    pub fn key(&self) -> &str {
        &self.key
    }

    /// The type of its values.
    pub fn ty(&self) -> ValueType {
        self.ty
    }

    /// The statistics.
    pub fn summary(&self) -> &Summary {
        &self.summary
    }

    /// The different texts, sorted, each with the number of its reports. Empty unless the values are text.
    pub fn texts(&self) -> impl ExactSizeIterator<Item = (&str, u64)> + '_ {
        self.texts.iter().map(|(text, count)| (text.as_str(), *count))
    }

    /// Adds `count` reports of a text. Returns false if there was no room for it.
    fn add_text(&mut self, text: Text, count: u64, quota: &mut Quota, limit: u64) -> bool {
        match self.texts.entry(text) {
            Entry::Occupied(mut known) => *known.get_mut() += count,
            Entry::Vacant(place) if quota.take(place.key().len(), limit) => _ = place.insert(count),
            Entry::Vacant(_) => {
                // `take` has counted one of them.
                quota.left_out += count.saturating_sub(1);
                return false;
            }
        }
        true
    }
}

impl<'a> IntoIterator for &'a Reports {
    type Item = &'a Collection;
    type IntoIter = std::collections::btree_map::Values<'a, (Text, ValueType), Collection>;

    fn into_iter(self) -> Self::IntoIter {
        self.collections.values()
    }
}

impl Reports {
    /// The collections, sorted by key. Under one key, numbers come before truth values and truth values before text.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &Collection> + Clone + '_ {
        self.collections.values()
    }

    /// The collection of a key. If the key has collections of several types, the first of them.
    pub fn get(&self, key: &str) -> Option<&Collection> {
        let from = (Text::from(key), ValueType::Float);
        self.collections.range(from..).next().map(|(_, found)| found).filter(|found| found.key() == key)
    }

    /// The collection of a key and a type.
    pub fn of_type(&self, key: &str, ty: ValueType) -> Option<&Collection> {
        self.collections.get(&(Text::from(key), ty))
    }

    /// The statistics of a group: of all collections whose key is `name` or begins with `name` and a dot.
    pub fn group(&self, name: &str) -> Summary {
        let mut sum = Summary::default();
        let is_in = |key: &str| key.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
        self.iter().filter(|collection| is_in(collection.key())).for_each(|it| sum.merge(&it.summary));
        sum
    }

    /// Returns true if there are no reports.
    pub fn is_empty(&self) -> bool {
        self.collections.is_empty()
    }

    /// The number of values beyond the limit, each a new key or a new text; see
    /// [`Limits::reports`](crate::run::settings::Limits::reports). A fault reports the first.
    pub fn left_out(&self) -> u64 {
        self.quota.left_out
    }

    /// Adds a value. Returns false if there was no room for all of it.
    pub(crate) fn add(&mut self, key: Text, value: Value, limit: u64) -> bool {
        let Some((collection, quota)) = self.collection((key, value.ty()), limit) else { return false };
        collection.summary.add(&value);
        match value {
            Value::Text(text) => collection.add_text(text, 1, quota, limit),
            _ => true,
        }
    }

    /// The collection of a key and a type, which is new if there is room for it.
    fn collection(&mut self, id: (Text, ValueType), limit: u64) -> Option<(&mut Collection, &mut Quota)> {
        let Reports { collections, quota } = self;
        let collection = match collections.entry(id) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(place) => {
                let (key, ty) = place.key().clone();
                if !quota.take(key.len(), limit) {
                    return None;
                }
                place.insert(Collection { key, ty, summary: Summary::default(), texts: BTreeMap::new() })
            }
        };
        Some((collection, quota))
    }
}
