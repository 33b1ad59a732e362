//! The picture of the city, on machines with a graphics card or a software renderer.

use std::process::Command;

#[test]
fn the_picture_shows_the_city() {
    let path = std::env::temp_dir().join(format!("city-{}.png", std::process::id()));
    let run = Command::new(env!("CARGO_BIN_EXE_city")).arg("--screenshot").arg(&path).output().expect("a run");
    let said = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    if said.contains("Unable to find a GPU") {
        println!("left out: Bevy finds no graphics card and no software renderer");
        return;
    }
    assert!(run.status.success(), "{said}");
    let file = std::fs::File::open(&path).unwrap_or_else(|error| panic!("{error}\n{said}"));
    let mut decoder = png::Decoder::new(std::io::BufReader::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG file");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut bytes).expect("its pixels");
    std::fs::remove_file(&path).expect("a file");
    let channels = info.color_type.samples();
    let pixels: Vec<[i32; 3]> = bytes[..info.buffer_size()]
        .chunks_exact(channels)
        .map(|pixel| [pixel[0], pixel[1], pixel[2]].map(i32::from))
        .collect();
    let share = |is_like: fn([i32; 3]) -> bool| {
        pixels.iter().filter(|pixel| is_like(**pixel)).count() as f64 / pixels.len() as f64
    };
    let sky = share(|[r, g, b]| r < g && g < b && 150 < b);
    let green = share(|[r, g, b]| r + 5 < g && b + 5 < g);
    let picked = share(|[r, g, b]| g + 80 < r && b <= g && 180 < r);
    let walls = share(|[r, g, b]| 120 < b && b <= g && g <= r && r < b + 90);
    let street = share(|[r, g, b]| r < 130 && (r - g).abs() < 14 && (g - b).abs() < 14);
    assert!(
        0.03 < sky && 0.005 < green && 0.02 < picked && 0.1 < walls && 0.2 < street,
        "{sky} {green} {picked} {walls} {street}"
    );
}
