//! Checks rule files: errors and warnings as the macro reports them, and the operations that do not run yet. Findings are text with the
//! lines of the file, one line each, or JSON.

mod count;
mod files;
pub(crate) mod format;
mod printer;
#[cfg(test)]
mod tests;

use std::io::{BufWriter, Result, Write};
use std::time::Instant;

use self::files::LoadedFiles;
use self::printer::Printer;
use crate::Status;
use crate::options::CheckOptions;
use crate::stream::say;

/// Checks files and folders.
pub(crate) fn check(options: &CheckOptions, out: &mut dyn Write) -> Result<Status> {
    let out = &mut BufWriter::new(out);
    let start = Instant::now();
    let mut files = match LoadedFiles::new(options.root.as_deref()) {
        Ok(files) => files,
        Err(why) => {
            say(format_args!("cannot read {why}"));
            return Ok(Status::Unusable);
        }
    };
    let (list, mut unread) = files::find(&options.paths);
    let mut numbers = Vec::new();
    for path in &list {
        match files.load(path) {
            Ok(number) => numbers.push(number),
            Err(why) => unread.push(format!("{}: {why}", path.display())),
        }
    }
    let mut printer = Printer::new(options, files.imported(&numbers));
    for number in numbers {
        printer.file(&mut files, number, out)?;
    }
    printer.totals(start.elapsed(), out)?;
    out.flush()?;
    for why in &unread {
        say(format_args!("cannot read {why}"));
    }
    Ok(match (unread.is_empty(), printer.has_failed()) {
        (false, _) => Status::Unusable,
        (true, true) => Status::Failed,
        (true, false) => Status::Success,
    })
}
