//! Random grammars that use every construct whose result could depend on how a box or rectangle is held, or on how parts
//! that repeat are derived.
//!
//! Text is written from templates: `$` and a letter is a value of that kind, drawn by [`Writer::value`].

mod blocks;
mod masses;
mod meshes;
mod prologue;
mod repeats;
mod steps;
mod textures;

use crate::random::Random;

/// The rules with a depth, which call each other.
const RULES: [&str; 5] = ["Mass", "Front", "Storey", "Part", "Detail"];

/// A writer of one grammar.
struct Writer {
    random: Random,
    text: String,
    /// The number of the next place that prints.
    mark: usize,
}

/// A place in a rule's body.
#[derive(Clone, Copy)]
struct Here {
    /// The number of the rule in [`RULES`].
    rule: usize,
    /// The number of blocks that may nest here.
    depth: usize,
    indent: usize,
}

impl Here {
    fn deeper(self) -> Here {
        Here { depth: self.depth.saturating_sub(1), indent: self.indent + 1, ..self }
    }
}

/// Returns true if the grammar of a seed prints all that it can observe. Others have many parts that repeat.
pub(crate) fn prints_much(seed: u64) -> bool {
    seed.is_multiple_of(4)
}

/// The grammar of a seed: most have many parts that repeat.
pub(crate) fn write(seed: u64) -> String {
    let mut writer = Writer { random: Random(seed), text: format!("// Seed {seed}.\n"), mark: 1 };
    if prints_much(seed) {
        writer.text.push_str(prologue::TEXT);
        writer.text.push_str(masses::TOOL);
        writer.rules();
    } else {
        writer.repeats();
    }
    writer.text
}

impl Writer {
    /// Draws an event of that probability in percent.
    fn chance(&mut self, percent: usize) -> bool {
        self.random.below(100) < percent
    }

    fn line(&mut self, here: Here, line: &str) {
        self.text.push_str(&" ".repeat(4 * here.indent));
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// One of some templates, filled in.
    fn fill(&mut self, templates: &[&str]) -> String {
        let template = *self.random.pick(templates);
        let mut parts = template.split('$');
        let mut text = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            text += &self.value(&part[..1]);
            text += &part[1..];
        }
        text
    }

    fn rules(&mut self) {
        let here = Here { rule: 0, depth: 2, indent: 1 };
        self.text.push_str("\n@StartRule\nLot -->\n");
        self.watch(here);
        self.steps(here);
        self.line(here, "Mass(2)");
        if self.chance(50) {
            self.steps(here);
            self.line(here, "Front(1)");
        }
        for (rule, name) in RULES.into_iter().enumerate() {
            self.text.push_str(&format!("\n{name}(d) -->\n"));
            let body = Here { rule, depth: if rule + 1 < RULES.len() { 2 } else { 1 }, indent: 1 };
            self.watch(body);
            self.body(body);
        }
    }

    /// Prints what rules can observe here.
    fn watch(&mut self, here: Here) {
        let mut line = String::new();
        for (percent, function) in [(100, "frames"), (70, "form"), (40, "sides"), (40, "parts"), (20, "places")] {
            if self.chance(percent) {
                line += &format!("print({function}({})) ", self.mark);
            }
        }
        if self.chance(30) {
            line += &self.fill(steps::REPORTS);
        }
        self.mark += 1;
        self.line(here, line.trim_end());
    }
}
