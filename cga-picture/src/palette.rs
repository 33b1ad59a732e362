//! Colours for images with a palette: the median cut.
//!
//! The colours of an image are a cloud of points. The box around the cloud is divided at the median of its longest side,
//! and so are the boxes of the parts, until they are as many as the palette has colours.

use std::collections::BTreeMap;

use cga_geometry::each::Each;

/// An RGB colour.
type Rgb = [u8; 3];

/// The most colours of a palette.
const COLORS: usize = 256;

/// A palette, and the index of a colour for each pixel.
#[derive(Debug)]
pub(crate) struct Indexed {
    pub(crate) palette: Vec<Rgb>,
    pub(crate) pixels: Vec<u8>,
}

impl Indexed {
    /// The image of RGBA pixels in rows of `width`, in at most 256 colours. Images with few colours stay as they are; in
    /// others, a fine pattern mixes neighbouring colours where a gradient would otherwise have steps. The opacity is
    /// left out.
    pub(crate) fn new(rgba: &[u8], width: usize) -> Indexed {
        let colors = || rgba.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]]);
        let mut counts: BTreeMap<Rgb, usize> = BTreeMap::new();
        colors().for_each(|color| *counts.entry(color).or_default() += 1);
        let few = counts.len() <= COLORS;
        let palette: Vec<Rgb> = divided(counts.into_iter().collect()).iter().map(|members| mean(members)).collect();
        let mut known: BTreeMap<Rgb, usize> = BTreeMap::new();
        let pixels = colors().enumerate().map(|(at, color)| {
            let (x, y) = (at % width.max(1), at / width.max(1));
            let wanted = if few { color } else { mixed(color, x, y) };
            *known.entry(wanted).or_insert_with(|| nearest(&palette, wanted)) as u8
        });
        let pixels = pixels.collect();
        Indexed { palette, pixels }
    }
}

