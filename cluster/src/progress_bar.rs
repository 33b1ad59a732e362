//! A bar in the terminal.

use std::time::Duration;

use indicatif::{ProgressBar as Bar, ProgressStyle};

use crate::run::Progress;

/// A bar for a person who waits. It is not drawn if standard error is not a terminal.
pub(crate) struct ProgressBar(Bar);

impl ProgressBar {
    pub(crate) fn new(is_quiet: bool) -> Self {
        let bar = if is_quiet { Bar::hidden() } else { Bar::new_spinner() };
        bar.enable_steady_tick(Duration::from_millis(200));
        ProgressBar(bar)
    }

    /// Ends the bar, so that lines can follow.
    pub(crate) fn end(&self) {
        self.0.finish_and_clear();
    }
}

impl Progress for ProgressBar {
    fn step(&self, name: &str, buildings: Option<u64>) {
        let template = match buildings {
            Some(_) => "{msg}: {bar:40} {pos} of {len} buildings, {eta} left",
            None => "{spinner} {msg}, {elapsed}",
        };
        self.0.set_style(ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()));
        self.0.set_message(name.to_owned());
        self.0.set_position(0);
        buildings.into_iter().for_each(|count| self.0.set_length(count));
    }

    fn finished(&self, buildings: u64) {
        self.0.set_position(buildings);
    }
}
