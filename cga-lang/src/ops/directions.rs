//! The directions that components face.

/// Directions in the axes of the scope. A direction is a quadrant and an inclination. The quadrant follows from the
/// largest coordinate, so a component that faces the front is never steeper than 45 degrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Directions(u16);

impl Directions {
    /// No direction.
    pub const NONE: Directions = Directions(0);
    /// Every direction.
    pub const ALL: Directions = Directions(u16::MAX);
    /// To the front, at any inclination.
    pub const FRONT: Directions = Directions(0b0001_0001_0001);
    /// To the back.
    pub const BACK: Directions = Directions(Directions::FRONT.0 << 1);
    /// To the left.
    pub const LEFT: Directions = Directions(Directions::FRONT.0 << 2);
    /// To the right.
    pub const RIGHT: Directions = Directions(Directions::FRONT.0 << 3);
    /// Upright.
    pub const VERTICAL: Directions = Directions(0b0000_0000_1111_0000);
    /// Up, more than to any side.
    pub const TOP: Directions = Directions(0b0011_0000_0000_0000);
    /// Down, more than to any side.
    pub const BOTTOM: Directions = Directions(0b1100_0000_0000_0000);
    /// Straight up.
    pub const TOP_FACE: Directions = Directions(0b0010_0000_0000_0000);
    /// Straight down.
    pub const BOTTOM_FACE: Directions = Directions(0b1000_0000_0000_0000);
    /// Up, but not straight.
    pub const ASLANT: Directions = Directions(0b0001_0000_0000_1111);
    /// Down, but not straight.
    pub const NUTANT: Directions = Directions(0b0100_1111_0000_0000);
    /// Straight up or down.
    pub const HORIZONTAL: Directions = Directions::TOP_FACE.and(Directions::BOTTOM_FACE);
    /// Neither straight up nor down.
    pub const SIDE: Directions = Directions::ALL.but(Directions::HORIZONTAL);
    /// To the front, upright.
    pub const FRONT_FACE: Directions = Directions(Directions::FRONT.0 & Directions::VERTICAL.0);
    /// To the back, upright.
    pub const BACK_FACE: Directions = Directions(Directions::BACK.0 & Directions::VERTICAL.0);
    /// To the left, upright.
    pub const LEFT_FACE: Directions = Directions(Directions::LEFT.0 & Directions::VERTICAL.0);
    /// To the right, upright.
    pub const RIGHT_FACE: Directions = Directions(Directions::RIGHT.0 & Directions::VERTICAL.0);

    /// The union.
    pub const fn and(self, other: Directions) -> Directions {
        Directions(self.0 | other.0)
    }

    /// The directions that are not in `other`.
    pub const fn but(self, other: Directions) -> Directions {
        Directions(self.0 & !other.0)
    }

    /// The intersection.
    pub const fn common(self, other: Directions) -> Directions {
        Directions(self.0 & other.0)
    }

    /// Returns true if there are common directions.
    pub const fn meet(self, other: Directions) -> bool {
        self.0 & other.0 != 0
    }

    /// Returns true if the set is not empty and all its directions are in `others`.
    pub const fn within(self, others: Directions) -> bool {
        self.0 != 0 && self.0 & !others.0 == 0
    }
}
