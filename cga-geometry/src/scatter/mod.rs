//! Random points on surfaces and in boxes and solids, with an even density or a normal one.
//!
//! The domain is divided into cells: triangles or boxes. A point is drawn in two steps: a cell by its measure times the
//! highest density in it, then a point in the cell, which is kept with the ratio of its density to the highest one. Cells
//! in which the density varies much, and boxes that the surface of a solid crosses, are halved while they matter, so most
//! points are kept. All arithmetic is the same on every platform.

mod bell;
mod solid;

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use glam::DVec3;

pub use bell::Bell;
use solid::Solid;

use crate::each::Each;
use crate::long_sort::long_sort_by;
use crate::mesh::{Mesh, unit};
use crate::triangulate::Triangulator;
use crate::work;

/// The most cells that halving makes for each point that is asked for. Few points are not worth many cells.
const CELLS_PER_POINT: u64 = 8;

/// The least and the most of these. Halving down to a millionth of the extent along each axis takes 120.
const CELL_LIMITS: [u64; 2] = [256, 4096];

/// Cells are halved until the logarithms of their densities differ by less.
const EVEN_ENOUGH: f64 = 1.4;

/// Logarithms of weights count as equal in steps of this size, so that rounding does not change the order of cells. These steps, and the steps
/// of numbers of halvings, begin beside the values of simple shapes.
const WEIGHT_STEP: f64 = 1e-6;
const FIRST_STEP: f64 = 0.381_966;

/// Extents that differ by less than this share count as equal: the first of them is halved.
const SAME_EXTENT: f64 = 1e-9;

/// The number of points that can be drawn in vain in the time that a halving takes.
const MISSES_PER_HALVING: f64 = 4.0;

/// Cells whose weight is less than the heaviest by this factor, as a logarithm, are not halved.
const MATTERS: f64 = 12.0;

/// The most points that are drawn and not kept, for each point that is asked for, and in addition.
const MOST_MISSES: [u64; 2] = [200, 100_000];

/// The units of work that halving a cell and drawing a point take, besides triangles.
const HALVING: usize = 64;
const DRAWING: usize = 32;

/// The units of work of a corner whose face is triangulated.
const TRIANGLE: usize = 16;

/// A part of the domain.
#[derive(Debug)]
struct DensityCell {
    form: CellForm,
    /// The logarithm of the highest density in it.
    log_peak: f64,
}

/// A cell that may be halved.
#[derive(Debug)]
struct WeightedCell {
    /// Cells are counted as they are made.
    number: u64,
    /// The weight in steps of [`WEIGHT_STEP`].
    step: i64,
    cell: DensityCell,
    /// The logarithm of its measure times that density.
    log_weight: f64,
    /// True if it should be halved.
    is_uneven: bool,
}

#[derive(Debug)]
enum CellForm {
    Triangle {
        corners: [DVec3; 3],
        normal: DVec3,
    },
    /// A box, and the triangles of the solid that may come into it.
    Box {
        low: DVec3,
        high: DVec3,
        crossing: Vec<u32>,
    },
}

impl WeightedCell {
    /// A cell with that weight, which has no number yet.
    fn new(form: CellForm, log_peak: f64, log_weight: f64, is_uneven: bool) -> Self {
        let step = (log_weight / WEIGHT_STEP + FIRST_STEP).floor() as i64;
        WeightedCell { number: 0, step, cell: DensityCell { form, log_peak }, log_weight, is_uneven }
    }
}

/// Cells are ordered by weight, and cells of the same weight by number: the first is the largest.
impl Ord for WeightedCell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.step.cmp(&other.step).then(other.number.cmp(&self.number))
    }
}

impl PartialOrd for WeightedCell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for WeightedCell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for WeightedCell {}

/// A point, and the normal of the surface there; zero inside boxes.
#[derive(Clone, Copy, Debug)]
pub struct ScatteredPoint {
    /// The place.
    pub position: DVec3,
    /// The normal of the surface, of length 1; zero inside boxes and solids.
    pub normal: DVec3,
}

