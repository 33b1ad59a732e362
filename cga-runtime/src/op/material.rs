//! `color` and `texture`.

use crate::env::Env;
use crate::fault::FaultKind;
use crate::material::Color;
use crate::shape::ShapeRef;
use crate::text::Text;

/// `color("#rrggbb")` or `color("#rrggbboo")` (*color operation*). The short form leaves the opacity alone.
pub fn color_hex(env: &mut Env, shape: &mut ShapeRef<'_>, hex: Text) {
    match parse_hex(&hex) {
        Some((color, opacity)) => shape.change_material(|material| {
            material.color = Some(color);
            material.opacity = opacity.or(material.opacity);
        }),
        None => {
            env.fault(FaultKind::Value, format!("`{hex}` is no colour like \"#ff8000\"; the colour stays as it is"))
        }
    }
}

/// `color(r, g, b)`, each in 0..=1 (*color operation*).
pub fn color_rgb(env: &mut Env, shape: &mut ShapeRef<'_>, r: f64, g: f64, b: f64) {
    let color = Color::new(env.finite(r, "red"), env.finite(g, "green"), env.finite(b, "blue"));
    shape.set_color(color);
}

/// `color(r, g, b, opacity)`, each in 0..=1 (*color operation*).
pub fn color_rgba(env: &mut Env, shape: &mut ShapeRef<'_>, r: f64, g: f64, b: f64, opacity: f64) {
    color_rgb(env, shape, r, g, b);
    let opacity = env.finite(opacity, "opacity").clamp(0.0, 1.0);
    shape.change_material(|material| material.opacity = Some(opacity));
}

/// `texture(file)`: the colour map; empty text takes it away (*texture operation*).
pub fn texture(_: &mut Env, shape: &mut ShapeRef<'_>, file: Text) {
    shape.change_material(|material| material.texture = Some(file));
}

/// Channels of `#rrggbb` or `#rrggbboo`.
fn parse_hex(hex: &str) -> Option<(Color, Option<f64>)> {
    let digits = hex.strip_prefix('#')?;
    if !matches!(digits.len(), 6 | 8) || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let channel = |at: usize| digits.get(at..at + 2).and_then(|pair| u8::from_str_radix(pair, 16).ok());
    let part = |at: usize| channel(at).map(|byte| f64::from(byte) / 255.0);
    Some((Color { r: part(0)?, g: part(2)?, b: part(4)? }, part(6)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hex_colours_are_read_or_refused() {
        assert_eq!(parse_hex("#ff0000"), Some((Color { r: 1.0, g: 0.0, b: 0.0 }, None)));
        assert_eq!(parse_hex("#84C0fC00").and_then(|(_, opacity)| opacity), Some(0.0));
        for bad in ["", "#", "ff0000", "#ff00", "#gg0000", "#ff00001", "#é0000", "#+f0000"] {
            assert_eq!(parse_hex(bad), None, "{bad}");
        }
    }
}
