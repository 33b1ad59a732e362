//! What the reference leaves open, one function a choice, each with its reason and source.
//!
//! The pages: *split operation* and *Subdivision split*.

/// Which sizes make a piece: positive, finite ones.
///
/// *Subdivision split*: negative and zero sizes make none and take no room. Numbers that are none (0/0, 1/0) are replaced by
/// zero where operations take them (*CGA changelog 2013.1*), so they make none either.
#[inline]
pub fn is_size(value: f64) -> bool {
    0.0 < value && value < f64::INFINITY
}

/// Extents that are split, and shares of them: up to a number whose square is still one, as areas need it.
#[inline]
pub(crate) fn is_extent(value: f64) -> bool {
    0.0 < value && value <= 1e150
}

/// The smallest piece: a length that is not above this is no piece and takes no room, wherever it stands, unless it floats
/// and nothing else does; what is left at the end of the scope and is not longer makes none, a piece that ends this close to
/// the end ends there, and room for floats that is not longer is no room.
///
/// Sums of sizes are off by some last bits: ten times 0.1 is a little less than 1. This is a share of the extent that no sum
/// of sizes that a rule would write is off by, and that no picture shows.
#[inline]
pub(crate) fn smallest_piece(extent: f64) -> f64 {
    extent * 1e-12
}

/// Whether the stretch of the larger of two neighbouring counts, `more`, is as near to 1 as that of the smaller, `fewer`.
///
/// "Best number of repetitions and least stretching" (*split operation*). That the difference decides and not the ratio
/// follows from `{ 1 | ~2.7 }* | 1` in 10, which repeats three times. Of two counts that both shrink the floats the smaller
/// one is nearer. When both are off by the same, the larger one wins: `{ 2 }* | ~1` in 10 makes five pieces and no float,
/// though four and five are both off by 1, as absolute repeats come "first" (*Subdivision split*); that holds whatever
/// rounding does, and so in every unit. Other ties are ties only if they are in `f64`, where the last bit may decide:
/// `{ ~5 | ~0.5 }*` in 30 makes five repetitions, as the *report operation* shows, though six are off by as much.
#[inline]
pub(crate) fn as_near(fewer: f64, more: f64) -> bool {
    const ROUNDING: f64 = 1e-12;
    if more == 0.0 { 2.0 - ROUNDING <= fewer } else { 1.0 < fewer && (more - 1.0).abs() <= (fewer - 1.0).abs() }
}

/// How many repetitions there are at least, of `groups` that can repeat, one by one.
///
/// When something outside all groups floats, none is needed: `{ ~w | 0.25 }* | ~w` in `w` makes one piece. Else every group
/// is there once, as all documented repeats are, and shrinks or is cut.
#[inline]
pub(crate) fn least_turns(floats_outside: bool, groups: u64) -> u64 {
    if floats_outside { 0 } else { groups }
}

/// How often group number `group` of `groups` repeats when so many repetitions are dealt out.
///
/// *Subdivision split*, "Repeat split—Parallel", shows groups beside each other sharing the space, and gives no numbers. They
/// are dealt out one by one, in writing order, and over again, so that groups repeat equally often, and the first ones once
/// more when it doesn't come out even. A group inside a group is dealt its repetitions in the same way: it repeats as often in
/// each repetition of the outer one as that one repeats, or once less.
#[inline]
pub(crate) fn share(turns: u64, groups: u64, group: u64) -> u64 {
    turns / groups + u64::from(group < turns % groups)
}

/// The group that the last of so many repetitions goes to: without floats it is the one that is cut.
#[inline]
pub(crate) fn last_group(turns: u64, groups: u64) -> u64 {
    (turns + groups - 1) % groups
}

/// The room for groups without any floats: what the sizes outside leave, wherever they stand.
///
/// *Subdivision split* evaluates absolute repeats "first" only against floats. Against absolutes outside there are no
/// numbers; those come first, as `1 | { 2 }* | 1` would else never get its last piece.
#[inline]
pub(crate) fn room_for_groups(extent: f64, absolute_outside: f64) -> f64 {
    extent - absolute_outside
}
