//! Windows and shops, each as one image.

use cga::sink::picture::Image;

/// A window with a cross of bars.
pub fn window() -> Image {
    let mut image = Image::filled(256, 384, [238, 234, 224, 255]);
    for (column, row) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let (x, y, height) = (22 + column * 112, 22 + row * 130, if row == 0 { 112 } else { 210 });
        image.rectangle(x, y, 100, height, [52, 72, 86, 255]);
        for step in 0..40_i64 {
            let shine = |channel: i64| (channel + 30 - step) as u8;
            image.rectangle(x + step * 2, y + 40 - step, 4, 12, [shine(72), shine(98), shine(114), 255]);
        }
    }
    image
}

/// A shop window above a plinth.
pub fn shop() -> Image {
    let mut image = Image::filled(256, 512, [70, 52, 44, 255]);
    image.rectangle(16, 16, 224, 380, [96, 118, 122, 255]);
    image.rectangle(16, 16, 224, 60, [126, 146, 148, 255]);
    image.rectangle(16, 300, 224, 96, [150, 128, 92, 255]);
    image
}
