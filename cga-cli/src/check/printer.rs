//! Findings and summaries of files.

use super::count::count;
use super::format::{self, Format};
use crate::options::CheckOptions;
use crate::stream::visible_line;
use cga_lang::compile::compile;
use cga_lang::diag::code::Code;
use cga_lang::diag::{Diag, Diags, Level, Line};
use cga_lang::syntax::parse::parse;
use cga_source::RuleFiles;
use std::cell::OnceCell;
use std::collections::{BTreeMap, HashSet};
use std::io::{Result, Write};
use std::time::Duration;

/// The limit on findings of a file that are printed with their lines. Longer lists are for programs.
const MOST_SHOWN: usize = 1000;

/// The identity of a finding: file, first and last token there, code, message.
type FindingKey = (String, u32, u32, Code, Line);

/// Prints findings and summaries, and counts them.
pub(crate) struct Printer<'o> {
    options: &'o CheckOptions,
    /// Files that other files import: no run starts in them.
    imported: HashSet<String>,
    /// The findings so far. A file that many import has the same findings each time.
    seen: HashSet<FindingKey>,
    files: usize,
    failed: usize,
    lines: usize,
    codes: BTreeMap<(Level, Code), usize>,
}

impl<'o> Printer<'o> {
    pub(crate) fn new(options: &'o CheckOptions, imported: HashSet<String>) -> Self {
        Printer { options, imported, seen: HashSet::new(), files: 0, failed: 0, lines: 0, codes: BTreeMap::new() }
    }

    /// Returns true if a file has errors, or warnings that are denied.
    pub(crate) fn has_failed(&self) -> bool {
        let denied = |level: Level| level == Level::Error || self.options.deny_warnings;
        0 < self.failed || self.codes.keys().any(|(level, _)| denied(*level))
    }

    /// Checks a file, and prints new findings and a summary.
    pub(crate) fn file(&mut self, files: &mut RuleFiles, number: usize, out: &mut dyn Write) -> Result<()> {
        let root = files.unit(number);
        let mut again = Diags::new();
        let counts = count(&parse(&root.tokens, &mut again));
        // The compiler reports the same.
        again.finish();
        let compiled = compile(root, files, &[]);
        let lines = vec![OnceCell::new(); compiled.files.len()];
        let quote = |file: usize| files.quote(&compiled.files.get(file)?.name, lines.get(file)?);
        let mut own = Own::default();
        let mut more = 0;
        let is_imported = self.imported.contains(&compiled.files[0].name);
        let is_about_start = |diag: &Diag| matches!(diag.code, Code::NoStartRule | Code::UnmarkedStart);
        for diag in compiled.diags.iter().filter(|diag| !(is_imported && is_about_start(diag))) {
            let (file, first) = compiled.locate(diag.span.first);
            own.add(diag, file == 0);
            let last = compiled.locate(diag.span.last).1;
            if !self.seen.insert((compiled.files[file].name.clone(), first, last, diag.code, diag.message.clone())) {
                continue;
            }
            *self.codes.entry((diag.level, diag.code)).or_default() += 1;
            if self.options.quiet || self.options.no_warnings && diag.level != Level::Error {
                continue;
            }
            if own.shown == MOST_SHOWN && self.options.format == Format::Full {
                more += 1;
                continue;
            }
            own.shown += 1;
            format::write(self.options.format, &compiled, &quote, diag, out)?;
        }
        if 0 < more && self.options.format == Format::Full {
            writeln!(out, "… and {more} more\n")?;
        }
        self.files += 1;
        self.failed += usize::from(0 < own.errors + own.imported);
        self.lines += files.text(number).lines().count();
        if self.options.format != Format::Full {
            return Ok(());
        }
        let name = &compiled.files[0].name;
        let parts = [(counts.rules, "rule"), (counts.splits, "split"), (counts.comps, "comp")].map(counted).join(", ");
        let name = visible_line(name);
        write!(out, "{name}: {parts}; {}, {}", counted((own.errors, "error")), counted((own.warnings, "warning")))?;
        if 0 < own.imported {
            write!(out, "; {} in imported files", counted((own.imported, "error")))?;
        }
        writeln!(out)
    }

    /// The sum of all files.
    pub(crate) fn totals(&self, time: Duration, out: &mut dyn Write) -> Result<()> {
        if self.options.format != Format::Full {
            return Ok(());
        }
        let size = [(self.files, "file"), (self.lines, "line")].map(counted).join(", ");
        writeln!(out, "\n{size}, {} with errors, {time:.1?}", self.failed)?;
        for (level, word) in [(Level::Error, "error"), (Level::Warning, "warning")] {
            let codes = self.codes.iter().filter(|((own, _), _)| *own == level);
            let codes: BTreeMap<String, usize> =
                codes.map(|((_, code), count)| (code.name().to_owned(), *count)).collect();
            let sum: usize = codes.values().sum();
            let colon = if sum == 0 { "" } else { ": " };
            writeln!(out, "{}{colon}{}", counted((sum, word)), list(&codes))?;
        }
        Ok(())
    }
}

/// The findings of one file.
#[derive(Default)]
struct Own {
    errors: usize,
    warnings: usize,
    shown: usize,
    /// Errors in imported files.
    imported: usize,
}

impl Own {
    fn add(&mut self, diag: &Diag, here: bool) {
        match (diag.level, here) {
            (Level::Error, true) => self.errors += 1,
            (Level::Error, false) => self.imported += 1,
            (_, true) => self.warnings += 1,
            (_, false) => {}
        }
    }
}

/// A number of things.
fn counted((count, thing): (usize, &str)) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}

/// Names with numbers, the most frequent first.
fn list(counts: &BTreeMap<String, usize>) -> String {
    let mut all: Vec<(&String, &usize)> = counts.iter().collect();
    all.sort_by_key(|(name, count)| (std::cmp::Reverse(**count), *name));
    let shown: Vec<String> = all.iter().map(|(name, count)| format!("{name} {count}")).collect();
    shown.join(", ")
}
