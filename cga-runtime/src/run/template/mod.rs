//! Templates: repeated parts are derived once and replayed.
//!
//! A rule in a group that repeats is *rigid* if its result depends on the size of its shape, its arguments, attributes and constants, not
//! on its place, seed or counters. The compiler knows the rigid rules. Such a rule is derived once at the origin, along the
//! axes of the world, and its leaves are kept: a *template*. A template is turned once for each base (a façade), and
//! a repetition is the template moved to its place. This defines the positions below a repeat, whether a template was
//! kept or is made again.
//!
//! A rule called by a rigid rule may be non-rigid. The call is then a *hole*: each repetition makes the call itself,
//! at its place and with a seed that is affine in the seed of the repetition. A derivation that makes a fault makes no template, and is
//! run like any other.
//!
//! Parts that such a call makes again and again, with equal sizes, have templates of their own if they are meshes. The plan of a grammar knows
//! them.
//!
//! The projections of a shape are unknown while its template is recorded: a rule that reads one has no template.
//!
//! A template of rectangles and boxes is recorded without the colour of its shape, and painted at its places.
//!
//! Leaves that do not fill their scopes are kept as meshes with their places. Where a base has trim planes, and what was inserted reaches
//! one of them, a repetition runs like any other.

mod key;
mod mesh_leaf;
mod paint;
mod part_id;
mod record;
mod repeat;
mod replay;
mod slot;
mod tape;

use std::collections::HashMap;
use std::ops::Range;
use std::rc::Rc;

use glam::{DAffine3, DMat3, DVec3};

use crate::fixed_hash::FixedState;
use crate::geometry::Axis;
use crate::geometry::mesh::Bounds;
use crate::run::env::mesh_counts::MeshCounts;
use crate::run::env::records::TapedReport;
use crate::run::sink::corners::PlacedBox;
use crate::shape::axes::Axes;
use crate::shape::base::Form;
use crate::shape::look_id::LookId;
use crate::shape::look_table::LookTable;
use crate::shape::unit::UnitMesh;
use crate::shape::{Counter, ShapeRef};
use crate::value::read::KeptRead;

use key::TemplateKey;
use mesh_leaf::MeshLeaf;
use paint::Paint;
pub use part_id::PartId;
use record::RecordedLists;
pub use replay::Replay;
pub use slot::RepeatedSlot;
pub(crate) use tape::Tape;

/// The number of leaves, holes and corners of meshes that a session keeps in templates, each turn of a template counted: about 30 MB. Beyond
/// it the templates are made again.
const KEPT: usize = 1 << 17;

/// The number of axes for which a template is kept turned, the last new ones: four for buildings along the axes of
/// the world.
const KEPT_AXES: usize = 4;

/// The number of looks for which a template is kept painted, the last new ones.
const KEPT_PAINTS: usize = 4;

/// The largest number of leaves, and of holes, in a template. The leaves of small templates stay in the nearest cache
/// while they are written again and again.
const MOST: usize = 64;

/// The templates of a session.
#[derive(Debug)]
pub(crate) struct Templates<C> {
    /// By the hash of their keys.
    entries: HashMap<u64, Vec<TemplateEntry<C>>, FixedState>,
    /// The number of leaves, holes and corners of meshes in them, and of entries.
    kept: usize,
    /// The lists of the last recording, for the next one.
    lists: RecordedLists,
}

/// A template, or the knowledge that a shape has none.
#[derive(Debug)]
struct TemplateEntry<C> {
    key: TemplateKey,
    /// The extent below which shapes were not split further; NaN if it made no difference.
    too_small: f64,
    template: Option<Rc<Template<C>>>,
    /// The template turned to the axes of bases.
    turned: Vec<Rc<Turned>>,
    /// The paints of the template by the look of the part; `None` for all looks.
    paints: Vec<(Option<LookId>, Rc<Paint>)>,
}

