//! Templates: repeated parts are derived once and replayed.
//!
//! A rule in a group that repeats is *rigid* if its result depends on the size of its shape alone, not on its place,
//! seed or counters. The compiler knows the rigid rules. Such a rule is derived once at the origin, along the
//! axes of the world, and its leaves are kept: a *template*. A template is turned once for each base (a façade), and
//! a repetition is the template moved to its place. This defines the positions below a repeat, whether a template was
//! kept or is made again.
//!
//! A rule called by a rigid rule may be non-rigid. The call is then a *hole*: each repetition makes the call itself,
//! at its place and with a seed that is affine in the seed of the repetition. A derivation that makes a fault or a
//! mesh makes no template, and is run like any other.

mod part_id;
mod record;
mod repeat;
mod replay;

use std::ops::Range;
use std::rc::Rc;

use glam::{DMat3, DVec3};

use crate::geometry::Axis;
use crate::geometry::each::Each;
use crate::run::sink::corners::{PlacedBox, four};
use crate::shape::axes::Axes;
use crate::shape::base::Form;
use crate::shape::look_id::LookId;
use crate::shape::unit::UnitMesh;
use crate::shape::{Counter, ShapeRef};

pub use part_id::PartId;
pub(crate) use record::Tape;
pub use replay::Replay;

/// The number of templates kept for a place in the rules, the last ones used.
const KEPT: usize = 16;

/// The number of axes for which a template is kept turned, the last new ones: four for buildings along the axes of
/// the world.
const KEPT_AXES: usize = 4;

/// The largest number of leaves, and of holes, in a template. The leaves of small templates stay in the nearest cache
/// while they are written again and again.
const MOST: usize = 64;

/// The templates of a session, by place in the rules.
#[derive(Debug)]
pub(crate) struct Templates<C> {
    places: Vec<Vec<TemplateEntry<C>>>,
}

/// A template, or the knowledge that a shape has none.
#[derive(Debug)]
struct TemplateEntry<C> {
    key: TemplateKey,
    template: Option<Rc<Template<C>>>,
    /// The template turned to the axes of bases.
    turned: Vec<Rc<Turned>>,
}

/// The properties of a shape that determine its template.
#[derive(Clone, Copy, Debug)]
struct TemplateKey {
    size: DVec3,
    form: Form,
    unit: UnitMesh,
    look: LookId,
    /// True if the shape has texture coordinates. For a look without a number, `look` does not tell.
    has_coordinates: bool,
    /// The axes along which coordinates are constant. A move along another axis makes a shape with another base.
    constant: [bool; 3],
    /// True if boxes are meshes in a sink because their sides have different coordinates.
    has_sides: bool,
    /// The extent below which shapes were not split further; NaN if it made no difference.
    too_small: f64,
}

/// The result of a rigid rule on a shape at the origin.
#[derive(Debug)]
struct Template<C> {
    /// The number of derived shapes, without leaves.
    shapes: u64,
    /// The highest count of shapes that the derivation requested room for.
    room: u64,
    body: TemplateBody,
    holes: Vec<Hole<C>>,
}

/// The leaves of a template.
#[derive(Debug)]
struct TemplateBody {
    /// The number of the template in the process.
    number: u64,
    leaves: Vec<TemplateLeaf>,
    /// The axes of the leaves.
    frames: Vec<Axes>,
    /// The ranges of leaves before, between and after the holes.
    segments: Vec<LeafRange>,
    marks: Vec<Mark>,
    rows: Vec<LeafRow>,
}

/// A leaf with its position in a template.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TemplateLeaf {
    origin: DVec3,
    pub(crate) size: DVec3,
    pub(crate) unit: UnitMesh,
    /// The form: a rectangle or a box.
    pub(crate) form: Form,
    /// The index of its axes in `frames`.
    frame: u32,
    rule: u32,
    look: LookId,
}

/// The leaves between two holes.
#[derive(Clone, Debug)]
struct LeafRange {
    leaves: Range<usize>,
    marks: Range<usize>,
    rows: Range<usize>,
    /// The number of vertices if faces share none.
    corners: usize,
    /// True if all leaves are boxes or rectangles across z.
    is_plain: bool,
    /// True if some leaves may have texture coordinates.
    may_have_coordinates: bool,
}

/// Consecutive leaves with equal rule and look.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mark {
    pub(crate) rule: u32,
    pub(crate) look: LookId,
    /// The number of leaves, and of their vertices if faces share none.
    pub(crate) leaves: usize,
    pub(crate) corners: usize,
    /// The vertices of the segment before these leaves.
    pub(crate) before: u32,
}

