//! Operations on components that the shape never has: components of points, and sides of footprints.

use crate::analysis::{AbstractState, Filling};
use crate::diag::Diags;
use crate::diag::code::Code;
use crate::ops::{self, Braces, Directions, Operation, SelectorPlaces};
use crate::resolve::tables::{Tables, Use};
use crate::syntax::ast::{Block, BlockPart, ExprKind};

pub(crate) fn check(row: &Operation, block: &Block, facts: &AbstractState, tables: &Tables, diags: &mut Diags) {
    match facts.shape.filling {
        Filling::Point => of_point(row, block, facts, diags),
        Filling::Footprint => of_footprint(row, block, facts, tables, diags),
        Filling::Box | Filling::Sheet | Filling::Lot | Filling::Prism | Filling::Unknown => {}
    }
}

/// The first argument of an operation, if it is a word.
fn first(block: &Block) -> Option<&str> {
    block.args.first()?.value.word()
}

fn of_point(row: &Operation, block: &Block, facts: &AbstractState, diags: &mut Diags) {
    let name = &block.name.text;
    let (written, what) = match row.braces {
        Braces::Components | Braces::Modified => {
            let Some(kind) = first(block).and_then(ops::component) else { return };
            let what = match kind.place {
                SelectorPlaces::FACES => "faces",
                SelectorPlaces::EDGES | SelectorPlaces::FACE_EDGES => "edges",
                SelectorPlaces::HOLES => "holes",
                _ => return,
            };
            (format!("{name}({})", kind.name), what)
        }
        _ => (name.clone(), "faces"),
    };
    let message = format!("`{written}` finds no {what}: the shape is a point");
    let diag = diags.report(Code::NoFaces, block.name.span, message);
    if let Some(place) = facts.shape.since[0].filter(|_| (0..3).all(|axis| facts.shape.is_flat(axis))) {
        diag.related("it becomes a point", place);
    }
    diag.help("make geometry at the point first, as with `primitiveCube()` or `i(…)`");
}

/// Reports selectors for faces that do not look up. A shape that is not a footprint has kept its geometry, with a fault.
fn of_footprint(row: &Operation, block: &Block, facts: &AbstractState, tables: &Tables, diags: &mut Diags) {
    if row.places(first(block)) != SelectorPlaces::FACES {
        return;
    }
    let (names, mut taken) = (tables.at(facts.own), Directions::NONE);
    for arm in block.parts.iter().flat_map(|part| if let BlockPart::Arms(arms) = part { &arms[..] } else { &[] }) {
        let ExprKind::Name(name) = &arm.selector.kind else { continue };
        let Some(Use::Selector(word)) = names.of(name) else { continue };
        let Some(selector) = ops::selector(word) else { continue };
        // Selectors that earlier ones hide have their own diagnostic.
        let is_hidden = selector.directions.within(taken);
        taken = taken.and(selector.directions);
        let looks_aside = selector.directions != Directions::NONE && !selector.directions.meet(Directions::TOP_FACE);
        if looks_aside && !is_hidden {
            let message = format!("`{word}` never finds a face of a footprint");
            let diag = diags.report(Code::SelectorHidden, arm.selector.span, message);
            diag.note("all faces of a footprint look up").help("write `top` or `all`");
        }
    }
}
