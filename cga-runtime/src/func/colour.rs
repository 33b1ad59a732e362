//! Colours as text, such as "#ff8000", and as numbers. Channels are in 0..=1, hues in degrees.

use crate::fault::FaultKind;
use crate::geometry::each::Each;
use crate::run::env::Env;
use crate::value::shown::shown;
use crate::value::text::Text;

/// Red, green and blue.
type Rgb = [f64; 3];

/// The bytes of `#rrggbb` or `#rrggbboo`.
fn bytes(hex: &str) -> Option<([u8; 3], Option<u8>)> {
    let digits = hex.strip_prefix('#')?;
    if !matches!(digits.len(), 6 | 8) || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return None;
    }
    let byte = |at: usize| u8::from_str_radix(digits.get(at..at + 2)?, 16).ok();
    Some(([byte(0)?, byte(2)?, byte(4)?], byte(6)))
}

/// Red, green and blue as bytes. If the text is not a colour, black, with a fault.
fn read(env: &mut Env, hex: &str) -> [u8; 3] {
    let read = bytes(hex);
    if read.is_none() {
        env.fault(
            FaultKind::Value,
            format!("`{}` is not a colour like \"#ff8000\"; black is used instead", shown(hex)),
        );
    }
    read.unwrap_or_default().0
}

fn share(byte: u8) -> f64 {
    f64::from(byte) / 255.0
}

/// Red, in 0..=1 (*colorHexToR*).
pub fn color_hex_to_r(env: &mut Env, hex: Text) -> f64 {
    share(read(env, &hex)[0])
}

/// Green, in 0..=1 (*colorHexToG*).
pub fn color_hex_to_g(env: &mut Env, hex: Text) -> f64 {
    share(read(env, &hex)[1])
}

/// Blue, in 0..=1 (*colorHexToB*).
pub fn color_hex_to_b(env: &mut Env, hex: Text) -> f64 {
    share(read(env, &hex)[2])
}

/// Opacity, in 0..=1; 0 when the text has none (*colorHexToO*).
pub fn color_hex_to_o(env: &mut Env, hex: Text) -> f64 {
    read(env, &hex);
    bytes(&hex).and_then(|(_, opacity)| opacity).map_or(0.0, share)
}

/// Hue in degrees, from 0 to below 360; 0 for grey (*colorHexToH*).
pub fn color_hex_to_h(env: &mut Env, hex: Text) -> f64 {
    let [r, g, b] = read(env, &hex).each(f64::from);
    let most = r.max(g).max(b);
    let range = most - r.min(g).min(b);
    if range == 0.0 {
        0.0
    } else if most == r {
        (60.0 * ((g - b) / range)).rem_euclid(360.0)
    } else if most == g {
        60.0 * ((b - r) / range + 2.0)
    } else {
        60.0 * ((r - g) / range + 4.0)
    }
}

/// Saturation, in 0..=1 (*colorHexToS*).
pub fn color_hex_to_s(env: &mut Env, hex: Text) -> f64 {
    let channels = read(env, &hex).each(f64::from);
    let (least, most) = channels.iter().fold((255.0f64, 0.0f64), |(least, most), &c| (least.min(c), most.max(c)));
    if most == 0.0 { 0.0 } else { (most - least) / most }
}

/// Value: the largest channel, in 0..=1 (*colorHexToV*).
pub fn color_hex_to_v(env: &mut Env, hex: Text) -> f64 {
    let [r, g, b] = read(env, &hex);
    share(r.max(g).max(b))
}

