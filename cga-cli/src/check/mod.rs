//! Checks rule files: errors and warnings as the macro reports them. Findings are text with the
//! lines of the file, one line each, or JSON.

mod count;
mod files;
pub(crate) mod format;
mod printer;
#[cfg(test)]
mod tests;

use std::io::{BufWriter, Result, Write};
use std::time::Instant;

use self::printer::Printer;
use crate::options::CheckOptions;
use crate::status::Status;
use crate::stream::say;
use cga_source::RuleFiles;

/// Checks files and folders.
pub(crate) fn check(options: &CheckOptions, out: &mut dyn Write) -> Result<Status> {
    let out = &mut BufWriter::new(out);
    let start = Instant::now();
    let files = RuleFiles::default();
    let files = match &options.root {
        Some(root) => files.inside(root),
        None => Ok(files.with_disk()),
    };
    let mut files = match files {
        Ok(files) => files,
        Err(why) => {
            say(why);
            return Ok(Status::Unusable);
        }
    };
    let (list, mut unread) = files::find(&options.paths);
    let mut numbers = Vec::new();
    for path in &list {
        match files.load(path) {
            Ok(number) => numbers.push(number),
            Err(why) => unread.push(why),
        }
    }
    let mut printer = Printer::new(options, files::imported(&mut files, &numbers));
    for number in numbers {
        printer.file(&mut files, number, out)?;
    }
    printer.totals(start.elapsed(), out)?;
    out.flush()?;
    for why in &unread {
        say(why);
    }
    Ok(match (unread.is_empty(), printer.has_failed()) {
        (false, _) => Status::Unusable,
        (true, true) => Status::Failed,
        (true, false) => Status::Success,
    })
}
