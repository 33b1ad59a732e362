//! The materials of a mesh: a list of the caller's own type. Geometry compares, joins and hands on, no more.

use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

use super::distinct::Distinct;

/// A list of materials of any type, shared by meshes. Faces have the index of a material ([`FaceTag::material`](super::FaceTag::material)).
///
/// ```
/// use cga_geometry::mesh::Materials;
///
/// let materials = Materials::from(["brick", "tile"]);
/// assert_eq!(materials.list::<&str>(), ["brick", "tile"]);
/// assert!(materials.list::<u32>().is_empty(), "the list has another type");
/// ```
#[derive(Clone, Debug, Default)]
pub struct Materials(Option<Arc<dyn List>>);

/// The numbers of the materials of one list in a joined list.
pub(super) type MaterialNumbers = Vec<u32>;

trait List: Any + Debug + Send + Sync {
    fn len(&self) -> usize;

    fn as_any(&self) -> &dyn Any;

    fn is_equal(&self, other: &dyn List) -> bool;

    fn are_equal(&self, one: usize, other: usize) -> bool;

    /// All lists as one, in which most equal elements are one.
    fn joined(&self, lists: &[&Materials]) -> (Materials, Vec<MaterialNumbers>);
}

impl<M: Clone + PartialEq + Debug + Send + Sync + 'static> List for Vec<M> {
    fn len(&self) -> usize {
        Vec::len(self)
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn is_equal(&self, other: &dyn List) -> bool {
        other.as_any().downcast_ref::<Vec<M>>().is_some_and(|other| self == other)
    }

    fn are_equal(&self, one: usize, other: usize) -> bool {
        self.get(one) == self.get(other)
    }

    fn joined(&self, lists: &[&Materials]) -> (Materials, Vec<MaterialNumbers>) {
        let mut all = Distinct::default();
        let numbers = lists.iter().map(|list| all.numbers(list.list::<M>())).collect();
        (Materials::from(all.into_list()), numbers)
    }
}

impl Materials {
    /// The materials. Empty if they are of another type.
    pub fn list<M: 'static>(&self) -> &[M] {
        self.0.as_ref().and_then(|list| list.as_any().downcast_ref::<Vec<M>>()).map_or(&[], Vec::as_slice)
    }

    /// The number of materials.
    pub fn len(&self) -> usize {
        self.0.as_ref().map_or(0, |list| list.len())
    }

    /// Returns true if there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Returns true if both are one list in memory.
    pub fn is_same_list(&self, other: &Materials) -> bool {
        let place = |materials: &Materials| materials.0.as_ref().map(|list| Arc::as_ptr(list).cast::<()>());
        place(self) == place(other)
    }

    /// Returns true if the materials with two numbers are equal, or both missing.
    pub(crate) fn are_equal(&self, one: u32, other: u32) -> bool {
        one == other || self.0.as_ref().is_none_or(|list| list.are_equal(one as usize, other as usize))
    }

    /// All lists as one, and the numbers of their materials there. Lists of another type than the first are left out.
    pub(super) fn joined(lists: &[&Materials]) -> (Materials, Vec<MaterialNumbers>) {
        match lists.iter().find(|list| !list.is_empty()).and_then(|list| list.0.as_ref()) {
            Some(first) => first.joined(lists),
            None => (Materials::default(), vec![MaterialNumbers::new(); lists.len()]),
        }
    }
}

impl PartialEq for Materials {
    fn eq(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(one), Some(other)) => Arc::ptr_eq(one, other) || one.is_equal(&**other),
            _ => self.is_empty() && other.is_empty(),
        }
    }
}

impl<M: Clone + PartialEq + Debug + Send + Sync + 'static> From<Vec<M>> for Materials {
    fn from(list: Vec<M>) -> Self {
        Materials((!list.is_empty()).then(|| Arc::new(list) as Arc<dyn List>))
    }
}

impl<M: Clone + PartialEq + Debug + Send + Sync + 'static, const N: usize> From<[M; N]> for Materials {
    fn from(list: [M; N]) -> Self {
        Materials::from(Vec::from(list))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_one_type_are_compared_and_joined() {
        let [one, two] = [Materials::from(["a", "b", "a"]), Materials::from(["b", "c"])];
        assert!(one == one.clone() && one.is_same_list(&one.clone()) && one != two && !one.is_same_list(&two));
        assert!(one.are_equal(0, 2) && !one.are_equal(0, 1) && one.are_equal(7, 8) && !one.are_equal(0, 8));
        let (all, numbers) = Materials::joined(&[&Materials::default(), &one, &two]);
        assert_eq!((all.list::<&str>(), numbers), (&["a", "b", "c"][..], vec![vec![], vec![0, 1, 0], vec![1, 2]]));
    }

    #[test]
    fn lists_of_other_types_are_empty() {
        let [numbers, names] = [Materials::from([1, 2]), Materials::from(["a"])];
        assert!(numbers != names && names.list::<i32>().is_empty() && names.len() == 1);
        let (all, found) = Materials::joined(&[&numbers, &names]);
        assert_eq!((all.list::<i32>(), found), (&[1, 2][..], vec![vec![0, 1], vec![]]));
        assert_eq!(Materials::from(Vec::<u8>::new()), Materials::default());
    }
}
