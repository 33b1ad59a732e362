use cga::sink::buffers::Buffers;
use cga::{Settings, Shape, cga};
use std::time::Instant;
cga! { grammar A;
    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
}
cga! { grammar Set;
    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> setupProjection(0, scope.xy, 2, 1) split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
}
cga! { grammar Walls;
    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> setupProjection(0, scope.xy, 2, 1) split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall | { ~2.5 : Tile }* | 0.5 : Wall }
    Tile   --> split(x) { ~1 : Wall | 1.2 : Mid | ~1 : Wall }
    Mid    --> split(y) { ~1 : Wall | 1.5 : Window | ~0.8 : Wall }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
    Wall --> projectUV(0) Wall.
}
cga! { grammar Whole;
    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> setupProjection(0, scope.xy, 2, 1) projectUV(0) split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
}
cga! { grammar Tiles;
    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> setupProjection(0, scope.xy, ^1, ^1) projectUV(0) split(x) { 0.1 : Frame. | ~1 : WMid | 0.1 : Frame. }
    WMid   --> split(y) { 0.1 : Frame. | ~1 : Glass. | 0.1 : Frame. }
}
fn main() {
    let lot = Shape::cuboid(40.0 * 2.5 + 1.0, 40.0 * 3.0 + 4.0, 40.0 * 2.5 + 1.0);
    let settings = Settings::default();
    macro_rules! time {
        ($g:ident) => {{
            let g = $g::default();
            let mut b = Buffers::new();
            let mut best = f64::MAX;
            let mut fold = f64::MAX;
            let mut leaves = 0;
            let session = g.session(&settings).unwrap();
            let mut session = session;
            for _ in 0..40 {
                b.clear();
                let t = Instant::now();
                let r = session.run(&lot, &mut b).unwrap();
                best = best.min(t.elapsed().as_secs_f64());
                leaves = r.leaves;
                let mut n = cga::sink::stats::Stats::new();
                let t = Instant::now();
                let _ = session.run(&lot, &mut n).unwrap();
                fold = fold.min(t.elapsed().as_secs_f64());
            }
            println!(
                "{:6} {} leaves, buffers {:.2} ns a leaf, stats {:.2}; uvs {}",
                stringify!($g),
                leaves,
                best * 1e9 / leaves as f64,
                fold * 1e9 / leaves as f64,
                b.uvs().len()
            );
        }};
    }
    time!(A);
    time!(Set);
    time!(Walls);
    time!(Whole);
    time!(Tiles);
}
