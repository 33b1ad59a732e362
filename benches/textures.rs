//! Texture coordinates: a façade without, with a projection that is only set up, and with coordinates on walls, on all of the façade and
//! on each window.
//!
//! `cargo bench --bench textures`. The façade is that of workload A, 40 bays wide and 40 floors high.

mod common;

use cga::sink::buffers::Buffers;
use cga::sink::stats::Stats;
use cga::{Settings, Shape, cga};
use common::clock::{fastest, nanoseconds_each};
use common::table::{Table, number};

cga! {
    /// Where coordinates are made: 0 nowhere, 1 nowhere but a projection is set up, 2 on walls, 3 on the façade, 4 on windows.
    grammar Facades;
    attr made = 0

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade -->
        case made == 1 || made == 2 : setupProjection(0, scope.xy, 2, 1) Floors
        case made == 3 : setupProjection(0, scope.xy, 2, 1) projectUV(0) Floors
        else : Floors
    Floors --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall | { ~2.5 : Tile }* | 0.5 : Wall }
    Tile   --> split(x) { ~1 : Wall | 1.2 : Mid | ~1 : Wall }
    Mid    --> split(y) { ~1 : Wall | 1.5 : Window | ~0.8 : Wall }
    Window -->
        case made == 4 : setupProjection(0, scope.xy, ^1, ^1) projectUV(0) Panes
        else : Panes
    Panes  --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
    Wall   -->
        case made == 2 : projectUV(0) Wall.
        else : Wall.
}

/// The seconds for which each row is repeated.
const SECONDS: f64 = 1.0;

fn main() {
    let lot = Shape::cuboid(40.0 * 2.5 + 1.0, 40.0 * 3.0 + 4.0, 40.0 * 2.5 + 1.0);
    let settings = Settings::default();
    let columns =
        ["coordinates", "buffers / none", "statistics / none", "terminals", "buffers, ns a terminal", "statistics, ns"];
    let mut table = Table::new("Texture coordinates of a façade", &columns);
    let mut plain = None;
    for (made, name) in ["none", "projection set up", "on walls", "on the façade", "on each window"].iter().enumerate()
    {
        let grammar = Facades { made: made as f64 };
        let [mut session, mut other] = [0, 1].map(|_| grammar.session(&settings).expect("a session"));
        let (mut buffers, mut leaves) = (Buffers::new(), 0);
        let best = fastest(
            SECONDS,
            [
                &mut || {
                    buffers.clear();
                    leaves = session.run(&lot, &mut buffers).expect("no error").leaves;
                },
                &mut || drop(other.run(&lot, &mut Stats::new()).expect("no error")),
            ],
        );
        let each = best.map(|time| nanoseconds_each(time, leaves as usize));
        let [plain_buffers, plain_stats] = *plain.get_or_insert(each);
        let ratios = [each[0] / plain_buffers, each[1] / plain_stats].map(|ratio| number(ratio, 2));
        let cells = [&ratios[..], &[leaves.to_string()], &each.map(|time| number(time, 1))].concat();
        table.row(name, &cells);
    }
    table.print();
}
