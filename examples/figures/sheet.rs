//! Pictures in rows, each with its caption below.

use cga::Model;
use cga::sink::picture::{Camera, Image, Lines, Picture};

/// A picture with its caption.
pub(crate) struct Cell {
    pub(crate) model: Model,
    pub(crate) camera: Camera,
    /// True to draw the borders between pieces in one plane too, and all lines strongly.
    pub(crate) borders: bool,
    /// The lines of the caption. A long line is broken at ` | ` or a space, and continues with an indent.
    pub(crate) caption: String,
}

/// Wide enough for the longest line of most examples.
const WIDTH: usize = 660;
const HEIGHT: usize = 330;
const SPACE: usize = 16;
/// The pixels per dot of a character.
const SCALE: usize = 2;
const INK: [u8; 4] = [0x22, 0x22, 0x22, 0xff];

/// Draws cells in rows of `columns`.
pub(crate) fn draw(cells: &[Cell], columns: usize) -> Image {
    let captions: Vec<String> = cells.iter().map(|cell| broken(&cell.caption)).collect();
    let rows: Vec<usize> = captions
        .chunks(columns)
        .map(|row| row.iter().map(|text| Image::text_size(SCALE, text).1).max().unwrap_or(0) + HEIGHT + 4 * SPACE)
        .collect();
    let width = columns.min(cells.len()) * (WIDTH + SPACE) + SPACE;
    let mut sheet = Image::filled(width, rows.iter().sum::<usize>() + SPACE, [0xff; 4]);
    for (number, (cell, caption)) in cells.iter().zip(&captions).enumerate() {
        let x = SPACE + number % columns * (WIDTH + SPACE);
        let y = SPACE + rows[..number / columns].iter().sum::<usize>();
        let mut picture = Picture::new(WIDTH, HEIGHT);
        if cell.borders {
            picture.lines = Lines::Leaves;
            picture.style.line_opacity = 0.9;
        }
        sheet.blit(&picture.camera(cell.camera).render(&cell.model), x as i64, y as i64);
        sheet.text(x as i64, (y + HEIGHT + SPACE) as i64, SCALE, caption, INK);
    }
    sheet
}

/// Breaks lines that are wider than a picture.
fn broken(text: &str) -> String {
    let most = WIDTH / Image::text_size(SCALE, "mm").0.saturating_sub(Image::text_size(SCALE, "m").0).max(1);
    let mut out = Vec::new();
    for line in text.lines() {
        let indent = line.len() - line.trim_start().len();
        let mut rest = line.to_owned();
        while most < rest.chars().count() {
            let fits = rest.char_indices().nth(most).map_or(rest.len(), |(at, _)| at);
            // A break must not be in the white space at the start of the line.
            let start = rest.len() - rest.trim_start().len();
            let last = |what: &str| rest[..fits].rfind(what).filter(|at| start < *at);
            let at = last(" | ").or(last(" ")).unwrap_or(fits);
            let next = format!("{:indent$}  {}", "", rest[at..].trim_start());
            out.push(rest[..at].to_owned());
            rest = next;
        }
        out.push(rest);
    }
    out.join("\n")
}
