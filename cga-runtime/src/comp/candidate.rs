//! The components that conditions test.

use super::part::ComponentPart;
use super::select::{Sense, Subcomponent, Word};
use super::source::ComponentSource;
use crate::comp::orientation::Orientation;
use crate::shape::seed::Tag;
use crate::shape::{Counter, Shape};
use crate::value::text::Text;

/// `isTagged(query)` (*comp operation*).
pub fn is_tagged(candidate: &mut Candidate<'_>, query: Text) -> bool {
    candidate.tagged(&query, None)
}

/// `isTagged(query, e | v)` (*comp operation*).
pub fn is_tagged_at(candidate: &mut Candidate<'_>, query: Text, of: Subcomponent) -> bool {
    candidate.tagged(&query, Some(of))
}

/// A component that no arm has taken yet. Functions in a condition are evaluated on its shape, which has the pivot
/// and the axes of the divided shape: `geometry.isOriented(top)` means the same as the selector `top` (*comp
/// operation*, logical selection expressions).
#[derive(Debug)]
pub struct Candidate<'c> {
    pub(super) source: &'c ComponentSource,
    pub(super) looks: &'c Orientation,
    pub(super) parent: &'c Shape,
    pub(super) number: usize,
    shape: Option<Shape>,
    /// True if it was found to be an edge of a roof.
    pub(super) as_roof: bool,
}

impl<'c> Candidate<'c> {
    pub(super) fn new(source: &'c ComponentSource, looks: &'c Orientation, parent: &'c Shape, number: usize) -> Self {
        Candidate { source, looks, parent, number, shape: None, as_roof: false }
    }

    /// Returns true if a selector matches the component.
    #[inline]
    pub fn is(&mut self, word: Word) -> bool {
        let takes = self.source.is(self.looks, self.number, word);
        self.as_roof |= takes && matches!(word.0, Sense::Roof(_));
        takes
    }

    /// Returns true if a query matches one of its tags, or one of its subcomponents' tags.
    fn tagged(&self, query: &str, of: Option<Subcomponent>) -> bool {
        match self.source {
            ComponentSource::Mesh(parts) => parts.tagged(self.number, of, query),
            ComponentSource::Quads(quads) => quads.tagged(self.number, of, query),
            ComponentSource::Wire(parts) => parts.tagged(self.number, of, query),
        }
    }

    /// The shape of the component.
    pub fn shape(&mut self) -> &mut Shape {
        let Candidate { source, parent, number, shape, .. } = self;
        shape.get_or_insert_with(|| {
            let part = source.kept(parent, &[*number as u32], false);
            let seed = parent.seed.child(Tag::Candidate, *number as u32);
            let ComponentPart { scope, pivot, geometry } = part;
            Shape { scope, pivot, geometry, seed, comp: Counter::NONE, ..Shape::clone(parent) }
        })
    }
}
