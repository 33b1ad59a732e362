//! Prints what a CGA file compiles to.
use cga_lang::{compile::compile_text, ir_print, snippet};
fn main() {
    for file in std::env::args().skip(1) {
        let text = std::fs::read_to_string(&file).unwrap();
        let source = compile_text(&text);
        for diag in &source.compiled.diags {
            println!("{}", snippet::render(&text, &source.ranges, &file, diag));
        }
        if let Some(grammar) = &source.compiled.grammar {
            print!("{}", ir_print::print(grammar));
        }
    }
}
