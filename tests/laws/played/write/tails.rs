//! Two rules that differ in some steps: these may be without effect.

use super::{Here, Writer};

/// Bodies of both rules; one of the two has more in place of `#`.
const BODIES: [&str; 14] = [
    "Wall. #",
    "Wall. # Roof.",
    "# Wall.",
    "[ s('0.5, 2, '1) Wall. # ]",
    "[ print(0) # ] Wall.",
    "[ Wall. ] #",
    "split(x) { ~1 : Wall. # | 1 : Roof. }",
    "split(x) { ~1 : Wall. } #",
    "comp(f) { all : Wall. } #",
    "comp(f) { top : Wall. # | side : Roof. } #",
    "case ? : Wall. # else : Roof.",
    "[ case ? : Wall. else : Roof. ] #",
    "[ case ? : Wall. else : NIL ] #",
    "[ case ? : print(0) # else : Wall. # ] Roof.",
];

const STEPS: [&str; 8] = [
    "t(1, 0, 0)",
    "s('0.5, '1, 3)",
    "s('2, '2, '2) color(\"#ff0000\")",
    "extrude(2)",
    "primitiveCube()",
    "set(u, 7)",
    "r(0, 30, 0) center(xz)",
    "set(scope.sx, 4) i(\"builtin:cube\")",
];

impl Writer {
    pub(super) fn tails(&mut self, here: Here) {
        let condition = self.condition(here, 1);
        let body = self.of(&BODIES).replace('?', &condition);
        let step = self.of(&STEPS);
        self.text.push_str(&format!("\nTail -->\n    {}\n", body.replace('#', step)));
        self.text.push_str(&format!("\nBare -->\n    {}\n", body.replace('#', "")));
    }
}
