//! `colorRamp`.
//!
//! The names are taken from the reference. The colours are our own: each ramp interpolates a few colours in 36 equal
//! steps. The colours of `spectrum` are approximated from the pictures of the *splitArea operation*.

use super::colour::print;
use crate::fault::FaultKind;
use crate::geometry::each::Each;
use crate::run::env::Env;
use crate::value::shown::shown;
use crate::value::text::Text;

/// The number of colours of a ramp.
const STEPS: f64 = 36.0;

/// Red, green and blue in 0..=1.
type Rgb = [f64; 3];

const WHITE: Rgb = [1.0, 1.0, 1.0];
const PALE: Rgb = [0.96, 0.96, 0.9];
const BLACK: Rgb = [0.0, 0.0, 0.0];
const GREEN: Rgb = [0.1, 0.65, 0.2];
const YELLOW: Rgb = [1.0, 0.95, 0.2];
const ORANGE: Rgb = [1.0, 0.55, 0.0];
const RED: Rgb = [0.85, 0.1, 0.1];
const BROWN: Rgb = [0.55, 0.3, 0.1];
const BLUE: Rgb = [0.1, 0.3, 0.8];

/// Colours at equal distances. A ramp between colours with a dull mixture goes through a light one.
const RAMPS: [(&str, &[Rgb]); 6] = [
    ("whiteToBlack", &[WHITE, BLACK]),
    ("greenToRed", &[GREEN, YELLOW, RED]),
    ("yellowToRed", &[YELLOW, RED]),
    ("redToBlue", &[RED, PALE, BLUE]),
    ("orangeToBlue", &[ORANGE, PALE, BLUE]),
    ("brownToBlue", &[BROWN, PALE, BLUE]),
];

/// Steps and their colours in 0..=255: violet, blue, green, yellow, orange, red.
const SPECTRUM: [(f64, [u8; 3]); 7] = [
    (0.0, [203, 90, 180]),
    (8.0, [64, 162, 229]),
    (11.0, [80, 210, 200]),
    (19.5, [255, 255, 40]),
    (22.0, [255, 204, 37]),
    (27.0, [255, 96, 36]),
    (35.0, [255, 43, 42]),
];

/// The colour of a ramp at a value in 0..=1, as `#RRGGBB` (*colorRamp*). A ramp has 36 colours. Values below 0 give the
/// first one, values from 1 on the last one. An unknown name gives white, with a fault.
pub fn color_ramp(env: &mut Env, name: Text, value: f64) -> Text {
    let step = (env.finite(value, "the value on a colour ramp") * STEPS).floor().clamp(0.0, STEPS - 1.0);
    if name.as_str() == "spectrum" {
        let next = SPECTRUM.partition_point(|(at, _)| *at <= step).min(SPECTRUM.len() - 1);
        let [(low, from), (high, to)] = [SPECTRUM[next - 1], SPECTRUM[next]];
        return print(between(
            from.each(|c| f64::from(c) / 255.0),
            to.each(|c| f64::from(c) / 255.0),
            (step - low) / (high - low),
        ));
    }
    let Some((_, colours)) = RAMPS.iter().find(|(known, _)| *known == name.as_str()) else {
        let known: Vec<&str> = RAMPS.iter().map(|(known, _)| *known).chain(["spectrum"]).collect();
        env.fault(
            FaultKind::Value,
            format!("`{}` is not a colour ramp; the ramps are {}", shown(&name), known.join(", ")),
        );
        return print(WHITE);
    };
    let place = step / (STEPS - 1.0) * (colours.len() - 1) as f64;
    let first = (place as usize).min(colours.len() - 2);
    print(between(colours[first], colours[first + 1], place - first as f64))
}

fn between(from: Rgb, to: Rgb, part: f64) -> Rgb {
    [0, 1, 2].each(|channel| from[channel] + (to[channel] - from[channel]) * part)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, faults, text};
    use super::*;

    #[test]
    fn a_ramp_has_36_colours() {
        let env = &mut env();
        let names: Vec<&str> = RAMPS.iter().map(|(name, _)| *name).chain(["spectrum"]).collect();
        assert_eq!(names.len(), 7);
        for name in names {
            let mut at = |value: f64| color_ramp(env, text(name), value);
            // In the middle of each step, to avoid rounding.
            let colours: Vec<Text> = (0..36).map(|step| at((f64::from(step) + 0.5) / 36.0)).collect();
            assert!(colours.windows(2).all(|pair| pair[0] != pair[1]), "{name}");
            assert_eq!([-1e300, -0.1, 0.0, 0.027].map(&mut at), [0; 4].map(|step: usize| colours[step].clone()));
            assert_eq!([0.98, 1.0, 1.1, 1e300].map(&mut at), [35; 4].map(|step: usize| colours[step].clone()));
            assert_eq!(at(0.5), colours[18]);
        }
        assert_eq!(color_ramp(env, text("whiteToBlack"), 0.0).as_str(), "#FFFFFF");
        assert_eq!(color_ramp(env, text("whiteToBlack"), 1.0).as_str(), "#000000");
        assert_eq!(color_ramp(env, text("spectrum"), 1.0).as_str(), "#FF2B2A");
        assert_eq!(color_ramp(env, text("spectrum"), 0.24).as_str(), "#40A2E5");
        assert_eq!(faults(env), 0);
        assert_eq!(color_ramp(env, text("pinkToBlack"), 0.5).as_str(), "#FFFFFF");
        color_ramp(env, text("spectrum"), f64::NAN);
        assert_eq!(faults(env), 2);
    }
}
