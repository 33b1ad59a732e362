//! PNG files.
#![cfg(feature = "png")]

use std::io::Cursor;

use cga_picture::Bitmap;
use cga_picture::png::{PngError, write, write_indexed};

/// The pixels of a file, and the kind of their colours.
fn read(bytes: Vec<u8>) -> (Vec<u8>, png::ColorType) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().expect("a PNG file");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut pixels).expect("the pixels");
    (pixels, info.color_type)
}

#[test]
fn files_hold_the_pixels() {
    let opaque = Bitmap::filled(3, 2, [1, 2, 3, 255]);
    assert_eq!(read(opaque.to_png().expect("a file")), ([1, 2, 3].repeat(6), png::ColorType::Rgb));
    let clear = Bitmap::filled(3, 2, [1, 2, 3, 4]);
    assert_eq!(read(clear.to_png().expect("a file")), (clear.rgba.clone(), png::ColorType::Rgba));
    let mut indexed = Vec::new();
    write_indexed(3, 2, &clear.rgba, &mut indexed).expect("a file");
    assert_eq!(read(indexed), (vec![0; 6], png::ColorType::Indexed));
}

#[test]
fn wrong_sizes_are_errors() {
    let pixels = [255; 4];
    assert!(matches!(write(2, 1, &pixels, Vec::new()), Err(PngError::Io(_))));
    assert!(matches!(write_indexed(2, 1, &pixels, Vec::new()), Err(PngError::Io(_))));
    assert!(matches!(write(usize::MAX, 1, &pixels, Vec::new()), Err(PngError::TooLarge)));
    let text = PngError::TooLarge.to_string();
    assert_eq!(text, "too large: more than 4294967295 pixels along a side");
}
