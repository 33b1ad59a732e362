//! Workload A-chance: the façade of workload A with randomly lit glass.

use cga::{Settings, Shape, Sink, cga};

use super::facade::{GLASS, PLAIN, Size};
use super::share::share;
use super::{Expected, Raw, Workload, run};

/// The material of lit glass.
const LIT: u32 = 1;

cga! {
    /// The façade with lit and dark windows.
    grammar LitWindows;

    Lot    --> comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { 4 : Shop. | { ~3 : Floor }* }
    Floor  --> split(x) { 0.5 : Wall. | { ~2.5 : Tile }* | 0.5 : Wall. }
    Tile   --> split(x) { ~1 : Wall. | 1.2 : Mid | ~1 : Wall. }
    Mid    --> split(y) { ~1 : Wall. | 1.5 : Window | ~0.8 : Wall. }
    Window --> split(x) { 0.1 : Frame | ~1 : WMid | 0.1 : Frame }
    WMid   --> split(y) { 0.1 : Frame | ~1 : t(0, 0, -0.1) Glass | 0.1 : Frame }
    Frame  --> extrude(0.08) Frame.
    Glass  --> 30% : color("#ffe0a0") Lit. else : Dark.
}

/// The façade with lit and dark windows.
pub(crate) struct Facade {
    size: Size,
    lot: [Shape; 1],
    grammar: LitWindows,
    settings: Settings,
}

impl Facade {
    pub(crate) fn new(size: Size) -> Self {
        Facade { lot: [size.lot()], size, grammar: LitWindows::default(), settings: Settings::default() }
    }
}

impl Workload for Facade {
    fn name(&self) -> String {
        self.size.name("A-chance")
    }

    fn expected(&self) -> Expected {
        self.size.expected()
    }

    fn is_main(&self) -> bool {
        self.size.is_main()
    }

    fn by_hand(&mut self, out: &mut Raw) {
        let mut window = 0;
        let glass = || {
            window += 1;
            if share(window) < 0.3 { (GLASS, LIT) } else { (GLASS + 1, PLAIN) }
        };
        self.size.by_hand(PLAIN, glass, out);
    }

    fn derive<S: Sink>(&mut self, sink: &mut S) {
        run!(self.grammar, &self.settings, &self.lot, sink);
    }
}
