//! Files, bytes and writers: the same bytes from each, and errors of writers.

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::Path;

use crate::sink_support::{Fill, color, front, mixed};
use cga_runtime::output::error::WriteError;
use cga_runtime::output::model::Model;
use cga_runtime::output::svg::Svg;
use glam::dvec3;

/// A writer that takes one byte at a time, and is interrupted before each.
#[derive(Default)]
struct OneByte {
    bytes: Vec<u8>,
    ready: bool,
    flushed: bool,
}

impl Write for OneByte {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.ready = !self.ready;
        if self.ready {
            return Err(ErrorKind::Interrupted.into());
        }
        self.flushed = false;
        self.bytes.extend(bytes.first());
        Ok(1.min(bytes.len()))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.flushed = true;
        Ok(())
    }
}

/// A writer with an end, after which each write fails.
struct Full(usize);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let taken = self.0.min(bytes.len());
        self.0 -= taken;
        if taken == 0 && !bytes.is_empty() { Err(io::Error::other("the line is dead")) } else { Ok(taken) }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A writer that counts bytes and keeps the length of the longest piece.
#[derive(Default)]
struct Longest {
    bytes: usize,
    longest: usize,
}

impl Write for Longest {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.bytes += bytes.len();
        self.longest = self.longest.max(bytes.len());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Compares the three forms of a format, and tries writers that fail.
fn check(
    name: &str,
    bytes: &[u8],
    file: impl Fn(&Path) -> Result<(), WriteError>,
    to: impl Fn(&mut dyn Write) -> Result<(), WriteError>,
) {
    let path = std::env::temp_dir().join(format!("cga-writers-{}-{name}", std::process::id()));
    file(&path).expect("a file");
    assert!(fs::read(&path).expect("a file") == bytes, "{name}: the file");
    fs::remove_file(&path).expect("it goes");

    let mut slow = OneByte::default();
    to(&mut slow).expect("a writer without an end");
    assert!(slow.bytes == bytes && slow.flushed, "{name}: the writer");

    for room in [0, 1, 20, bytes.len() / 2, bytes.len() - 1] {
        match to(&mut Full(room)) {
            Err(WriteError::Io(error)) => assert_eq!(error.to_string(), "the line is dead", "{name}"),
            other => panic!("{name}, {room}: {other:?}"),
        }
    }
    let error = to(&mut Full(0)).expect_err("no room");
    assert_eq!(error.to_string(), "cannot write: the line is dead");
    to(&mut Full(bytes.len())).expect("just enough room");
}

#[test]
fn svg_is_the_same_as_text_file_and_stream() {
    let model = mixed();
    check("a.svg", model.to_svg(800, 600).as_bytes(), |path| model.write_svg(path), |out| model.write_svg_to(out));
    let svg = Svg { background: "#fff".into(), ..Svg::new(320, 200) };
    let mut bytes = Vec::new();
    svg.render_to(&model, &mut bytes).expect("memory");
    assert!(bytes == svg.render(&model).as_bytes());
}

#[test]
fn colours_of_an_svg_stay_in_their_attributes() {
    let text = "\"/><script>&";
    let svg = Svg { background: text.into(), line_color: text.into(), ..Svg::new(320, 200) }.render(&mixed());
    assert!(!svg.contains("<script"), "{}", &svg[..300]);
    assert_eq!(svg.matches("&quot;/&gt;&lt;script&gt;&amp;\"").count(), 2, "{}", &svg[..300]);
}

#[cfg(feature = "png")]
#[test]
fn png_is_the_same_as_bytes_file_and_stream() {
    use cga_runtime::output::picture::Picture;
    let image = Picture::new(60, 40).render(&mixed());
    let clear = cga_runtime::output::picture::Image::filled(3, 2, [1, 2, 3, 4]);
    for image in [image, clear] {
        check("a.png", &image.to_png().expect("a file"), |path| image.write_png(path), |out| image.write_png_to(out));
        check(
            "indexed.png",
            &image.to_indexed_png().expect("a file"),
            |path| image.write_indexed_png(path),
            |out| image.write_indexed_png_to(out),
        );
    }
}

#[cfg(feature = "gltf")]
#[test]
fn glb_is_the_same_as_bytes_file_and_stream() {
    use cga_runtime::output::buffers::Buffers;
    use cga_runtime::output::gltf::Glb;
    let model = mixed();
    check("a.glb", &model.to_glb().expect("a file"), |path| model.write_glb(path), |out| model.write_glb_to(out));

    let mut buffers = Buffers::new();
    assert!(model.replay(&mut buffers).is_continue());
    let bytes = buffers.to_glb().expect("a file");
    check("buffers.glb", &bytes, |path| buffers.write_glb(path), |out| buffers.write_glb_to(out));

    let glb = || {
        let mut glb = Glb::new().by_rule().with_extra("height", 24.0);
        assert!(model.replay(&mut glb).is_continue());
        glb
    };
    let mut slow = OneByte::default();
    glb().write_to(&mut slow).expect("a writer without an end");
    assert!(slow.bytes == glb().into_bytes().expect("a file") && slow.flushed);
}

#[cfg(feature = "gltf")]
#[test]
fn nothing_is_written_of_a_model_that_no_file_can_have() {
    let mut fill = Fill(Model::new());
    fill.quad("Wall", &color(1.0, 0.0, 0.0), front(dvec3(1e300, 2.0, 3.0), 1e300, 5.0));
    let mut written = Longest::default();
    assert!(matches!(fill.0.write_glb_to(&mut written), Err(WriteError::NotFinite)));
    assert_eq!(written.bytes, 0);
    let path = std::env::temp_dir().join(format!("cga-writers-{}-kept.glb", std::process::id()));
    fs::write(&path, b"good").expect("a file");
    // With two names a file is written directly, so it must not be opened too early.
    let other = path.with_extension("other");
    fs::hard_link(&path, &other).expect("another name");
    assert!(matches!(fill.0.write_glb(&path), Err(WriteError::NotFinite)));
    assert_eq!(fs::read(&path).expect("a file"), b"good");
    [path, other].iter().for_each(|path| fs::remove_file(path).expect("it goes"));
}

/// A wall of many tiles.
fn wall(tiles: usize) -> Model {
    let mut fill = Fill(Model::new());
    let paint = color(0.5, 0.5, 0.5);
    for at in 0..tiles {
        let (x, y) = ((at % 100) as f64, (at / 100) as f64);
        fill.quad("Tile", &paint, front(dvec3(x, y, 0.0), 0.9, 0.9));
    }
    fill.0
}

/// The largest piece that a writer gets in one call.
const PIECE: usize = 1 << 18;

#[test]
fn svg_is_streamed() {
    let mut written = Longest::default();
    wall(20_000).write_svg_to(&mut written).expect("it counts");
    assert!(4 * PIECE < written.bytes && written.longest < PIECE, "{} {}", written.bytes, written.longest);
}

#[cfg(feature = "gltf")]
#[test]
fn glb_is_streamed() {
    let mut written = Longest::default();
    wall(20_000).write_glb_to(&mut written).expect("it counts");
    assert!(4 * PIECE < written.bytes && written.longest < PIECE, "{} {}", written.bytes, written.longest);
}