/// A domain with a density, divided for a number of points.
///
/// It has at most eight cells for each point, between 256 and 4096, besides the triangles of a surface; a solid with the same density
/// everywhere has no more than save time. Parts without an extent, and parts whose density is not a number, get no points.
///
/// ```
/// use cga_geometry::glam::DVec3;
/// use cga_geometry::primitive;
/// use cga_geometry::scatter::{Bell, Domain};
///
/// // Numbers from 0 up to below 1; any generator of random numbers will do.
/// let mut state = 1u64;
/// let random = move || {
///     state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
///     (state >> 11) as f64 / (1u64 << 53) as f64
/// };
/// let points: Vec<_> = Domain::surface(&primitive::quad(), Bell::EVEN, 100).draw(random).collect();
/// assert_eq!(points.len(), 100);
/// assert!(points.iter().all(|point| point.position.y == 0.0 && point.normal == DVec3::Y));
/// ```
#[derive(Debug)]
pub struct Domain {
    count: u64,
    cells: Vec<DensityCell>,
    /// The sum of the weights up to each cell.
    sums: Vec<f64>,
    bell: Bell,
    solid: Option<Solid>,
}

impl Domain {
    /// The faces of a mesh, for `count` points.
    pub fn surface(mesh: &Mesh, bell: Bell, count: u64) -> Self {
        let triangles = triangles(mesh).into_iter().take_while(|_| work::spend(HALVING));
        if bell.is_even() {
            return Domain::even_surface(triangles, count);
        }
        let cells = triangles.filter_map(|(corners, normal)| triangle(corners, normal, &bell));
        Domain::of(cells.collect(), bell, None, count, u64::MAX)
    }

    /// Triangles with the same density everywhere, which no halving makes better. Their areas are the weights.
    fn even_surface(triangles: impl Iterator<Item = ([DVec3; 3], DVec3)>, count: u64) -> Self {
        let (mut cells, mut sums, mut sum) = (Vec::new(), Vec::new(), 0.0);
        for (corners, normal) in triangles {
            let area = doubled_area(&corners);
            if 0.0 < area {
                sum += area;
                sums.push(sum);
                cells.push(DensityCell { form: CellForm::Triangle { corners, normal }, log_peak: 0.0 });
            }
        }
        Domain { count, cells, sums, bell: Bell::EVEN, solid: None }
    }

    /// The inside of a closed mesh, for `count` points. An open mesh has the inside around which its faces wind.
    pub fn volume(mesh: &Mesh, bell: Bell, count: u64) -> Self {
        let solid = Solid::new(triangles(mesh).into_iter().map(|(corners, _)| corners).collect());
        let bounds = solid.bounds();
        let all = solid.all();
        let cells = cuboid(bounds.low, bounds.high, &all, &bell, Some(&solid)).into_iter().collect();
        let halvings = if bell.is_even() { halvings_for(bounds.size(), mesh.volume(), count) } else { u64::MAX };
        Domain::of(cells, bell, Some(solid), count, halvings)
    }

    /// A box, for `count` points. Extents of 0 make it a rectangle, a line or a point. `low` is at most `high` along each axis.
    pub fn cuboid(low: DVec3, high: DVec3, bell: Bell, count: u64) -> Self {
        Domain::of(cuboid(low, high, &[], &bell, None).into_iter().collect(), bell, None, count, u64::MAX)
    }

    /// A domain whose uneven cells are halved, up to a number of halvings.
    fn of(cells: Vec<WeightedCell>, bell: Bell, solid: Option<Solid>, count: u64, halvings: u64) -> Self {
        let mut numbers = 0..;
        let mut numbered = |cell: WeightedCell| WeightedCell { number: numbers.next().unwrap_or_default(), ..cell };
        let mut first: Vec<_> = cells.into_iter().map(&mut numbered).collect();
        if first.iter().all(|cell| !cell.is_uneven) {
            if !work::spend(HALVING * first.len()) {
                first.clear();
            }
            return Domain::divided(from_largest(first), bell, solid, count);
        }
        let mut heap = BinaryHeap::from(first);
        let mut cells = Vec::new();
        let [least, most] = CELL_LIMITS;
        let most = heap.len() + count.saturating_mul(CELLS_PER_POINT).clamp(least, most).min(halvings) as usize;
        let mut heaviest = f64::NEG_INFINITY;
        while let Some(cell) = heap.pop() {
            let matters = heaviest - MATTERS < cell.log_weight;
            let form = &cell.cell.form;
            let crossing = if let CellForm::Box { crossing, .. } = form { crossing.len() } else { 0 };
            if !work::spend(HALVING + 2 * crossing) {
                break;
            }
            let is_halved = cell.is_uneven && matters && heap.len() + cells.len() + 2 <= most;
            match if is_halved { halves(form, &bell, solid.as_ref()) } else { None } {
                Some(halves) => heap.extend(halves.into_iter().flatten().map(&mut numbered)),
                None => {
                    heaviest = heaviest.max(cell.log_weight);
                    cells.push(cell);
                }
            }
        }
        Domain::divided(cells, bell, solid, count)
    }

