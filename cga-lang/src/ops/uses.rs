//! The parts of a shape that are read.

use std::ops::BitOr;

/// The parts of the current shape that an expression, an operation, a rule or a function reads or changes: a set of the
/// constants.
///
/// A part too many costs time. A part that is missing is a promise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Uses(u16);

impl Uses {
    /// Nothing.
    pub const NONE: Uses = Uses(0);
    /// Everything that Rust code can read of the shape that it gets. It cannot ask about other shapes.
    pub const ALL: Uses = Uses((1 << 12) - 1);
    /// Random numbers are drawn from the shape's seed, or the seed itself is read or set: `rand`, `p`, chances in
    /// expressions and rules, `seedian`.
    pub const DRAWS: Uses = Uses(1);
    /// `split.index` is read.
    pub const INDEX: Uses = Uses(1 << 1);
    /// `split.total` is read.
    pub const TOTAL: Uses = Uses(1 << 2);
    /// The counters of the last split.
    pub const COUNTERS: Uses = Uses::INDEX.and(Uses::TOTAL);
    /// An expression reads sizes of the scope: `scope.sx`. The scope of operations and splits does not count, because they
    /// always have it.
    pub const SIZE: Uses = Uses(1 << 3);
    /// The orientation of the scope in the world is read: `world.up`.
    pub const AXES: Uses = Uses(1 << 10);
    /// An expression or an operation reads the position or orientation of the scope in the world: `scope.elevation`. The
    /// size counts as read, too.
    pub const PLACE: Uses = Uses(1 << 4).and(Uses::SIZE).and(Uses::AXES);
    /// More than the scope and the material is read or changed, and moves with the scope: the geometry, its tags and normals, what is
    /// made of them. Two shapes of one size in two places give the same in the coordinates of their scopes.
    pub const BODY: Uses = Uses(1 << 9);
    /// More than the scope and the material is read or changed: the pivot, the geometry, trim planes, `comp.index`, the
    /// values of the material, tags.
    pub const WHOLE: Uses = Uses(1 << 5).and(Uses::BODY);
    /// An attribute or constant is read that may have a value of its own in each shape (`is_set`).
    pub const STATE: Uses = Uses(1 << 6);
    /// The run or the host program is queried or changed: prints, files, Rust code, the limit of calls, the
    /// initial shape. Such a derivation must not be replayed. Faults alone do not count.
    pub const SAYS: Uses = Uses(1 << 7);

    /// A value is reported. A derivation that is replayed reports it again.
    pub const REPORTS: Uses = Uses(1 << 11);

    /// Tags of edges or vertices are read or set: `isTagged`, `geometry.hasTags`, `tag`. In grammars without such a use,
    /// operations do not tag the edges that they make.
    pub const TAGS: Uses = Uses(1 << 8);

    /// Other closed shapes are asked about: `overlaps`, `inside`, `touches`. The answer differs from place to place, and between the
    /// derivations of one initial shape.
    pub const OCCLUSION: Uses = Uses(1 << 12).and(Uses::ASKS);
    /// Labelled shapes are asked about: `minimumDistance`, `contextCount`, `contextCompare`.
    pub const CONTEXT: Uses = Uses(1 << 13).and(Uses::ASKS);
    /// The place in the tree of shapes is read: `getTreeKey`.
    pub const TREE_KEY: Uses = Uses(1 << 14).and(Uses::SAYS);
    /// A labelled copy of the shape is left for queries: `label`.
    pub const LABELS: Uses = Uses(1 << 15).and(Uses::ASKS);
    /// The common part of all queries of other shapes: they read the place, and a derivation with one is never replayed. A slim shape has its
    /// geometry.
    const ASKS: Uses = Uses::PLACE.and(Uses::SAYS);

    /// The union, in constants.
    pub const fn and(self, other: Uses) -> Uses {
        Uses(self.0 | other.0)
    }

    /// The parts that are not in `other`.
    pub const fn but(self, other: Uses) -> Uses {
        Uses(self.0 & !other.0)
    }

    /// Only the counters of the last split.
    pub const fn counters(self) -> Uses {
        Uses(self.0 & Uses::COUNTERS.0)
    }

    /// Returns true if all parts of `other` are used.
    pub const fn has(self, other: Uses) -> bool {
        self.0 & other.0 == other.0
    }

    /// Returns true if nothing is used.
    pub fn is_none(self) -> bool {
        self == Uses::NONE
    }

    /// Returns true if at most sizes of the scope, what moves with it, attributes and constants are read. All shapes of one size
    /// with equal geometry and attributes have these in common.
    pub fn is_rigid(self) -> bool {
        Uses::SIZE.and(Uses::STATE).and(Uses::BODY).and(Uses::TAGS).and(Uses::REPORTS).has(self)
    }

    /// The names of the used parts, in the order of the constants.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        let names = [
            (Uses::DRAWS, "draws"),
            (Uses::INDEX, "index"),
            (Uses::TOTAL, "total"),
            (Uses::SIZE, "scope"),
            (Uses::PLACE, "place"),
            (Uses::AXES, "axes"),
            (Uses::WHOLE, "whole"),
            (Uses::BODY, "body"),
            (Uses::STATE, "state"),
            (Uses::SAYS, "says"),
            (Uses::TAGS, "tags"),
            (Uses::REPORTS, "reports"),
            (Uses::OCCLUSION, "occlusion"),
            (Uses::CONTEXT, "context"),
            (Uses::TREE_KEY, "tree key"),
            (Uses::LABELS, "labels"),
        ];
        let is_shown = move |part: Uses| {
            let is_more =
                (part == Uses::BODY && self.has(Uses::WHOLE)) || (part == Uses::AXES && self.has(Uses::PLACE));
            self.has(part) && !is_more
        };
        names.into_iter().filter(move |(part, _)| is_shown(*part)).map(|(_, name)| name)
    }
}

impl BitOr for Uses {
    type Output = Uses;

    fn bitor(self, other: Uses) -> Uses {
        self.and(other)
    }
}

impl FromIterator<Uses> for Uses {
    /// The union.
    fn from_iter<I: IntoIterator<Item = Uses>>(list: I) -> Uses {
        list.into_iter().fold(Uses::NONE, Uses::and)
    }
}
