//! A bar in the terminal.

use std::io;

use cga_city::build::Progress;
use cga_city::tree::TileEvent;
use indicatif::{ProgressBar as Bar, ProgressStyle};

/// A bar for a person who waits. It is not drawn if standard error is not a terminal.
pub(crate) struct ProgressBar(Bar);

/// Rows are shown in steps of this many.
const STEP: u64 = 1000;

impl ProgressBar {
    pub(crate) fn new(is_quiet: bool) -> Self {
        let bar = if is_quiet { Bar::hidden() } else { Bar::new_spinner() };
        bar.set_style(style("{spinner} {pos} rows read"));
        ProgressBar(bar)
    }

    /// Ends the bar, so that lines can follow.
    pub(crate) fn finish(&self) {
        self.0.finish_and_clear();
    }
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

impl Progress for ProgressBar {
    fn row(&self, rows: u64) {
        if rows.is_multiple_of(STEP) {
            self.0.set_position(rows);
        }
    }

    fn read(&self, lots: u64) {
        self.0.set_style(style("{bar:40} {pos} of {len} buildings, {eta} left"));
        self.0.set_position(0);
        self.0.set_length(lots);
    }

    fn tile(&self, event: &TileEvent<'_>) -> io::Result<()> {
        if !event.tile.is_divided {
            self.0.inc(event.lots);
        }
        Ok(())
    }
}
