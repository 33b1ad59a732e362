//! Instructions instead of times: equal numbers in every run, even on a busy machine.
//!
//! Each work runs in a child process under callgrind: once to warm up, then once inside [`counted_by_callgrind`],
//! the only function that callgrind counts.

use std::hint::black_box;
use std::process::Command;

use super::table::{Table, number};

/// The first argument of a child process.
pub(crate) const CHILD: &str = "--counted";

/// Returns true if instructions can be counted.
pub(crate) fn can_count() -> bool {
    Command::new("valgrind").arg("--version").output().is_ok()
}

/// The number of instructions of the work that a child process with some arguments does.
pub(crate) fn count(arguments: &[&str]) -> u64 {
    let program = std::env::current_exe().expect("the path of this program");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null", "--toggle-collect=*counted_by_callgrind*"])
        .arg(program)
        .arg(CHILD)
        .args(arguments)
        .output()
        .expect("valgrind runs");
    let text = String::from_utf8_lossy(&output.stderr);
    let collected = text.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok());
    collected.unwrap_or_else(|| panic!("callgrind counted nothing for {arguments:?}:\n{text}"))
}

/// Does work twice, of which the second time is counted.
pub(crate) fn twice(work: &mut dyn FnMut()) {
    work();
    counted_by_callgrind(work);
}

/// Callgrind finds this function by its name.
#[inline(never)]
fn counted_by_callgrind(work: &mut dyn FnMut()) {
    work();
    // Not a tail call: that would leave the function before the work is done.
    black_box(());
}

/// A number of units, and the work for them.
type Prepared = (usize, Box<dyn FnMut()>);

/// Work that is counted, for a number of units.
pub(crate) struct Work {
    name: String,
    make: Box<dyn Fn() -> Prepared>,
}

impl Work {
    /// `make` prepares the work and returns its number of units.
    pub(crate) fn new<F: FnMut() + 'static>(name: &str, make: impl Fn() -> (usize, F) + 'static) -> Self {
        let make = move || -> Prepared {
            let (units, work) = make();
            (units, Box::new(work))
        };
        Work { name: name.to_owned(), make: Box::new(make) }
    }
}

/// Counts instructions if the arguments of the program ask for it. Returns false if they do not.
pub(crate) fn counted(title: &str, unit: &str, works: &[Work]) -> bool {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    if let [first, name] = &arguments[..]
        && first == CHILD
    {
        let work = works.iter().find(|work| work.name == *name).expect("work of this name");
        twice(&mut (work.make)().1);
        return true;
    }
    if !arguments.iter().any(|argument| argument == "--instructions") {
        return false;
    }
    let mut table = Table::new(&format!("{title}: instructions"), &["work", &format!("a {unit}"), &format!("{unit}s")]);
    if !can_count() {
        table.note("Not counted: `valgrind` is not installed.");
    } else {
        for work in works {
            let units = (work.make)().0;
            let each = count(&[&work.name]) as f64 / units as f64;
            table.row(&work.name, &[number(each, 1), units.to_string()]);
        }
    }
    table.print();
    true
}
