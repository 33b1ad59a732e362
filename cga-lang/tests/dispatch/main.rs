//! The calls of the runtime's operations, functions and attributes in `cga-eval/src/dispatch` follow from the tables. The tests
//! write these files again if `CGA_BLESS` is set.

mod attributes;
mod functions;
mod operations;
mod words;

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use cga_lang::ops::{Param, ParamKind};

/// Compares a generated file with the one in the repository, or writes it.
fn check(name: &str, about: &str, body: &str) {
    let note = "Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.";
    let code = formatted(&format!("//! {about}\n//!\n//! {note}\n\n{body}"));
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..");
    let path = root.join("cga-eval/src/dispatch").join(name);
    if std::env::var_os("CGA_BLESS").is_some() {
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(&path, code).expect("the file is written");
        return;
    }
    let known = fs::read_to_string(&path).unwrap_or_default();
    assert!(known == code, "{} is out of date; run the test with CGA_BLESS=1", path.display());
}

/// Formats code as the rest of the repository.
fn formatted(code: &str) -> String {
    let config = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--config-path", config])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("rustfmt is installed");
    rustfmt.stdin.take().expect("a pipe").write_all(code.as_bytes()).expect("rustfmt reads");
    let output = rustfmt.wait_with_output().expect("rustfmt ends");
    assert!(output.status.success(), "{code}");
    String::from_utf8(output.stdout).expect("text")
}

/// The arguments of a call: statements before the closure that runs it, statements in it, and the arguments themselves.
struct Arguments {
    /// Reads words and kinds of lengths, which are known when rules are loaded.
    known: String,
    /// Takes values from the stack, the last one first.
    taken: String,
    /// The arguments of the call.
    passed: String,
}

/// The arguments for parameters. Words are variants of enums in `module`.
fn arguments(params: &[Param], module: &str) -> Arguments {
    let (mut known, mut taken, mut passed) = (String::new(), Vec::new(), String::new());
    for (number, param) in params.iter().enumerate() {
        let name = format!("a{number}");
        match &param.kind {
            ParamKind::Word(words) => {
                let function = words::function(module, words.rust);
                write!(known, "let {name} = words::{function}(known.word({number})?)?;").expect("text");
            }
            ParamKind::Length => {
                write!(known, "let length{number} = known.length({number});").expect("text");
                taken.push(format!("let {name} = length{number}.of(stack.float());"));
            }
            ParamKind::Size => {
                write!(known, "let size{number} = known.size({number});").expect("text");
                taken.push(format!("let {name} = size{number}.of(stack.float());"));
            }
            ParamKind::Any => {
                write!(known, "let type{number} = known.ty({number})?;").expect("text");
                taken.push(format!("let {name} = stack.value(type{number});"));
            }
            kind => taken.push(format!("let {name} = stack.{}();", kind.argument())),
        }
        write!(passed, "{name},").expect("text");
    }
    taken.reverse();
    Arguments { known, taken: taken.concat(), passed }
}
