//! Outlines with their holes.

use super::StreetError;
use super::grid::{Point, sides, twice_area, winding, winding_part};
use super::progress::{EDGE, spend};
use super::segment_tree::SegmentTree;

/// The most corners of an outline whose sides are tried one by one.
const FEW: usize = 32;

/// The outline of a face, prepared for holes.
struct Outline<'a> {
    ring: &'a [Point],
    twice_area: i128,
    /// The corners, sorted.
    corners: Vec<Point>,
    /// The sides of an outline with many corners, by place, and its largest x.
    tree: Option<(SegmentTree, i64)>,
}

impl<'a> Outline<'a> {
    fn of(ring: &'a [Point]) -> Self {
        let mut corners = ring.to_vec();
        corners.sort_unstable();
        let right = ring.iter().map(|point| point.x).max().unwrap_or_default();
        let tree = (FEW < ring.len()).then(|| (SegmentTree::of(sides(ring)), right));
        Outline { ring, twice_area: twice_area(ring), corners, tree }
    }

    /// Returns true if a hole is inside. Loops of one owner may touch at corners, but they do not cross.
    fn is_around(&self, hole: &[Point]) -> Result<bool, StreetError> {
        let is_beside = |point: &&Point| self.corners.binary_search(point).is_err();
        let Some(&point) = hole.iter().find(is_beside) else { return Ok(false) };
        let Some((tree, right)) = &self.tree else { return Ok(winding(self.ring, point) != 0) };
        let count = self.ring.len();
        let mut turns = 0;
        let near = tree.near([point, Point { x: point.x.max(*right), ..point }], 0, |at| {
            let at = at as usize;
            turns += winding_part([self.ring[at], self.ring[(at + 1) % count]], point);
        });
        spend(near)?;
        Ok(turns != 0)
    }
}

/// The box of a ring.
pub(super) fn bounds(ring: &[Point]) -> [Point; 2] {
    let none = [Point { x: i64::MAX, y: i64::MAX }, Point { x: i64::MIN, y: i64::MIN }];
    ring.iter().fold(none, |[low, high], p| {
        [Point { x: low.x.min(p.x), y: low.y.min(p.y) }, Point { x: high.x.max(p.x), y: high.y.max(p.y) }]
    })
}

/// The loops of an owner as faces: outlines with their holes. A hole belongs to the smallest outline around it. An error if the layout
/// is to end.
pub(super) fn faces_of(loops: &[Vec<Point>]) -> Result<Vec<Vec<Vec<Point>>>, StreetError> {
    spend(EDGE * loops.iter().map(Vec::len).sum::<usize>())?;
    let (outer, holes): (Vec<&Vec<Point>>, Vec<&Vec<Point>>) = loops.iter().partition(|ring| 0 < twice_area(ring));
    let mut faces: Vec<Vec<Vec<Point>>> = outer.iter().map(|ring| vec![(*ring).clone()]).collect();
    if outer.is_empty() || holes.is_empty() {
        return Ok(faces);
    }
    let outlines: Vec<Outline<'_>> = outer.into_iter().map(|ring| Outline::of(ring)).collect();
    let boxes = SegmentTree::of(outlines.iter().map(|outline| bounds(outline.ring)));
    let mut near = Vec::new();
    for hole in holes.into_iter().filter(|ring| twice_area(ring) != 0) {
        near.clear();
        let visited = boxes.near([hole[0]; 2], 0, |number| near.push(number as usize));
        spend(EDGE * (hole.len() + visited))?;
        // From the smallest one on.
        near.sort_unstable_by_key(|&number| (outlines[number].twice_area, number));
        for &number in &near {
            if outlines[number].is_around(hole)? {
                faces[number].push(hole.clone());
                break;
            }
        }
    }
    Ok(faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: i64, y: i64, size: i64) -> Vec<Point> {
        [[0, 0], [size, 0], [size, size], [0, size]].map(|[u, v]| Point { x: x + u, y: y + v }).into()
    }

    fn reversed(ring: Vec<Point>) -> Vec<Point> {
        ring.into_iter().rev().collect()
    }

    #[test]
    fn a_hole_belongs_to_the_smallest_outline_around_it() {
        let outlines = [square(0, 0, 100), square(20, 20, 40), square(200, 0, 100)];
        // The first hole has the second outline as an island. The last one is outside of all.
        let holes = [square(10, 10, 60), square(30, 30, 5), square(210, 10, 5), square(400, 0, 5)].map(reversed);
        let loops: Vec<Vec<Point>> = outlines.iter().chain(&holes).cloned().collect();
        let faces = faces_of(&loops).unwrap();
        let expected = [[&outlines[0], &holes[0]], [&outlines[1], &holes[1]], [&outlines[2], &holes[2]]];
        assert_eq!(faces, expected.map(|rings| rings.map(Vec::clone).to_vec()));
    }

    #[test]
    fn a_hole_may_touch_the_outline() {
        let outline = square(0, 0, 100);
        let hole = [[0, 0], [10, 30], [30, 10]].map(|[x, y]| Point { x, y }).to_vec();
        let faces = faces_of(&[outline.clone(), hole.clone()]).unwrap();
        assert_eq!(faces, [vec![outline, hole]]);
    }

    /// Comparing each hole with all corners of the outline would take minutes.
    #[test]
    fn an_outline_with_many_corners_has_many_holes() {
        let (teeth, holes) = (50_000, 50_000);
        let mut outline: Vec<Point> = vec![Point { x: 0, y: 0 }, Point { x: 2 * teeth, y: 0 }];
        outline.extend((0..2 * teeth).rev().map(|x| Point { x, y: 100 + x % 2 }));
        let mut loops = vec![outline];
        loops.extend((0..holes).map(|number| reversed(square(2 * number, 50, 1))));
        let faces = faces_of(&loops).unwrap();
        assert_eq!((faces.len(), faces[0].len()), (1, 1 + holes as usize));
    }
}
