//! Labelled shapes by label, for context queries.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use super::labelled::{ContextComparison, LabelledShape, is_better};
use crate::geometry::bounds_tree::BoundsTree;
use crate::geometry::mesh::Bounds;
use crate::geometry::small_sort::SmallSort;
use crate::shape::scope::Scope;
use crate::value::text::Text;

/// Labelled shapes of one or several initial shapes, by label. A query can leave out the shapes of one initial shape.
#[derive(Debug, Default)]
pub(crate) struct LabelIndex {
    labels: BTreeMap<Text, LabelList>,
}

/// The shapes with a label, in the order of their initial shapes.
#[derive(Debug, Default)]
struct LabelList {
    shapes: Vec<(usize, LabelledShape)>,
    /// By comparison, the values of all shapes in ascending order, once a query has asked.
    values: [OnceLock<Vec<f64>>; ContextComparison::ALL.len()],
    /// The boxes around the scopes.
    tree: OnceLock<BoundsTree>,
}

impl LabelIndex {
    /// Adds a shape of an initial shape. Initial shapes come in the order of their numbers.
    pub(super) fn add(&mut self, label: Text, number: usize, shape: LabelledShape) {
        self.labels.entry(label).or_default().shapes.push((number, shape));
    }

    /// Adds the shapes of an initial shape. Initial shapes come in the order of their numbers.
    pub(crate) fn add_all(&mut self, number: usize, index: &LabelIndex) {
        for (label, list) in &index.labels {
            list.shapes.iter().for_each(|(_, shape)| self.add(label.clone(), number, shape.clone()));
        }
    }

    /// The number of shapes with a label.
    pub(crate) fn count(&self, label: &str, without: Option<usize>) -> usize {
        self.labels.get(label).map_or(0, |list| list.shapes.len() - list.of(without).len())
    }

    /// The number of shapes with a label that are better than a shape.
    pub(crate) fn rank(
        &self,
        label: &str,
        without: Option<usize>,
        own: &LabelledShape,
        by: ContextComparison,
    ) -> usize {
        let Some(list) = self.labels.get(label) else { return 0 };
        let values = list.values[by as usize].get_or_init(|| {
            let mut values: Vec<f64> = list.shapes.iter().map(|(_, shape)| shape.value(by)).collect();
            values.small_sort_unstable_by(f64::total_cmp);
            values
        });
        let value = own.value(by);
        let all = values.len() - values.partition_point(|other| !is_better(*other, value));
        all - list.of(without).iter().filter(|(_, shape)| shape.is_better(own, by)).count()
    }

    /// The distance from a scope to the nearest scope of a shape with a label, in metres, or `least` if that is less: what is farther away is
    /// not measured.
    pub(crate) fn least_distance(&self, label: &str, without: Option<usize>, scope: &Scope, least: f64) -> f64 {
        let Some(list) = self.labels.get(label) else { return least };
        let tree = list.tree.get_or_init(|| {
            let boxes: Vec<Bounds> = list.shapes.iter().map(|(_, shape)| shape.around()).collect();
            BoundsTree::of(&boxes)
        });
        let mut nearest = least;
        tree.least(&Bounds::of(scope.corners()), least, |item| {
            let (number, shape) = &list.shapes[item as usize];
            if Some(*number) != without {
                nearest = nearest.min(shape.distance_to(scope, nearest));
            }
            nearest
        })
    }
}

impl LabelList {
    /// The shapes of an initial shape; none without one.
    fn of(&self, number: Option<usize>) -> &[(usize, LabelledShape)] {
        let Some(number) = number else { return &[] };
        let start = self.shapes.partition_point(|(own, _)| *own < number);
        let count = self.shapes[start..].partition_point(|(own, _)| *own == number);
        &self.shapes[start..start + count]
    }
}
