//! The measures of a model's pieces, in a few lines.

use cga::{Color, LeafView, Model};

/// The length from which pieces are listed one by one.
const SHORTEST: f64 = 0.02;

/// The pieces from the low end on, with number, rule and length, as in `2 x X 3 | Y 0.5`. Very short pieces are only
/// counted.
pub fn lengths(model: &Model) -> String {
    let mut leaves: Vec<_> = model.leaves().collect();
    leaves.sort_by(|a, b| a.scope().origin.x.total_cmp(&b.scope().origin.x));
    runs(leaves.into_iter().map(|leaf| match leaf.size().x {
        length if length < SHORTEST => format!("shorter than {SHORTEST}"),
        length => format!("{} {}", leaf.rule(), short(length)),
    }))
}

/// The pieces in the form of [`lengths`], each with its index and the total.
pub fn numbered(model: &Model) -> String {
    runs(model.leaves().map(|leaf| {
        let name = leaf.material().name.as_ref().map(ToString::to_string).unwrap_or_default();
        format!("{} {} ({name})", leaf.rule(), short(leaf.size().x))
    }))
}

/// The pieces from the lowest on: the rule, the height, and the colour set by a rule.
pub fn heights(model: &Model) -> String {
    runs(model.leaves().map(|leaf| {
        let color = leaf.material().color.map(hex).unwrap_or_default();
        format!("{} {}{color}", leaf.rule(), short(leaf.size().y))
    }))
}

/// The areas, in the order of the pieces. Scopes that are drawn as pieces come last, as one sum.
pub fn areas(model: &Model) -> String {
    let area = |leaf: LeafView<'_>| format!("{} {}", leaf.rule(), short(leaf.area()));
    let pieces = runs(model.leaves().filter(|leaf| leaf.rule() != SCOPE).map(area));
    let scopes: f64 = model.leaves_of(SCOPE).map(|leaf| leaf.area()).sum();
    match model.count(SCOPE) {
        0 => pieces,
        1 => format!("{pieces} | scope {}", short(scopes)),
        count => format!("{pieces} | {count} scopes, together {}", short(scopes)),
    }
}

/// The rule that draws the scope of a piece (*splitArea operation*).
pub const SCOPE: &str = "Pink";

/// The number of pieces of each rule.
pub fn counts(model: &Model) -> String {
    model.counts().iter().map(|(rule, count)| format!("{count} {rule}")).collect::<Vec<_>>().join(", ")
}

/// Joins consecutive equal pieces, with their number.
fn runs(pieces: impl Iterator<Item = String>) -> String {
    let mut runs: Vec<(usize, String)> = Vec::new();
    for piece in pieces {
        match runs.last_mut() {
            Some((count, last)) if *last == piece => *count += 1,
            _ => runs.push((1, piece)),
        }
    }
    let shown = runs.iter().map(|(count, piece)| match count {
        1 => piece.clone(),
        _ => format!("{count} x {piece}"),
    });
    shown.collect::<Vec<_>>().join(" | ")
}

fn hex(color: Color) -> String {
    let [r, g, b] = [color.r, color.g, color.b].map(|channel| (channel * 255.0).round() as u8);
    format!(" #{r:02x}{g:02x}{b:02x}")
}

fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
