//! Conversion from linear light to sRGB.

/// A table from linear channels to sRGB bytes.
pub(super) struct Gamma(Vec<u8>);

impl Gamma {
    const STEPS: usize = 1 << 14;

    pub(super) fn new() -> Self {
        let srgb = |c: f32| if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * libm::powf(c, 1.0 / 2.4) - 0.055 };
        Gamma((0..=Self::STEPS).map(|i| (srgb(i as f32 / Self::STEPS as f32) * 255.0 + 0.5) as u8).collect())
    }

    pub(super) fn byte(&self, linear: f32) -> u8 {
        self.0[(linear.clamp(0.0, 1.0) * Self::STEPS as f32 + 0.5) as usize]
    }
}
