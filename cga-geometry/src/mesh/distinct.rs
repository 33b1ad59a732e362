//! Lists without repeated elements, for joined meshes.

/// The number of last elements of a list that are searched for an equal one.
const FAR: usize = 64;

/// A list in which most equal elements are one.
pub(super) struct Distinct<T>(Vec<T>);

impl<T> Default for Distinct<T> {
    fn default() -> Self {
        Distinct(Vec::new())
    }
}

impl<T: PartialEq + Clone> Distinct<T> {
    /// The number of an element in the list.
    fn number(&mut self, element: &T) -> u32 {
        let recent = self.0.len().saturating_sub(FAR);
        let at = self.0[recent..].iter().position(|known| known == element);
        if at.is_none() {
            self.0.push(element.clone());
        }
        at.map_or(self.0.len() - 1, |at| recent + at) as u32
    }

    /// The numbers of the elements of another list.
    pub(super) fn numbers(&mut self, list: &[T]) -> Vec<u32> {
        list.iter().map(|element| self.number(element)).collect()
    }

    /// The elements by number.
    pub(super) fn into_list(self) -> Vec<T> {
        self.0
    }
}