/// A channel as a byte: clamped to 0..=1, halves rounded up.
fn digits(channel: f64) -> u8 {
    (channel.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// `#RRGGBB`, in the form that functions of the language return.
pub(super) fn print([r, g, b]: Rgb) -> Text {
    Text::from(format!("#{:02X}{:02X}{:02X}", digits(r), digits(g), digits(b)))
}

/// `#RRGGBBOO`.
fn print_with_opacity(rgb: Rgb, opacity: f64) -> Text {
    Text::from(format!("{}{:02X}", print(rgb), digits(opacity)))
}

/// Red, green and blue of a hue, saturation and value. Hues repeat every 360 degrees.
fn from_hsv(hue: f64, saturation: f64, value: f64) -> Rgb {
    let (saturation, value) = (saturation.clamp(0.0, 1.0), value.clamp(0.0, 1.0));
    // In each sixth of the circle one channel is the value, one is the minimum, and the third rises or falls between
    // the two.
    let sixth = hue.rem_euclid(360.0) / 60.0;
    let channel = |shift: f64| {
        let place = (sixth + shift) % 6.0;
        let above = place.min(4.0 - place).clamp(0.0, 1.0);
        value * (1.0 - saturation * above)
    };
    [channel(5.0), channel(3.0), channel(1.0)]
}

fn rgb(env: &mut Env, red: f64, green: f64, blue: f64) -> Rgb {
    [env.finite(red, "red"), env.finite(green, "green"), env.finite(blue, "blue")]
}

fn hsv(env: &mut Env, hue: f64, saturation: f64, value: f64) -> Rgb {
    from_hsv(env.finite(hue, "the hue"), env.finite(saturation, "the saturation"), env.finite(value, "the value"))
}

/// `#RRGGBB`; channels are clamped to 0..=1 (*colorRGBToHex*).
pub fn color_rgb_to_hex(env: &mut Env, red: f64, green: f64, blue: f64) -> Text {
    print(rgb(env, red, green, blue))
}

/// `#RRGGBBOO`; channels and opacity are clamped to 0..=1 (*colorRGBOToHex*).
pub fn color_rgbo_to_hex(env: &mut Env, red: f64, green: f64, blue: f64, opacity: f64) -> Text {
    let rgb = rgb(env, red, green, blue);
    print_with_opacity(rgb, env.finite(opacity, "the opacity"))
}

/// `#RRGGBB`; the hue is taken modulo 360, the others are clamped to 0..=1 (*colorHSVToHex*).
pub fn color_hsv_to_hex(env: &mut Env, hue: f64, saturation: f64, value: f64) -> Text {
    print(hsv(env, hue, saturation, value))
}

/// `#RRGGBBOO`; the hue is taken modulo 360, the others are clamped to 0..=1 (*colorHSVOToHex*).
pub fn color_hsvo_to_hex(env: &mut Env, hue: f64, saturation: f64, value: f64, opacity: f64) -> Text {
    let rgb = hsv(env, hue, saturation, value);
    print_with_opacity(rgb, env.finite(opacity, "the opacity"))
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, faults, text};
    use super::*;

    #[test]
    fn colours_become_text() {
        let env = &mut env();
        assert_eq!(color_hsv_to_hex(env, 90.0, 0.5, 0.5).as_str(), "#608040");
        assert_eq!(color_hsvo_to_hex(env, 90.0, 0.5, 0.5, 0.5).as_str(), "#60804080");
        assert_eq!(color_rgb_to_hex(env, 0.0, 0.5, 1.0).as_str(), "#0080FF");
        assert_eq!(color_rgbo_to_hex(env, 0.0, 0.5, 1.0, 0.5).as_str(), "#0080FF80");
        assert_eq!(color_rgbo_to_hex(env, -1.0, 7.0, 1e300, -0.0).as_str(), "#00FFFF00");
        let hues = [0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 360.0, -120.0, 840.0];
        let colours =
            ["#FF0000", "#FFFF00", "#00FF00", "#00FFFF", "#0000FF", "#FF00FF", "#FF0000", "#0000FF", "#00FF00"];
        assert_eq!(hues.map(|hue| color_hsv_to_hex(env, hue, 1.0, 1.0)), colours.map(text));
        assert_eq!(color_hsv_to_hex(env, 77.0, -3.0, 0.2).as_str(), "#333333");
        assert_eq!(color_hsv_to_hex(env, 1e300, 2.0, 0.0).as_str(), "#000000");
        assert_eq!(faults(env), 0);
        assert_eq!(color_rgb_to_hex(env, f64::NAN, 1.0, f64::INFINITY).as_str(), "#00FF00");
        assert_eq!(faults(env), 2);
    }

    #[test]
    fn colours_become_numbers() {
        // *colorHexToB* and the others.
        let env = &mut env();
        let blue = || text("#4080BF");
        assert!((color_hex_to_r(env, blue()) - 0.25098).abs() < 1e-5);
        assert_eq!((color_hex_to_g(env, blue()), color_hex_to_b(env, blue())), (128.0 / 255.0, 191.0 / 255.0));
        assert_eq!((color_hex_to_o(env, blue()), color_hex_to_o(env, text("#4080BF80"))), (0.0, 128.0 / 255.0));
        for green in ["#608040", "#60804080"] {
            let of = |channel: fn(&mut Env, Text) -> f64, env: &mut Env| channel(env, text(green));
            assert_eq!((of(color_hex_to_h, env), of(color_hex_to_s, env)), (90.0, 0.5));
            assert_eq!(of(color_hex_to_v, env), 128.0 / 255.0);
        }
        let hues = ["#ff0000", "#ff00ff", "#0000FF", "#00ff00", "#808080", "#000000"];
        assert_eq!(hues.map(|hex| color_hex_to_h(env, text(hex))), [0.0, 300.0, 240.0, 120.0, 0.0, 0.0]);
        assert_eq!(color_hex_to_s(env, text("#000000")), 0.0);
        assert_eq!(faults(env), 0);
        for bad in ["", "#", "4080BF", "#408", "#40é0BF", "#+f0000", "#4080BF8"] {
            assert_eq!((color_hex_to_v(env, text(bad)), color_hex_to_o(env, text(bad))), (0.0, 0.0));
        }
        assert_eq!(faults(env), 14);
    }

    #[test]
    fn colours_go_back_and_forth() {
        let env = &mut env();
        for (r, g, b) in (0..=255).step_by(17).flat_map(|r| [0, 3, 128, 254, 255].map(|b| (r, 255 - r / 2, b))) {
            let hex = || text(&format!("#{r:02X}{g:02X}{b:02X}"));
            let (h, s, v) = (color_hex_to_h(env, hex()), color_hex_to_s(env, hex()), color_hex_to_v(env, hex()));
            assert_eq!(color_hsv_to_hex(env, h, s, v), hex());
            let (r, g, b) = (color_hex_to_r(env, hex()), color_hex_to_g(env, hex()), color_hex_to_b(env, hex()));
            assert_eq!(color_rgb_to_hex(env, r, g, b), hex());
        }
        assert_eq!(faults(env), 0);
    }
}
