//! The choices that the reference leaves open: one function per choice, with its reason and source.
//!
//! The pages: *split operation* and *Subdivision split*.

/// Returns true if a size makes a piece: positive and finite sizes do.
///
/// *Subdivision split*: negative and zero sizes make no piece and take no room. Operations replace NaN and infinite
/// arguments (0/0, 1/0) by zero (*CGA changelog 2013.1*), so these make no piece either.
#[inline]
pub fn is_size(value: f64) -> bool {
    0.0 < value && value < f64::INFINITY
}

/// Returns true if an extent is split, or if a share of an extent counts. The limit keeps squares finite, which areas
/// need.
#[inline]
pub(crate) fn is_extent(value: f64) -> bool {
    0.0 < value && value <= 1e150
}

/// The smallest piece. A length up to this value makes no piece and takes no room, unless the slot floats and no other
/// slot does. A rest of this length at the end of the scope makes no piece. A piece that ends this close to the end of
/// the scope ends at the end. Floats get no piece from a room of this length.
///
/// Sums of sizes are off by a few last bits: ten times 0.1 is a little less than 1. This share of the extent is larger
/// than the error of any sum in a real rule, and too small to be seen.
#[inline]
pub(crate) fn smallest_piece(extent: f64) -> f64 {
    extent * 1e-12
}

/// Returns true if the stretch `more` of the larger of two neighbouring counts is as near to 1 as the stretch `fewer`
/// of the smaller count.
///
/// "Best number of repetitions and least stretching" (*split operation*). The difference decides, not the ratio: `{ 1
/// | ~2.7 }* | 1` in
/// 10 repeats three times. When both counts shrink the floats, the smaller count is nearer. When both are equally far
/// from 1, the larger count wins: `{ 2 }* | ~1` in 10 makes five pieces and no float, although four and five are both
/// off by 1, because absolute repeats come "first" (*Subdivision split*). This case has a tolerance for rounding, so it
/// gives the same result in every unit. Other ties are exact comparisons in `f64`, where the last bit may decide: `{ ~5
/// | ~0.5 }*` in 30 makes five repetitions, as the *report operation* shows, although six are equally far.
#[inline]
pub(crate) fn as_near(fewer: f64, more: f64) -> bool {
    const ROUNDING: f64 = 1e-12;
    if more == 0.0 { 2.0 - ROUNDING <= fewer } else { 1.0 < fewer && (more - 1.0).abs() <= (fewer - 1.0).abs() }
}

/// The least total number of repetitions of all groups. `groups` is the number of groups that can repeat.
///
/// Zero when a slot outside all groups floats: `{ ~w | 0.25 }* | ~w` in `w` makes one piece. Otherwise every group is
/// made at least once, as in all documented repeats, and is shrunk or cut.
#[inline]
pub(crate) fn least_turns(floats_outside: bool, groups: u64) -> u64 {
    if floats_outside { 0 } else { groups }
}

/// The number of repetitions of group number `group` of `groups` when `turns` repetitions are dealt out.
///
/// *Subdivision split*, "Repeat split—Parallel", shows neighbouring groups that share the space, and gives no numbers.
/// Here repetitions are dealt out one by one, round after round, in writing order. So groups repeat equally often, and
/// when the number does not divide evenly the first groups repeat once more. A nested group takes part in the same way:
/// in each repetition of the outer group it repeats as often as the outer group, or once less.
#[inline]
pub(crate) fn share(turns: u64, groups: u64, group: u64) -> u64 {
    turns / groups + u64::from(group < turns % groups)
}

/// The group that gets the last of `turns` repetitions. Without floats this group is cut.
#[inline]
pub(crate) fn last_group(turns: u64, groups: u64) -> u64 {
    (turns + groups - 1) % groups
}

/// The room for groups without floats: the extent minus the absolute sizes outside the groups, in any order.
///
/// *Subdivision split* evaluates absolute repeats "first" only against floats, and gives no numbers for absolute sizes
/// outside. These come first, because otherwise `1 | { 2 }* | 1` would never get its last piece.
#[inline]
pub(crate) fn room_for_groups(extent: f64, absolute_outside: f64) -> f64 {
    extent - absolute_outside
}
