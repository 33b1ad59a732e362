//! Conversions between linear light and sRGB.

/// Converts an sRGB channel to linear light, both from 0 to 1.
pub fn linear(srgb: f64) -> f64 {
    match srgb {
        c if c <= 0.04045 => c / 12.92,
        c => libm::pow((c + 0.055) / 1.055, 2.4),
    }
}

/// A table from linear channels to sRGB bytes.
pub(crate) struct Gamma(Vec<u8>);

impl Gamma {
    const STEPS: usize = 1 << 14;

    pub(crate) fn new() -> Self {
        let srgb = |c: f32| if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * libm::powf(c, 1.0 / 2.4) - 0.055 };
        Gamma((0..=Self::STEPS).map(|i| (srgb(i as f32 / Self::STEPS as f32) * 255.0 + 0.5) as u8).collect())
    }

    pub(crate) fn byte(&self, linear: f32) -> u8 {
        self.0[(linear.clamp(0.0, 1.0) * Self::STEPS as f32 + 0.5) as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_survive_the_way_to_linear_light_and_back() {
        assert_eq!((linear(0.0), linear(1.0)), (0.0, 1.0));
        let gamma = Gamma::new();
        // The steps of the table are coarser than the darkest bytes.
        for byte in 16..=255_u8 {
            assert_eq!(gamma.byte(linear(f64::from(byte) / 255.0) as f32), byte);
        }
        assert_eq!([f32::NEG_INFINITY, f32::INFINITY, f32::NAN].map(|light| gamma.byte(light)), [0, 255, 0]);
    }
}
