//! The operations, and the reasons why one has no result.

/// An operation on two operands, or the union of the parts of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BooleanOp {
    /// The union of all parts of one operand. Open surfaces hide nothing.
    Unify,
    /// The places in one of the operands.
    Union,
    /// The first operand without the second.
    Subtract,
    /// The places in both operands.
    Intersect,
}

impl BooleanOp {
    /// Returns true if a place that is inside the operands or not is inside the result.
    pub(super) fn keeps(self, [a, b]: [bool; 2]) -> bool {
        match self {
            BooleanOp::Unify | BooleanOp::Union => a || b,
            BooleanOp::Subtract => a && !b,
            BooleanOp::Intersect => a && b,
        }
    }
}

/// The reason why an operation has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BooleanError {
    /// Too many faces meet.
    TooMany,
    /// Faces that are nearly at one place cannot be told apart.
    Tangled,
    /// A coordinate is NaN or infinite.
    NotFinite,
}
