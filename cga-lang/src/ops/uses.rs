//! The parts of a shape that are read.

use std::ops::BitOr;

/// The parts of the current shape that an expression, an operation, a rule or a function reads or changes.
///
/// A wrong `true` costs time. A `false` is a promise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uses {
    /// Random numbers are drawn from the shape's seed, or the seed itself is read or set: `rand`, `p`, chances in
    /// expressions and rules, `seedian`.
    pub draws: bool,
    /// `split.index` is read.
    pub index: bool,
    /// `split.total` is read.
    pub total: bool,
    /// An expression reads sizes or the position of the scope: `scope.sx`, `scope.elevation`. The scope of operations
    /// and splits does not count, because they always have it.
    pub scope: bool,
    /// An expression or an operation reads the position or orientation of the scope in the world: `scope.elevation`.
    pub place: bool,
    /// More than the scope and the material is read or changed: the pivot, the geometry, trim planes, `comp.index`, the
    /// values of the material, tags.
    pub whole: bool,
    /// An attribute or constant is read that may have a value of its own in each shape (`is_set`).
    pub state: bool,
    /// The run or the host program is queried or changed: prints, reports, files, Rust code, the limit of calls, the
    /// initial shape. Such a derivation must not be replayed. Faults alone do not count.
    pub says: bool,
}

impl Uses {
    /// Nothing.
    pub const NONE: Uses = Uses {
        draws: false,
        index: false,
        total: false,
        scope: false,
        place: false,
        whole: false,
        state: false,
        says: false,
    };
    /// Everything, as for Rust code that gets the shape.
    pub const ALL: Uses =
        Uses { draws: true, index: true, total: true, scope: true, place: true, whole: true, state: true, says: true };
    /// Random numbers.
    pub const DRAWS: Uses = Uses { draws: true, ..Uses::NONE };
    /// `split.index`.
    pub const INDEX: Uses = Uses { index: true, ..Uses::NONE };
    /// `split.total`.
    pub const TOTAL: Uses = Uses { total: true, ..Uses::NONE };
    /// Sizes of the scope.
    pub const SIZE: Uses = Uses { scope: true, ..Uses::NONE };
    /// The place of the scope in the world.
    pub const PLACE: Uses = Uses { scope: true, place: true, ..Uses::NONE };
    /// The whole shape.
    pub const WHOLE: Uses = Uses { whole: true, ..Uses::NONE };
    /// Values that shapes hold.
    pub const STATE: Uses = Uses { state: true, ..Uses::NONE };
    /// The run.
    pub const SAYS: Uses = Uses { says: true, ..Uses::NONE };

    /// The union, in constants.
    pub const fn and(self, other: Uses) -> Uses {
        Uses {
            draws: self.draws || other.draws,
            index: self.index || other.index,
            total: self.total || other.total,
            scope: self.scope || other.scope,
            place: self.place || other.place,
            whole: self.whole || other.whole,
            state: self.state || other.state,
            says: self.says || other.says,
        }
    }

    /// Only the counters of the last split.
    pub const fn counters(self) -> Uses {
        Uses { index: self.index, total: self.total, ..Uses::NONE }
    }

    /// Everything except the counters of the last split.
    pub const fn without_counters(self) -> Uses {
        Uses { index: false, total: false, ..self }
    }

    /// Returns true if nothing is used.
    pub fn is_none(self) -> bool {
        self == Uses::NONE
    }

    /// Returns true if at most sizes of the scope are read. All shapes of one size have these in common.
    pub fn is_rigid(self) -> bool {
        self.and(Uses::SIZE) == Uses::SIZE
    }

    /// The names of the used parts, in the order of the fields.
    pub fn names(self) -> impl Iterator<Item = &'static str> {
        let Uses { draws, index, total, scope, place, whole, state, says } = self;
        let flags = [
            (draws, "draws"),
            (index, "index"),
            (total, "total"),
            (scope, "scope"),
            (place, "place"),
            (whole, "whole"),
            (state, "state"),
            (says, "says"),
        ];
        flags.into_iter().filter(|(flag, _)| *flag).map(|(_, name)| name)
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