/// The result of a rigid rule on a shape at the origin.
#[derive(Debug)]
struct Template<C> {
    counts: TemplateCounts,
    body: TemplateBody,
    breaks: Vec<TemplateBreak<C>>,
    /// A box around everything that trim planes may cut, if there is anything.
    reach: Option<Bounds>,
    /// The values that it depends on.
    reads: Box<[KeptRead]>,
    /// Its looks with an open colour.
    open: Box<[LookId]>,
    /// False if some looks have temporary numbers.
    is_lasting: bool,
}

/// The counts of a derivation.
#[derive(Clone, Copy, Debug)]
struct TemplateCounts {
    /// The number of derived shapes, without leaves that fill their scopes.
    shapes: u64,
    /// The highest count of shapes that the derivation requested room for.
    room: u64,
    meshes: MeshCounts,
}

/// A call, a leaf or a report between two ranges of leaves that fill their scopes.
#[derive(Debug)]
enum TemplateBreak<C> {
    Hole(Hole<C>),
    Leaf(MeshLeaf),
    /// A value that is reported. Its trail begins at the repetition.
    Report(TapedReport),
}

/// The leaves of a template that fill their scopes.
#[derive(Debug)]
struct TemplateBody {
    /// True if it has the axes of the base, and false if it has the axes of the world.
    is_turned: bool,
    leaves: Box<[TemplateLeaf]>,
    /// The axes of the leaves.
    frames: Box<[Axes]>,
    /// The ranges of leaves before, between and after the breaks.
    segments: Box<[LeafRange]>,
    marks: Box<[Mark]>,
    rows: Box<[LeafRow]>,
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

/// The leaves between two breaks.
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
    /// The number of leaves before the call: those that fill their scopes, and the others.
    at: usize,
    others: usize,
    /// The number of values that were reported before the call.
    reports: usize,
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
    breaks: Vec<TurnedBreak>,
}

/// The origin of a break relative to the origin of the repetition, along the axes of the world, and more for a leaf.
#[derive(Clone, Copy, Debug)]
struct TurnedBreak {
    origin: DVec3,
    /// The axes of the scope of a leaf.
    axes: DMat3,
    /// The map from the coordinates of its mesh.
    placement: DAffine3,
}

/// A template, turned and painted for a part.
struct Found<C> {
    template: Rc<Template<C>>,
    turned: Rc<Turned>,
    paint: Rc<Paint>,
}

/// The counters of the recorded shape. A hole with these counters gets the counters of the repetition.
const INHERITED: Counter = Counter::of(i32::MIN, 0);

impl<C> Default for Templates<C> {
    fn default() -> Self {
        Templates { entries: HashMap::default(), kept: 0, lists: RecordedLists::default() }
    }
}

impl<C> Templates<C> {
    /// The entry for a shape with that hash, if there is one.
    fn find(
        &mut self,
        hash: u64,
        slot: &RepeatedSlot<'_>,
        (part, look): (&ShapeRef<'_>, LookId),
        too_small: f64,
    ) -> Option<&mut TemplateEntry<C>> {
        let is_equal = |known: f64| known == too_small || known.is_nan();
        let list = self.entries.get_mut(&hash)?;
        list.iter_mut().find(|entry| is_equal(entry.too_small) && entry.key.fits(slot, part, look))
    }

    fn keep(&mut self, hash: u64, entry: TemplateEntry<C>) {
        let size = entry.template.as_ref().map_or(0, |template| template.corner_count() + 2 * template.len());
        self.make_room(1 + size);
        self.entries.entry(hash).or_default().push(entry);
    }

    /// Counts more of them.
    fn make_room(&mut self, more: usize) {
        self.kept += more;
        if KEPT < self.kept {
            self.entries.clear();
            self.kept = more;
        }
    }
}

/// Adds a value to a list of the last `most` values.
fn keep_last<T>(list: &mut Vec<T>, new: T, most: usize) {
    if list.len() == most {
        list.remove(0);
    }
    list.push(new);
}

impl<C> TemplateEntry<C> {
    /// The template turned to axes, if there is a template, and true if it was turned just now.
    fn turned(&mut self, axes: &Axes) -> Option<(Rc<Template<C>>, Rc<Turned>, bool)> {
        let template = self.template.clone()?;
        // It was recorded along the axes that it reads.
        let along_world = Axes::new(DMat3::IDENTITY);
        let axes = if self.key.axes.is_some() { &along_world } else { axes };
        if let Some(known) = self.turned.iter().find(|turned| turned.axes[0].is(&axes.matrix)) {
            return Some((template, known.clone(), false));
        }
        let turned = Rc::new(template.turned(axes));
        keep_last(&mut self.turned, turned.clone(), KEPT_AXES);
        Some((template, turned, true))
    }