/// Consecutive leaves that are all rectangles, or all boxes, along the same axes.
#[derive(Clone, Debug)]
pub(crate) struct LeafRow {
    pub(crate) is_box: bool,
    frame: u32,
    leaves: Range<usize>,
}

/// A call that each repetition makes itself.
#[derive(Clone, Debug)]
struct Hole<C> {
    /// The number of leaves before the call.
    at: usize,
    origin: DVec3,
    size: DVec3,
    unit: UnitMesh,
    form: Form,
    /// True if it has the axes of the base after the base has grown.
    is_raised: bool,
    look: LookId,
    /// The factor and the summand that give its seed from the seed of the repetition.
    seed: [u64; 2],
    split: Counter,
    /// The stack that the call reserves.
    levels: u32,
    stack: u32,
    call: C,
    /// The rules between the repetition and the call.
    trail: Box<[u32]>,
}

/// A template turned to the axes of bases.
#[derive(Debug)]
struct Turned {
    axes: Vec<Axes>,
    /// The leaves relative to the origin of the repetition, along the axes of the world.
    leaves: Vec<PlacedBox>,
    holes: Vec<DVec3>,
}

/// The counters of the recorded shape. A hole with these counters gets the counters of the repetition.
const INHERITED: Counter = Counter::of(i32::MIN, 0);

impl TemplateKey {
    fn of(part: &ShapeRef<'_>, too_small: f64) -> Self {
        TemplateKey {
            size: part.size.get(),
            form: part.form,
            unit: part.unit.get(),
            look: part.look.get(),
            has_coordinates: part.has_coordinates(),
            constant: part.base.constant(),
            has_sides: part.has_sides(),
            too_small,
        }
    }

    #[inline]
    fn fits(&self, part: &ShapeRef<'_>, too_small: f64) -> bool {
        self.size == part.size.get()
            && self.look == part.look.get()
            && self.has_coordinates == part.has_coordinates()
            && self.constant == part.base.constant()
            && self.has_sides == part.has_sides()
            && self.form == part.form
            && self.unit.is(part.unit.get())
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
    fn find(&mut self, place: u32, part: &ShapeRef<'_>, too_small: f64) -> Option<&mut TemplateEntry<C>> {
        let list = self.places.get_mut(place as usize)?;
        if let Some(last) = list.last()
            && last.key.fits(part, too_small)
        {
            return list.last_mut();
        }
        let at = list.iter().position(|entry| entry.key.fits(part, too_small))?;
        // The last one used is the last in the list.
        let last = list.len() - 1;
        list.swap(at, last);
        list.last_mut()
    }

    fn keep(&mut self, place: u32, entry: TemplateEntry<C>) -> Option<&mut TemplateEntry<C>> {
        let place = place as usize;
        if self.places.len() <= place {
            self.places.resize_with(place + 1, Vec::new);
        }
        let list = &mut self.places[place];
        if list.len() == KEPT {
            list.remove(0);
        }
        list.push(entry);
        list.last_mut()
    }
}

impl<C> TemplateEntry<C> {
    /// The template turned to axes, if there is a template.
    #[inline]
    fn turned(&mut self, axes: &Axes) -> Option<(Rc<Template<C>>, Rc<Turned>)> {
        let template = self.template.clone()?;
        let turned = match self.turned.iter().find(|turned| turned.axes[0].is(&axes.matrix)) {
            Some(known) => known.clone(),
            None => self.turn(&template, axes),
        };
        Some((template, turned))
    }

    #[cold]
    #[inline(never)]
    fn turn(&mut self, template: &Template<C>, axes: &Axes) -> Rc<Turned> {
        let turned = Rc::new(template.turned(axes));
        if self.turned.len() == KEPT_AXES {
            self.turned.remove(0);
        }
        self.turned.push(turned.clone());
        turned
    }
}

impl<C> Template<C> {
    /// Turns the template to axes.
    fn turned(&self, axes: &Axes) -> Turned {
        let turn = |frame: &Axes| match frame.matrix == DMat3::IDENTITY {
            true => *axes,
            false => Axes::new(axes.matrix * frame.matrix),
        };
        let frames: Vec<Axes> = self.body.frames.iter().map(turn).collect();
        let leaves = self.body.leaves.iter().map(|leaf| {
            let (frame, size) = (&frames[leaf.frame as usize], leaf.size);
            let sides = [(Axis::X, size.x), (Axis::Y, size.y), (Axis::Z, size.z)];
            PlacedBox {
                origin: four(axes.matrix * leaf.origin),
                sides: sides.each(|(axis, size)| frame.along(axis) * size),
            }
        });
        Turned {
            leaves: leaves.collect(),
            holes: self.holes.iter().map(|hole| axes.matrix * hole.origin).collect(),
            axes: frames,
        }
    }
}
