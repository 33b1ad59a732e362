//! Images that are stretched in one direction.

use cga::glam::{DVec2, DVec3};

/// The length of an image in one direction on a surface, in lengths across it, from which a viewer sees streaks.
const LONGEST: f64 = 8.0;

/// The height of triangles in metres below which nothing of their image is seen, and rounded coordinates decide.
const THIN: f64 = 0.005;

/// Returns true if a triangle shows its image much longer in one direction than across it, or one colour of it.
pub(super) fn is_stretched([a, b, c]: [DVec3; 3], uvs: [DVec2; 3]) -> bool {
    let (ab, ac) = (b - a, c - a);
    let longest = ab.length().max(ac.length()).max((c - b).length());
    let area = ab.cross(ac).length();
    if area < THIN * longest {
        return false;
    }
    // The steps of texture coordinates for a metre along an edge, and for a metre across it.
    let along = ab / ab.length();
    let across = ac - along * along.dot(ac);
    let (u, rest) = ((uvs[1] - uvs[0]) / ab.length(), uvs[2] - uvs[0]);
    let v = (rest - u * along.dot(ac)) / across.length();
    // The largest step squared, and the product of the largest and the smallest one.
    let (sum, product) = (u.length_squared() + v.length_squared(), u.perp_dot(v).abs());
    let largest = 0.5 * (sum + (sum * sum - 4.0 * product * product).max(0.0).sqrt());
    largest == 0.0 || LONGEST * product < largest
}
