//! *Boolean operations*, the reference table. The page shows only its pictures.

use cga::Shape;

use super::example::{Example, example};

/// By operation, then by operands: both closed, a plane that faces up, one that faces down, one that ends inside.
pub const ALL: &[Example] = &[
    union_of_solids::EXAMPLE,
    union_up::EXAMPLE,
    union_down::EXAMPLE,
    union_part::EXAMPLE,
    left_without_right::EXAMPLE,
    left_without_right_up::EXAMPLE,
    left_without_right_down::EXAMPLE,
    left_without_right_part::EXAMPLE,
    right_without_left::EXAMPLE,
    right_without_left_up::EXAMPLE,
    right_without_left_down::EXAMPLE,
    right_without_left_part::EXAMPLE,
    common::EXAMPLE,
    common_up::EXAMPLE,
    common_down::EXAMPLE,
    common_part::EXAMPLE,
    unified::EXAMPLE,
    unified_up::EXAMPLE,
    unified_down::EXAMPLE,
    unified_part::EXAMPLE,
];

fn square() -> Shape {
    Shape::rectangle(10.0, 10.0)
}

example! {
    union_of_solids, "Boolean operations, reference table: union, both closed", square(),
    r##"Init --> union { BlueOperand | GreenOperand }
BlueOperand --> t(0, -5, 0) extrude(5) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    union_up, "Boolean operations, reference table: union, plane, normal up", square(),
    r##"Init --> union { BlueOperand | GreenOperand }
BlueOperand -->  Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    union_down, "Boolean operations, reference table: union, plane, normal down", square(),
    r##"Init --> union { BlueOperand | GreenOperand }
BlueOperand --> reverseNormals Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    union_part, "Boolean operations, reference table: union, plane that ends inside", square(),
    r##"Init --> union { BlueOperand | GreenOperand }
BlueOperand --> s('0.5, '1, '1) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    left_without_right, "Boolean operations, reference table: subtract { Blue | Green }, both closed", square(),
    r##"Init --> subtract { BlueOperand | GreenOperand }
BlueOperand --> t(0, -5, 0) extrude(5) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    left_without_right_up, "Boolean operations, reference table: subtract { Blue | Green }, plane, normal up", square(),
    r##"Init --> subtract { BlueOperand | GreenOperand }
BlueOperand -->  Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    left_without_right_down, "Boolean operations, reference table: subtract { Blue | Green }, plane, normal down", square(),
    r##"Init --> subtract { BlueOperand | GreenOperand }
BlueOperand --> reverseNormals Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    left_without_right_part, "Boolean operations, reference table: subtract { Blue | Green }, plane that ends inside", square(),
    r##"Init --> subtract { BlueOperand | GreenOperand }
BlueOperand --> s('0.5, '1, '1) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    right_without_left, "Boolean operations, reference table: subtract { Green | Blue }, both closed", square(),
    r##"Init --> subtract { GreenOperand | BlueOperand }
BlueOperand --> t(0, -5, 0) extrude(5) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    right_without_left_up, "Boolean operations, reference table: subtract { Green | Blue }, plane, normal up", square(),
    r##"Init --> subtract { GreenOperand | BlueOperand }
BlueOperand -->  Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    right_without_left_down, "Boolean operations, reference table: subtract { Green | Blue }, plane, normal down", square(),
    r##"Init --> subtract { GreenOperand | BlueOperand }
BlueOperand --> reverseNormals Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    right_without_left_part, "Boolean operations, reference table: subtract { Green | Blue }, plane that ends inside", square(),
    r##"Init --> subtract { GreenOperand | BlueOperand }
BlueOperand --> s('0.5, '1, '1) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    common, "Boolean operations, reference table: intersect, both closed", square(),
    r##"Init --> intersect { BlueOperand | GreenOperand }
BlueOperand --> t(0, -5, 0) extrude(5) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    common_up, "Boolean operations, reference table: intersect, plane, normal up", square(),
    r##"Init --> intersect { BlueOperand | GreenOperand }
BlueOperand -->  Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    common_down, "Boolean operations, reference table: intersect, plane, normal down", square(),
    r##"Init --> intersect { BlueOperand | GreenOperand }
BlueOperand --> reverseNormals Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    common_part, "Boolean operations, reference table: intersect, plane that ends inside", square(),
    r##"Init --> intersect { BlueOperand | GreenOperand }
BlueOperand --> s('0.5, '1, '1) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    unified, "Boolean operations, reference table: inline(unify), both closed", square(),
    r##"Init --> inline(unify) { GreenOperand BlueOperand }
BlueOperand --> t(0, -5, 0) extrude(5) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    unified_up, "Boolean operations, reference table: inline(unify), plane, normal up", square(),
    r##"Init --> inline(unify) { GreenOperand BlueOperand }
BlueOperand -->  Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    unified_down, "Boolean operations, reference table: inline(unify), plane, normal down", square(),
    r##"Init --> inline(unify) { GreenOperand BlueOperand }
BlueOperand --> reverseNormals Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}

example! {
    unified_part, "Boolean operations, reference table: inline(unify), plane that ends inside", square(),
    r##"Init --> inline(unify) { GreenOperand BlueOperand }
BlueOperand --> s('0.5, '1, '1) Blue
GreenOperand --> s(8, 8, 8) center(xyz) primitiveSphere Green

Blue --> color("#0399F5")
Green --> color("#09DE1F")
"##
}
