//! Cameras.

use cga_geometry::mesh::Bounds;

/// A camera with a direction, at the distance from which everything is in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The azimuth of the camera in degrees around the model: 0 in front (on the side of +z), 90 to the right (+x).
    pub azimuth: f64,
    /// The elevation of the camera in degrees: 0 level with the model, 90 straight above.
    pub elevation: f64,
    /// The projection.
    pub projection: Projection,
    /// The region of the world that must be in the picture.
    pub bounds: Bounds,
    /// The free space around it, as a fraction of the picture's smaller side.
    pub margin: f64,
    /// True to give the direction with more free space equal space on both sides. Perspective makes the near side larger,
    /// so a wide model otherwise has more space below it than above.
    pub centred: bool,
}

/// The viewpoint of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Viewpoint {
    /// The default three-quarter view of the whole model: [`Camera::auto`].
    #[default]
    Auto,
    /// The whole model, from a direction in degrees; see [`Camera::azimuth`] and [`Camera::elevation`].
    Around {
        /// The azimuth.
        azimuth: f64,
        /// The elevation.
        elevation: f64,
    },
    /// A camera that does not depend on the model.
    Camera(Camera),
}

impl Viewpoint {
    /// The camera for a model with those bounds.
    pub fn camera(&self, bounds: Bounds) -> Camera {
        match *self {
            Viewpoint::Auto => Camera::auto(bounds),
            Viewpoint::Around { azimuth, elevation } => Camera::auto(bounds).looking_from(azimuth, elevation),
            Viewpoint::Camera(camera) => camera,
        }
    }
}

/// A projection from space to the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Distant things are smaller. The number is the vertical field of view in degrees, above 0 and below 180.
    Perspective(f64),
    /// Parallels stay parallel.
    Orthographic,
}

impl Camera {
    /// A three-quarter view from the front right and above that shows all of `bounds`.
    ///
    /// A flat, wide model such as a district is seen from higher up than a tower.
    pub fn auto(bounds: Bounds) -> Self {
        let size = bounds.size();
        let flat = size.y < 0.25 * size.x.min(size.z);
        let elevation = if flat { 34.0 } else { 17.0 };
        Camera {
            azimuth: 34.0,
            elevation,
            projection: Projection::Perspective(28.0),
            bounds,
            margin: 0.06,
            centred: false,
        }
    }

    /// The same camera from another direction, in degrees; see the fields.
    pub fn looking_from(self, azimuth: f64, elevation: f64) -> Self {
        Camera { azimuth, elevation, ..self }
    }

    /// The same camera with parallel projection.
    pub fn orthographic(self) -> Self {
        Camera { projection: Projection::Orthographic, ..self }
    }

    /// The same camera with another vertical field of view, in degrees.
    pub fn field_of_view(self, degrees: f64) -> Self {
        Camera { projection: Projection::Perspective(degrees), ..self }
    }
}
