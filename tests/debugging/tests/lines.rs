//! Backtraces and debuggers show the lines of rules.

use std::process::{Command, Output};

const PROGRAM: &str = env!("CARGO_BIN_EXE_cga-debugging");
const SOURCE: &str = include_str!("../src/main.rs");

/// The line that ends with a text.
fn line(end: &str) -> usize {
    1 + SOURCE.lines().position(|line| line.ends_with(end)).unwrap_or_else(|| panic!("no line ends with `{end}`"))
}

/// Runs a command; returns its output and errors as text.
fn run(command: &mut Command) -> String {
    let Output { stdout, stderr, .. } = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    String::from_utf8_lossy(&stdout).into_owned() + &String::from_utf8_lossy(&stderr)
}

/// The functions of the program in the backtrace of its panic, each with its line, from the inside out.
fn backtrace(source: &str) -> Vec<(String, usize)> {
    let text = run(Command::new(PROGRAM).arg(source).env("RUST_BACKTRACE", "full"));
    let mut function = "";
    let mut frames = Vec::new();
    for line in text.lines().map(str::trim) {
        match line.strip_prefix("at ") {
            None => function = line,
            Some(place) => {
                let Some((_, place)) = place.split_once("main.rs:") else { continue };
                let number = place.split(':').next().and_then(|number| number.parse().ok());
                frames.push((function.to_owned(), number.unwrap_or_else(|| panic!("{text}"))));
            }
        }
    }
    assert!(text.contains("3 by "), "{text}");
    frames
}

/// The lines of a rule in a backtrace. Its closures are frames too.
fn lines(frames: &[(String, usize)], rule: &str) -> Vec<usize> {
    let is_in = |function: &str| function.split("::").any(|part| part == rule);
    let mut lines: Vec<usize> = frames.iter().filter(|(function, _)| is_in(function)).map(|(_, line)| *line).collect();
    lines.dedup();
    lines
}

#[test]
fn a_backtrace_has_the_line_of_each_rule() {
    let frames = backtrace("inline");
    assert_eq!(lines(&frames, "Floor"), [line("a call of Rust")], "{frames:?}");
    assert_eq!(lines(&frames, "Tower"), [line("a successor in a slot"), line("the split of Tower")], "{frames:?}");
    assert_eq!(lines(&frames, "Lot"), [line("a successor of Lot")], "{frames:?}");
}

#[test]
fn rules_of_strings_and_files_have_their_names_and_the_line_of_the_literal() {
    let sources = [("string", "String", "        r#\""), ("file", "File", "in \"rules/tower.cga\";")];
    for (source, prefix, literal) in sources {
        let frames = backtrace(source);
        for rule in ["Lot", "Tower", "Floor"] {
            assert_eq!(lines(&frames, &format!("{prefix}{rule}")), [line(literal)], "{rule}: {frames:?}");
        }
    }
}

/// The output of `gdb`, which stops at a line and then runs commands; `None` if it is not installed.
fn gdb(comment: &str, commands: &[&str]) -> Option<String> {
    if Command::new("gdb").arg("--version").output().is_err() {
        println!("gdb is not installed: rules are not debugged");
        return None;
    }
    let mut gdb = Command::new("gdb");
    gdb.args(["--batch", "--nx", "-ex", "set disable-randomization off", "-ex", "set debuginfod enabled off"]);
    gdb.args(["-ex", &format!("tbreak main.rs:{}", line(comment)), "-ex", "run"]);
    gdb.args(commands.iter().flat_map(|command| ["-ex", command]));
    Some(run(gdb.args(["--args", PROGRAM, "inline"])))
}

/// The lines of the program at which `gdb` stopped, in order.
fn stops(shown: &str) -> Vec<usize> {
    // A stop shows the number of the line, a tabulator and the line.
    let stop = |text: &str| {
        let (number, line) = text.split_once('\t')?;
        let number = number.parse().ok()?;
        (SOURCE.lines().nth(number - 1) == Some(line)).then_some(number)
    };
    let mut stops: Vec<usize> = shown.lines().filter_map(stop).collect();
    // A step of several statements is stopped at several times.
    stops.dedup();
    stops
}

#[test]
fn a_debugger_stops_at_the_line_of_a_step_and_goes_to_the_next() {
    let Some(shown) = gdb("the first step of Floor", &["next"; 20]) else { return };
    let expected = [
        "the first step of Floor",
        "// brackets",
        "a step in brackets",
        "a leaf in brackets",
        "// brackets",
        "a condition",
        "a call of Rust",
    ];
    assert!(stops(&shown).starts_with(&expected.map(line)), "{shown}");
}

#[test]
fn a_debugger_stops_in_a_slot_and_in_a_function() {
    for comment in ["a successor in a slot", "in a function", "a successor of Lot"] {
        let Some(shown) = gdb(comment, &[]) else { return };
        assert_eq!(stops(&shown), [line(comment)], "{shown}");
    }
}

#[test]
fn a_debugger_prints_parameters_and_locals_by_name() {
    let print = ["print height", "print gap", "print W"];
    let Some(shown) = gdb("the first step of Floor", &print) else { return };
    for value in ["$1 = 3", "$2 = 1", "$3 = 6"] {
        assert!(shown.lines().any(|line| line == value), "{value}: {shown}");
    }
    // A name of the generated code gets a `_` at the end.
    let Some(shown) = gdb("a successor in a slot", &["print cx_"]) else { return };
    assert!(shown.lines().any(|line| line == "$1 = 3"), "{shown}");
}