    /// A domain with these cells.
    fn divided(cells: Vec<WeightedCell>, bell: Bell, solid: Option<Solid>, count: u64) -> Self {
        let top = cells.iter().map(|cell| cell.log_weight).fold(f64::NEG_INFINITY, f64::max);
        let mut sum = 0.0;
        let add = |cell: &WeightedCell| {
            sum += libm::exp(cell.log_weight - top);
            sum
        };
        let sums = cells.iter().map(add).collect();
        let cells = cells.into_iter().map(|cell| cell.cell).collect();
        Domain { count, cells, sums, bell, solid }
    }

    /// Draws the points, one by one. `random` gives numbers from 0 up to below 1, evenly distributed. There are fewer points if
    /// the domain has no extent, or is too small a part of its cells: the number of draws is limited.
    pub fn draw(self, mut random: impl FnMut() -> f64) -> impl Iterator<Item = ScatteredPoint> {
        let [each, more] = MOST_MISSES;
        let mut misses = self.count.saturating_mul(each).saturating_add(more);
        let count = if self.cells.is_empty() { 0 } else { self.count };
        (0..count).map_while(move |_| {
            loop {
                if !work::spend(DRAWING) {
                    return None;
                }
                if let Some(point) = self.try_draw(&mut random) {
                    return Some(point);
                }
                misses = misses.checked_sub(1)?;
            }
        })
    }

    /// A random point, or nothing. Every try draws as many numbers, for domains of one kind.
    fn try_draw(&self, random: &mut dyn FnMut() -> f64) -> Option<ScatteredPoint> {
        let wanted = random() * self.sums.last()?;
        let at = self.sums.partition_point(|sum| *sum <= wanted).min(self.cells.len() - 1);
        let cell = &self.cells[at];
        let (point, is_inside) = self.within(cell, random);
        let ratio = libm::exp(self.bell.log_density(point.position) - cell.log_peak);
        (random() < ratio && is_inside).then_some(point)
    }

    /// A random point of a cell, and true if it is in the domain.
    fn within(&self, cell: &DensityCell, random: &mut dyn FnMut() -> f64) -> (ScatteredPoint, bool) {
        match &cell.form {
            CellForm::Triangle { corners: [a, b, c], normal } => {
                let (along, across) = (random().sqrt(), random());
                let position = *a + (*b - *a) * (along * (1.0 - across)) + (*c - *a) * (along * across);
                (ScatteredPoint { position, normal: *normal }, true)
            }
            CellForm::Box { low, high, crossing } => {
                let share = DVec3::new(random(), random(), random());
                let position = *low + (*high - *low) * share;
                let is_inside = crossing.is_empty() || self.solid.as_ref().is_none_or(|solid| solid.contains(position));
                (ScatteredPoint { position, normal: DVec3::ZERO }, is_inside)
            }
        }
    }
}

/// The cells in the order in which a heap would give them; none if the work is to end.
fn from_largest(cells: Vec<WeightedCell>) -> Vec<WeightedCell> {
    let mut order: Vec<(Reverse<i64>, u64, usize)> =
        cells.iter().enumerate().map(|(at, cell)| (Reverse(cell.step), cell.number, at)).collect();
    if !long_sort_by(&mut order, Ord::cmp) {
        return Vec::new();
    }
    let mut cells: Vec<Option<WeightedCell>> = cells.into_iter().map(Some).collect();
    order.into_iter().filter_map(|(_, _, at)| cells[at].take()).collect()
}

/// The halvings of a box that save time, for a solid in it with the same density everywhere: they are made to avoid points that are drawn
/// and not kept.
fn halvings_for(size: DVec3, volume: f64, count: u64) -> u64 {
    let misses_of_each = size.element_product() / volume.abs() - 1.0;
    // A solid that overlaps itself may have a larger volume than its box. Then the volume says nothing.
    if misses_of_each.is_nan() || misses_of_each < -0.01 {
        return u64::MAX;
    }
    // A cast takes infinity to the largest number.
    (count as f64 * misses_of_each / MISSES_PER_HALVING + FIRST_STEP) as u64
}

