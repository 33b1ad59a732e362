//! Averages of normals.

use glam::DVec3;

use crate::mesh::unit;
use crate::tol::COPLANAR_EPSILON;

/// The average of normals. Equal normals count once, so that it does not depend on how a plane is divided.
#[derive(Default)]
pub(crate) struct AverageNormal {
    directions: Vec<DVec3>,
}

impl AverageNormal {
    pub(crate) fn clear(&mut self) {
        self.directions.clear();
    }

    pub(crate) fn add(&mut self, normal: DVec3) {
        /// The number of directions up to which equal directions are recognised.
        const MOST_DIRECTIONS: usize = 64;
        let known = |other: &DVec3| (*other - normal).length() <= COPLANAR_EPSILON;
        if MOST_DIRECTIONS <= self.directions.len() || !self.directions.iter().any(known) {
            self.directions.push(normal);
        }
    }

    /// The unit vector in the direction of the average; zero if the normals cancel.
    pub(crate) fn unit(&self) -> DVec3 {
        let sum: DVec3 = self.directions.iter().sum();
        // The sum of normals that cancel is a rounding error.
        if sum.length() <= COPLANAR_EPSILON { DVec3::ZERO } else { unit(sum) }
    }
}