    /// The paint of the template for parts with a look, if there is a template.
    fn paint(&mut self, own: LookId, ids: &mut LookTable) -> Option<Rc<Paint>> {
        let open = &self.template.as_ref()?.open;
        let look = (!open.is_empty()).then_some(own);
        if let Some((_, known)) = self.paints.iter().find(|(known, _)| *known == look) {
            return Some(known.clone());
        }
        let paint = Rc::new(Paint::new(open, self.key.look, own, ids));
        if paint.is_lasting {
            keep_last(&mut self.paints, (look, paint.clone()), KEPT_PAINTS);
        }
        Some(paint)
    }
}

impl<C> Template<C> {
    /// The number of leaves and holes.
    fn len(&self) -> usize {
        self.body.leaves.len() + self.breaks.len()
    }

    /// The number of corners of the meshes that it keeps.
    fn corner_count(&self) -> usize {
        let corners = |own: &TemplateBreak<C>| match own {
            TemplateBreak::Leaf(leaf) => leaf.corner_count(),
            TemplateBreak::Hole(_) | TemplateBreak::Report(_) => 0,
        };
        self.breaks.iter().map(corners).sum()
    }

    /// Turns the template to axes.
    fn turned(&self, axes: &Axes) -> Turned {
        let turn = |frame: &Axes| match frame.matrix == DMat3::IDENTITY {
            true => *axes,
            false => Axes::new(axes.matrix * frame.matrix),
        };
        let frames: Vec<Axes> = self.body.frames.iter().map(turn).collect();
        let directions = |axes: &Axes| [axes.along(Axis::X), axes.along(Axis::Y), axes.along(Axis::Z)];
        let [x, y, z] = directions(axes);
        let leaves = self.body.leaves.iter().map(|leaf| {
            let TemplateLeaf { origin, size, .. } = *leaf;
            let [u, v, w] = directions(&frames[leaf.frame as usize]);
            // In the order of a product with the matrix, with the lanes of four coordinates.
            PlacedBox {
                origin: x * origin.x + y * origin.y + z * origin.z,
                sides: [u * size.x, v * size.y, w * size.z],
            }
        });
        Turned {
            leaves: leaves.collect(),
            breaks: self.breaks.iter().map(|own| own.turned(&axes.matrix)).collect(),
            axes: frames,
        }
    }
}

impl<C> TemplateBreak<C> {
    fn turned(&self, axes: &DMat3) -> TurnedBreak {
        let (origin, own, placement) = match self {
            TemplateBreak::Hole(hole) => (hole.origin, DMat3::IDENTITY, DAffine3::IDENTITY),
            TemplateBreak::Leaf(leaf) => (leaf.scope.origin, leaf.scope.axes, leaf.placement()),
            TemplateBreak::Report(..) => (DVec3::ZERO, DMat3::IDENTITY, DAffine3::IDENTITY),
        };
        TurnedBreak { origin: *axes * origin, axes: *axes * own, placement: DAffine3::from_mat3(*axes) * placement }
    }
}
