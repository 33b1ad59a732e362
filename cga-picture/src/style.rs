//! The colours of light and surroundings.

/// Colours of light and surroundings, in linear light.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// Sunlight on a surface that faces it.
    pub sun: [f32; 3],
    /// Skylight on a roof that sees all of the sky.
    pub sky: [f32; 3],
    /// Light from the ground on a surface that faces down.
    pub bounce: [f32; 3],
    /// The backdrop at the top and near the bottom.
    pub backdrop: [[f32; 3]; 2],
    /// The ground near the model.
    pub ground: [f32; 3],
    /// The lines.
    pub line: [f32; 3],
    /// The opacity of the lines, 0 to 1.
    pub line_opacity: f32,
    /// The share of light that white surfaces reflect, 0 to 1.
    pub albedo: f32,
}

impl Default for Style {
    fn default() -> Self {
        Style {
            sun: [1.12, 0.99, 0.80],
            sky: [0.47, 0.55, 0.68],
            bounce: [0.42, 0.38, 0.33],
            backdrop: [[0.36, 0.54, 0.76], [0.84, 0.89, 0.93]],
            ground: [0.78, 0.76, 0.72],
            line: [0.02, 0.025, 0.035],
            line_opacity: 0.5,
            albedo: 0.9,
        }
    }
}
