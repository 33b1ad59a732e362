//! Texture coordinates on a façade: none, a projection that is only set up, and coordinates on walls, on the whole
//! façade and on each window.
//!
//! `cargo bench --bench textures`. The façade is the one of workload A, 40 bays wide and 40 floors high.

mod common;

use cga::sink::buffers::Buffers;
use cga::sink::stats::Stats;
use cga::{Settings, Shape, cga};
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};

/// The façade of workload A with further steps: on the façade, on walls, on windows.
macro_rules! facades {
    ($name:ident, [$($facade:tt)*], [$($wall:tt)*], [$($window:tt)*]) => {
        cga! {
            grammar $name;
            Lot    --> comp(f) { side : Facade | top : Roof. }
            Facade --> $($facade)* split(y) { 4 : Shop. | { ~3 : Floor }* }
            Floor  --> split(x) { 0.5 : Wall | { ~2.5 : Tile }* | 0.5 : Wall }
            Tile   --> split(x) { ~1 : Wall | 1.2 : Mid | ~1 : Wall }
            Mid    --> split(y) { ~1 : Wall | 1.5 : Window | ~0.8 : Wall }
            Window --> $($window)* split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
            WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
            Frame  --> extrude(0.08) Frame.
            Wall   --> $($wall)* Wall.
        }
    };
}

facades!(Plain, [], [], []);
facades!(SetUp, [setupProjection(0, scope.xy, 2, 1)], [], []);
facades!(OnWalls, [setupProjection(0, scope.xy, 2, 1)], [projectUV(0)], []);
facades!(OnFacade, [setupProjection(0, scope.xy, 2, 1) projectUV(0)], [], []);
facades!(OnWindows, [], [], [setupProjection(0, scope.xy, ^1, ^1) projectUV(0)]);

/// A run, which returns the number of its leaves.
type Way<'w> = Box<dyn FnMut() -> u64 + 'w>;

/// The seconds for which each row is repeated.
const SECONDS: f64 = 1.0;

fn main() {
    let lot = Shape::cuboid(40.0 * 2.5 + 1.0, 40.0 * 3.0 + 4.0, 40.0 * 2.5 + 1.0);
    let settings = Settings::default();
    let columns =
        ["coordinates", "buffers / none", "statistics / none", "terminals", "buffers, ns a terminal", "statistics, ns"];
    let mut table = Table::new("Texture coordinates of a façade", &columns);
    let mut plain = None;
    let mut row = |name: &str, [mut buffers, mut statistics]: [Way<'_>; 2]| {
        let mut leaves = 0;
        let best = fastest(SECONDS, [&mut || leaves = buffers(), &mut || _ = statistics()]);
        let each = best.map(|time| nanoseconds_each(time, leaves as usize));
        let [plain_buffers, plain_stats] = *plain.get_or_insert(each);
        let ratios = [each[0] / plain_buffers, each[1] / plain_stats].map(|ratio| number(ratio, 2));
        table.row(name, &[&ratios[..], &[leaves.to_string()], &each.map(|time| number(time, 1))].concat());
    };
    macro_rules! rows {
        ($($name:literal $grammar:ident)*) => {$(
            let grammar = $grammar::default();
            let [mut session, mut other] = [0, 1].map(|_| grammar.session(&settings).expect("a session"));
            let mut buffers = Buffers::new();
            row($name, [
                Box::new(|| {
                    buffers.clear();
                    session.run(&lot, &mut buffers).expect("no error").leaves
                }),
                Box::new(|| other.run(&lot, &mut Stats::new()).expect("no error").leaves),
            ]);
        )*};
    }
    rows! {
        "none" Plain
        "projection set up" SetUp
        "on walls" OnWalls
        "on the façade" OnFacade
        "on each window" OnWindows
    }
    table.print();
}
