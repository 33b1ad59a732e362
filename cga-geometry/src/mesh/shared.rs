//! Lists that meshes share.

use std::ops::Deref;
use std::sync::Arc;

/// A list that a mesh shares with its copies. An empty list has no counter of its owners, so threads whose meshes have no names share
/// nothing.
#[derive(Debug)]
pub(crate) struct SharedList<T>(Option<Arc<[T]>>);

impl<T> Default for SharedList<T> {
    fn default() -> Self {
        SharedList(None)
    }
}

impl<T> Clone for SharedList<T> {
    fn clone(&self) -> Self {
        SharedList(self.0.clone())
    }
}

impl<T> SharedList<T> {
    /// Returns true if both are one list in memory, or both are empty.
    pub(crate) fn is(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Some(one), Some(other)) => Arc::ptr_eq(one, other),
            (one, other) => one.is_none() && other.is_none(),
        }
    }
}

impl<T> Deref for SharedList<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        self.0.as_deref().unwrap_or_default()
    }
}

impl<T: PartialEq> PartialEq for SharedList<T> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T> From<Arc<[T]>> for SharedList<T> {
    fn from(list: Arc<[T]>) -> Self {
        SharedList((!list.is_empty()).then_some(list))
    }
}

impl<T> From<Vec<T>> for SharedList<T> {
    fn from(list: Vec<T>) -> Self {
        SharedList((!list.is_empty()).then(|| list.into()))
    }
}

impl<T> From<SharedList<T>> for Arc<[T]> {
    fn from(SharedList(list): SharedList<T>) -> Self {
        list.unwrap_or_else(|| Arc::from([]))
    }
}
