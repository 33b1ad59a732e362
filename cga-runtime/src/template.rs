//! Repeated parts are derived once and replayed.
//!
//! A rule in a group that repeats is *rigid* when its result depends on the size of its shape alone, not on place, seed or
//! counters; code generation knows which are. Such a rule is derived once at the origin, along the axes of the world, and its
//! leaves are kept: a *template*. A template is turned once for each base (a façade), and a repetition is the template moved
//! there. Positions below a repeat are defined in this way, whether a template was kept or is made again.
//!
//! A rule that it calls and that is not rigid itself is a *hole*: a repetition calls it as any rule, with its place, and with
//! a seed that is affine in the seed of the repetition. A derivation that leaves a fault or a mesh makes no template, and is
//! run as any other.

mod record;
mod replay;

use std::ops::Range;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use crate::material::ids::MaterialId;
use crate::shape::axes::Axes;
use crate::shape::base::Form;
use crate::shape::{Counter, ShapeRef};
use crate::unit::UnitMesh;

pub(crate) use record::Tape;
pub use replay::Replay;

/// The templates of a place in the rules that are kept, the last ones used.
const KEPT: usize = 16;

/// The leaves, and the holes, that a template has at most.
const MOST: usize = 64;

/// The templates of a session, by place in the rules.
#[derive(Debug)]
pub(crate) struct Templates<C> {
    places: Vec<Vec<Entry<C>>>,
}

/// A template, or the knowledge that there is none.
#[derive(Debug)]
struct Entry<C> {
    key: Key,
    turned: Option<Arc<Turned<C>>>,
}

/// The properties of a shape that its template depends on.
#[derive(Clone, Copy, Debug)]
struct Key {
    size: DVec3,
    form: Form,
    unit: UnitMesh,
    material: MaterialId,
    /// Extents up to this were not split any further; NaN if that made no difference.
    too_small: f64,
}

/// The result of a rigid rule on a shape at the origin.
#[derive(Debug)]
struct Template<C> {
    /// Shapes derived, without leaves.
    shapes: u64,
    /// The most shapes that the derivation asked room for.
    room: u64,
    leaves: Vec<Record>,
    /// The axes of leaves.
    frames: Vec<DMat3>,
    /// The stretches of leaves before, between and behind the holes.
    segments: Vec<Segment>,
    marks: Vec<Mark>,
    holes: Vec<Hole<C>>,
}

/// A leaf at its place in a template.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Record {
    origin: DVec3,
    size: DVec3,
    pub(crate) unit: UnitMesh,
    /// A rectangle or a box.
    pub(crate) form: Form,
    /// Counts in the frames.
    frame: u32,
    rule: u32,
    material: MaterialId,
}

/// Leaves without a hole between them.
#[derive(Clone, Debug)]
struct Segment {
    leaves: Range<usize>,
    marks: Range<usize>,
    /// The number of vertices when faces share none.
    corners: usize,
    /// True if all leaves are boxes or rectangles across z.
    is_plain: bool,
}

/// Leaves after each other with equal rule and material.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    pub(crate) rule: u32,
    pub(crate) material: MaterialId,
    pub(crate) leaves: usize,
    pub(crate) corners: usize,
}

/// A call of a rule that each repetition makes itself.
#[derive(Clone, Debug)]
struct Hole<C> {
    /// The number of leaves before it.
    at: usize,
    origin: DVec3,
    size: DVec3,
    unit: UnitMesh,
    form: Form,
    /// True if its axes are those of the base after it has grown.
    is_raised: bool,
    material: MaterialId,
    /// The factor and the sum that lead from the seed of the repetition to its own.
    seed: [u64; 2],
    split: Counter,
    /// The stack that the call asks for.
    levels: u32,
    stack: u32,
    call: C,
    /// The rules between the repetition and the call.
    trail: Box<[u32]>,
}

/// A template along the axes of a base.
#[derive(Debug)]
struct Turned<C> {
    template: Arc<Template<C>>,
    /// The number of the base.
    base: u64,
    axes: Vec<Axes>,
    leaves: Vec<Placed>,
    holes: Vec<DVec3>,
}

/// A leaf, relative to the origin of the repetition, in the world.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Placed {
    pub(crate) origin: DVec3,
    pub(crate) sides: DMat3,
}

/// The counters of a shape that is recorded: holes with these get those of the repetition.
const INHERITED: Counter = Counter { index: i32::MIN, total: 0 };

impl Key {
    fn of(part: &ShapeRef<'_>, too_small: f64) -> Self {
        Key { size: part.size, form: part.form, unit: part.unit, material: part.material, too_small }
    }

    #[inline]
    fn fits(&self, part: &ShapeRef<'_>, too_small: f64) -> bool {
        self.size == part.size
            && self.material == part.material
            && self.form == part.form
            && self.unit.is(part.unit)
            && (self.too_small == too_small || self.too_small.is_nan())
    }
}

impl<C> Default for Templates<C> {
    fn default() -> Self {
        Templates { places: Vec::new() }
    }
}

impl<C> Templates<C> {
    /// The entry for a shape, if there is one.
    #[inline]
    fn find(&mut self, place: u32, part: &ShapeRef<'_>, too_small: f64) -> Option<&mut Entry<C>> {
        let list = self.places.get_mut(place as usize)?;
        if let Some(last) = list.last()
            && last.key.fits(part, too_small)
        {
            return list.last_mut();
        }
        let at = list.iter().position(|entry| entry.key.fits(part, too_small))?;
        // The last one used is the last in the list.
        list[at..].rotate_left(1);
        list.last_mut()
    }

    fn keep(&mut self, place: u32, entry: Entry<C>) {
        let place = place as usize;
        if self.places.len() <= place {
            self.places.resize_with(place + 1, Vec::new);
        }
        let list = &mut self.places[place];
        if list.len() == KEPT {
            list.remove(0);
        }
        list.push(entry);
    }
}

impl<C> Template<C> {
    /// Turns it to the axes of a base.
    fn turned(self: &Arc<Self>, base: u64, axes: &Axes) -> Turned<C> {
        let frames: Vec<Axes> = self
            .frames
            .iter()
            .map(|frame| if *frame == DMat3::IDENTITY { *axes } else { Axes::new(axes.matrix * *frame) })
            .collect();
        let leaves = self.leaves.iter().map(|leaf| {
            let frame = &frames[leaf.frame as usize].matrix;
            let sides =
                DMat3::from_cols(frame.x_axis * leaf.size.x, frame.y_axis * leaf.size.y, frame.z_axis * leaf.size.z);
            Placed { origin: axes.matrix * leaf.origin, sides }
        });
        Turned {
            base,
            leaves: leaves.collect(),
            holes: self.holes.iter().map(|hole| axes.matrix * hole.origin).collect(),
            axes: frames,
            template: self.clone(),
        }
    }
}
