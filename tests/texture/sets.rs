//! *translateUV*, *scaleUV*, *rotateUV*, *copyUV*, *deleteUV*, and their old spellings.

use cga::glam::DVec2;
use cga::{Shape, cga};

use super::collect::leaves;

cga! {
    /// Operations on whole sets.
    grammar Sets;
    attr kind = 0
    Lot --> comp(f) { front : Facade }
    Facade --> setupProjection(0, scope.xy, 1, 1) projectUV(0) split(x) { { ~2 : Part }* }
    Part -->
        case kind == 0 : translateUV(0, 0, 0.5) X.
        case kind == 1 : scaleUV(0, 2, -3) X.
        case kind == 2 : rotateUV(0, 90) X.
        case kind == 3 : rotateUV(0, 90) translateUV(0, 1, 2) scaleUV(0, 2, 2) copyUV(0, 4) deleteUV(0) X.
        else : copyUV(0, 1) scaleUV(1, 10, 10) deleteUV(7) X.
}

#[test]
fn whole_sets_are_changed() {
    let expected: [(u32, usize, fn(f64, f64) -> [f64; 2]); 6] = [
        (0, 0, |x, y| [x, y + 0.5]),
        (1, 0, |x, y| [2.0 * x, -3.0 * y]),
        (2, 0, |x, y| [-y, x]),
        (3, 4, |x, y| [2.0 * (1.0 - y), 2.0 * (2.0 + x)]),
        (4, 0, |x, y| [x, y]),
        (4, 1, |x, y| [10.0 * x, 10.0 * y]),
    ];
    for (kind, set, uv) in expected {
        let leaves = leaves!(&Sets { kind: f64::from(kind), ..Sets::default() }, &Shape::cuboid(8.0, 3.0, 3.0));
        for corner in leaves.corners("X") {
            let expected = DVec2::from_array(uv(corner.point.x, corner.point.y));
            assert!(corner.uvs[set].unwrap().abs_diff_eq(expected, 1e-12), "{kind}: {corner:?}");
            assert_eq!(corner.uvs[0].is_none(), kind == 3);
        }
    }
}
