//! Workload A-color: the façade of workload A with a colour in every bay.

use cga::{Settings, Shape, Sink, cga};

use super::facade::{GLASS, Size};
use super::{Expected, Raw, Workload, run};

/// The material of the bays.
const BAY: u32 = 1;

cga! {
    /// The façade with coloured bays.
    grammar ColoredBays;

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Bay }* | 0.5 : Wall. }
    Bay    --> color("#d8c8a8") Tile
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass. | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
}

/// The façade with coloured bays.
pub(crate) struct Facade {
    size: Size,
    lot: [Shape; 1],
    grammar: ColoredBays,
    settings: Settings,
}

impl Facade {
    pub(crate) fn new(size: Size) -> Self {
        Facade { lot: [size.lot()], size, grammar: ColoredBays::default(), settings: Settings::default() }
    }
}

impl Workload for Facade {
    fn name(&self) -> String {
        self.size.name("A-color")
    }

    fn expected(&self) -> Expected {
        self.size.expected()
    }

    fn is_main(&self) -> bool {
        self.size.is_main()
    }

    fn by_hand(&mut self, out: &mut Raw) {
        self.size.by_hand(BAY, || (GLASS, BAY), out);
    }

    fn derive<S: Sink>(&mut self, sink: &mut S) {
        run!(self.grammar, &self.settings, &self.lot, sink);
    }
}
