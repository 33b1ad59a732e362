//! Polygons of maps, before they are lots.

use std::panic::catch_unwind;

use cga::Shape;

use crate::errors::PANIC;

/// The most corners of the polygons of a row. More are a coastline and not a lot.
pub(crate) const MOST_CORNERS: usize = 20_000;

/// The least extent of a lot in metres. Smaller ones are degrees that are read as metres.
const LEAST_METRES: f64 = 0.01;

/// A polygon with x to the east and y to the north, in metres.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outline {
    /// The outer ring, then the holes.
    pub(crate) rings: Vec<Vec<[f64; 2]>>,
    /// The lowest z of the outer ring, if it has z.
    pub(crate) height: Option<f64>,
}

/// The place of the model's origin in the coordinates of the map.
pub(crate) type Origin = [f64; 2];

impl Outline {
    /// Adds a corner to the last ring.
    pub(crate) fn add(&mut self, x: f64, y: f64, z: Option<f64>) {
        if let Some(ring) = self.rings.last_mut() {
            ring.push([x, y]);
        }
        // Only the outer ring is on the ground.
        if self.rings.len() == 1
            && let Some(z) = z.filter(|z| z.is_finite())
        {
            self.height = Some(self.height.map_or(z, |lowest| lowest.min(z)));
        }
    }

    /// The lot: map x is x, map y is −z, and z is the height of the lot above y = 0.
    ///
    /// # Errors
    /// A sentence: the rings are not a polygon.
    pub(crate) fn shape(&self, [east, north]: Origin, height: Option<f64>) -> Result<Shape, String> {
        let corners = |ring: &Vec<[f64; 2]>| {
            let mut list: Vec<[f64; 2]> = ring.iter().map(|[x, y]| [x - east, north - y]).collect();
            if 1 < list.len() && list.first() == list.last() {
                list.pop();
            }
            list
        };
        let Some((outer, holes)) = self.rings.split_first() else { return Err("the polygon is empty".to_owned()) };
        let holes: Vec<_> = holes.iter().map(corners).collect();
        let height = height.or(self.height).unwrap_or_default();
        let outer = corners(outer);
        let longest = longest(&outer);
        if 0.0 < longest && longest < LEAST_METRES {
            return Err(format!(
                "it is {longest:.1e} m long, so its coordinates are probably degrees; convert them to metres, for example with \
                 `frame.to_crs(frame.estimate_utm_crs())` of geopandas"
            ));
        }
        let made = catch_unwind(|| Shape::footprint(&outer, &holes)).map_err(|_| PANIC.to_owned())?;
        let shape = made.map_err(|why| why.to_string())?;
        if !height.is_finite() {
            return Err("the height is not finite".to_owned());
        }
        Ok(shape.at([0.0, height, 0.0]))
    }
}

/// The longer side of the box around some corners.
fn longest(corners: &[[f64; 2]]) -> f64 {
    let side = |axis: usize| {
        let values = corners.iter().map(|corner| corner[axis]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    side(0).max(side(1))
}

/// The message for a geometry with too many corners.
pub(crate) fn too_many_corners() -> String {
    format!("the geometry has more than {MOST_CORNERS} corners")
}