/// The triangles of all faces, with their normals. Some are missing if the work is to end.
fn triangles(mesh: &Mesh) -> Vec<([DVec3; 3], DVec3)> {
    let (mut triangulator, mut list, mut all) = (Triangulator::new(), Vec::new(), Vec::new());
    for face in mesh.faces() {
        if !work::spend(TRIANGLE * face.corner_count()) {
            break;
        }
        list.clear();
        triangulator.steady_face(mesh, face.index(), &mut list);
        let normal = unit(face.normal());
        let corners = list.iter().map(|triangle| triangle.each(|corner| face.position(corner as usize)));
        all.extend(corners.map(|corners| (corners, normal)));
    }
    all
}

/// Twice the area of a triangle.
fn doubled_area([a, b, c]: &[DVec3; 3]) -> f64 {
    (*b - *a).cross(*c - *a).length()
}

/// The cell of a triangle, if it has an area.
fn triangle(corners: [DVec3; 3], normal: DVec3, bell: &Bell) -> Option<WeightedCell> {
    let (area, [a, b, c]) = (doubled_area(&corners), corners);
    let [least, log_peak] = bell.log_range(a.min(b).min(c), a.max(b).max(c));
    let log_weight = libm::log(area) + log_peak;
    let is_uneven = EVEN_ENOUGH < log_peak - least;
    (0.0 < area).then(|| WeightedCell::new(CellForm::Triangle { corners, normal }, log_peak, log_weight, is_uneven))
}

/// The cell of a box. `near` are the triangles that may come into it. `None` outside the solid.
fn cuboid(low: DVec3, high: DVec3, near: &[u32], bell: &Bell, solid: Option<&Solid>) -> Option<WeightedCell> {
    let crossing = solid.map_or(Vec::new(), |solid| solid.crossing(near, low, high));
    if crossing.is_empty() && solid.is_some_and(|solid| !solid.contains((low + high) * 0.5)) {
        return None;
    }
    let [least, log_peak] = bell.log_range(low, high);
    let extents = (high - low).to_array();
    let log_measure: f64 = extents.into_iter().filter(|extent| 0.0 < *extent).map(libm::log).sum();
    let is_uneven = !crossing.is_empty() || EVEN_ENOUGH < log_peak - least;
    Some(WeightedCell::new(CellForm::Box { low, high, crossing }, log_peak, log_measure + log_peak, is_uneven))
}

/// Both halves of a cell, across its longest extent in units of the deviation. `None` if its middle is one of its ends, or
/// overflows: then one of the halves would be the cell itself, again and again.
fn halves(form: &CellForm, bell: &Bell, solid: Option<&Solid>) -> Option<[Option<WeightedCell>; 2]> {
    // Where the density is even, lengths count as they are.
    let units = DVec3::select(bell.deviation.cmplt(DVec3::INFINITY), bell.deviation, DVec3::ONE);
    match form {
        CellForm::Triangle { corners, normal } => {
            let longest = longest([0, 1, 2].each(|edge| ((corners[(edge + 1) % 3] - corners[edge]) / units).length()));
            let [from, to, apex] = [0, 1, 2].each(|step| corners[(longest + step) % 3]);
            let middle = (from + to) * 0.5;
            let is_between = middle.is_finite() && middle != from && middle != to;
            is_between
                .then(|| [[from, middle, apex], [middle, to, apex]].each(|corners| triangle(corners, *normal, bell)))
        }
        CellForm::Box { low, high, crossing } => {
            let longest = longest(((*high - *low) / units).to_array());
            let middle = (low[longest] + high[longest]) * 0.5;
            let (mut top, mut bottom) = (*high, *low);
            (top[longest], bottom[longest]) = (middle, middle);
            let is_between = middle.is_finite() && middle != low[longest] && middle != high[longest];
            is_between
                .then(|| [(*low, top), (bottom, *high)].each(|(low, high)| cuboid(low, high, crossing, bell, solid)))
        }
    }
}

/// The first of the longest lengths.
fn longest(lengths: [f64; 3]) -> usize {
    let most = lengths.into_iter().fold(0.0, f64::max);
    lengths.iter().position(|length| most * (1.0 - SAME_EXTENT) <= *length).unwrap_or(0)
}

#[cfg(test)]
mod tests;