/// The thresholds of ordered dithering (Bayer's matrix), in sixteenths.
const PATTERN: [[i32; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
/// The strength of the pattern: about the distance between two neighbours in the palette.
const STRENGTH: i32 = 7;

/// A colour that is a little brighter or darker, by the place of its pixel.
fn mixed(color: Rgb, x: usize, y: usize) -> Rgb {
    let shift = (2 * PATTERN[y % 4][x % 4] - 15) * STRENGTH / 32;
    color.each(|channel| (i32::from(channel) + shift).clamp(0, 255) as u8)
}

/// The index of the colour of the palette with the smallest distance; the first of equal ones.
fn nearest(palette: &[Rgb], wanted: Rgb) -> usize {
    let distance = |color: &Rgb| -> u32 {
        let channels = color.iter().zip(wanted);
        channels.map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum()
    };
    let best = palette.iter().enumerate().min_by_key(|(_, color)| distance(color));
    best.map_or(0, |(index, _)| index)
}

/// A colour and the number of its pixels.
type Counted = (Rgb, usize);

/// The colours in at most as many boxes as a palette has colours.
fn divided(all: Vec<Counted>) -> Vec<Vec<Counted>> {
    if all.is_empty() {
        return Vec::new();
    }
    let mut boxes = vec![all];
    while boxes.len() < COLORS {
        // The box with the largest error if it were one colour.
        let worst = (0..boxes.len()).max_by_key(|&at| (error(&boxes[at]), std::cmp::Reverse(at)));
        let Some(worst) = worst.filter(|&at| 1 < boxes[at].len()) else { break };
        let mut members = std::mem::take(&mut boxes[worst]);
        let (channel, _) = longest(&members);
        members.sort_by_key(|&(color, _)| (color[channel], color));
        let half = members.iter().map(|&(_, count)| count).sum::<usize>() / 2;
        let mut before = 0;
        let below = members.iter().take_while(|&&(_, count)| {
            before += count;
            before <= half
        });
        // Both parts have a colour.
        let at = below.count().clamp(1, members.len() - 1);
        let above = members.split_off(at);
        boxes[worst] = members;
        boxes.push(above);
    }
    boxes
}

/// The channel in which colours differ most, and by how much.
fn longest(members: &[Counted]) -> (usize, u8) {
    let side = |channel: usize| {
        let values = members.iter().map(|&(color, _)| color[channel]);
        values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
    };
    let channel = (0..3).max_by_key(|&channel| (side(channel), std::cmp::Reverse(channel))).unwrap_or(0);
    (channel, side(channel))
}

/// The weight of the error of a box: its length counts more than the number of its pixels, so that rare colours survive.
fn error(members: &[Counted]) -> u128 {
    let (_, side) = longest(members);
    let count: usize = members.iter().map(|&(_, count)| count).sum();
    u128::from(side).pow(2) * (count.isqrt() as u128)
}

/// The mean colour of pixels.
fn mean(members: &[Counted]) -> Rgb {
    let count = members.iter().map(|&(_, count)| count).sum::<usize>().max(1);
    [0, 1, 2].each(|channel| {
        let sum: usize = members.iter().map(|&(color, count)| usize::from(color[channel]) * count).sum();
        ((sum + count / 2) / count) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(indexed: &Indexed) -> Vec<Rgb> {
        indexed.pixels.iter().map(|&index| indexed.palette[usize::from(index)]).collect()
    }

    #[test]
    fn few_colours_stay_as_they_are() {
        let rgba: Vec<u8> = (0..1000_u32).flat_map(|at| [(at % 16) as u8 * 3, (at % 16) as u8, 200, 255]).collect();
        let indexed = Indexed::new(&rgba, 10);
        assert_eq!(indexed.palette.len(), 16);
        let wanted: Vec<Rgb> = rgba.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
        assert_eq!(shown(&indexed), wanted);
    }

    #[test]
    fn many_colours_change_little() {
        // All colours with channels that are multiples of 8: 32 cubed.
        let channel = |at: u32| (at % 32) as u8 * 8;
        let rgba: Vec<u8> =
            (0..32_768).flat_map(|at| [channel(at), channel(at / 32), channel(at / 1024), 255]).collect();
        let indexed = Indexed::new(&rgba, 128);
        assert_eq!(indexed.palette.len(), COLORS);
        let pixels = rgba.chunks_exact(4).zip(shown(&indexed));
        let off = pixels.flat_map(|(pixel, color)| [0, 1, 2].map(|i| pixel[i].abs_diff(color[i]))).max();
        // 256 cubes of equal size have sides of 40.3; the pattern adds 3.
        assert!(off.is_some_and(|off| off <= 43), "{off:?}");
    }

    #[test]
    fn a_rare_colour_survives_among_many_similar_ones() {
        let mut rgba: Vec<u8> = (0..200_000_u32).flat_map(|at| [(at % 97) as u8, (at % 89) as u8, 90, 255]).collect();
        rgba.extend([255, 0, 0, 255]);
        let indexed = Indexed::new(&rgba, 1000);
        let [r, g, b] = *shown(&indexed).last().expect("the last pixel");
        assert!(r > 230 && g < 25 && b < 25, "{r} {g} {b}");
    }

    #[test]
    fn a_gradient_keeps_its_mean_everywhere() {
        // More shades than a palette has.
        let width = 900;
        let shade = |x: u32| [(x / 6) as u8, (x / 5) as u8, 120 + (x / 9) as u8, 255];
        let rgba: Vec<u8> = (0..32 * 900).flat_map(|at| shade(at % 900)).collect();
        let indexed = Indexed::new(&rgba, width);
        let shown = shown(&indexed);
        let sum = |x: usize, get: &dyn Fn(usize) -> u8| -> i32 {
            (0..32).flat_map(|y| (x..x + 20).map(move |x| y * width + x)).map(|at| i32::from(get(at))).sum()
        };
        for x in (40..860).step_by(20) {
            for channel in 0..3 {
                let before = sum(x, &|at| rgba[4 * at + channel]);
                let after = sum(x, &|at| shown[at][channel]);
                let off = f64::from(after - before) / 640.0;
                assert!(off.abs() < 1.0, "{x} {channel}: {off}");
            }
        }
    }

    #[test]
    fn an_empty_image_has_no_colours() {
        let indexed = Indexed::new(&[], 0);
        assert!(indexed.palette.is_empty() && indexed.pixels.is_empty());
    }
}
