//! Diagnostics of a program of several files, each quoted from its own file.

use super::{Quote, headline, place};
use crate::compile::Compiled;
use crate::diag::Diag;
use crate::span::Span;

/// A diagnostic of [`compile`](crate::compile::compile) as text, in the form of [`render`](super::render). `quote`
/// returns the files, numbered as in [`Compiled::files`]. For a file without a quote, only the name is shown.
pub fn render_in<'t>(compiled: &Compiled, quote: &dyn Fn(usize) -> Option<Quote<'t>>, diag: &Diag) -> String {
    let (file, first) = compiled.locate(diag.span.first);
    let Some(own) = quote(file) else {
        let name = compiled.files.get(file).map_or("", |file| &file.name);
        return format!("{}\n --> {name}", headline(diag));
    };
    let span = Span { first, last: compiled.locate(diag.span.last).1.max(first) };
    let related = |span: Span| {
        let (other, token) = compiled.locate(span.first);
        let quote = quote(other)?;
        let line = quote.start(Span::one(token)).line;
        Some(if other == file { format!("line {line}") } else { format!("line {line} of {}", quote.name) })
    };
    format!("{}\n{}", headline(diag), place(own, span, diag, &related))
}

#[cfg(test)]
mod tests {
    use super::{Quote, render_in};
    use crate::compile::compile;
    use crate::link::tests::{Library, unit};
    use crate::snippet::Lines;
    use crate::syntax::lex::lex;

    #[test]
    fn each_file_is_quoted_in_its_findings() {
        let texts =
            ["# own\nimport lib : \"lib.cga\" (h = \"x\")\nLot --> lib.Roof Wal", "attr h = 1\nRoof --> size(h)"];
        let (lexed, lines) = (texts.map(lex), texts.map(Lines::new));
        let compiled = compile(unit("a.cga", texts[0]), &mut Library(texts[1]), &[]);
        let quote = |file: usize| {
            let name = ["a.cga", "lib.cga"][file];
            Some(Quote { name, lines: &lines[file], ranges: &lexed[file].ranges })
        };
        let all: Vec<String> = compiled.diags.iter().map(|diag| render_in(&compiled, &quote, diag)).collect();
        assert!(all.iter().any(|text| text.contains("--> a.cga:2:29\n") && text.contains("(h = \"x\")")), "{all:#?}");
        assert!(all.iter().any(|text| text.contains("--> a.cga:3:18\n")), "{all:#?}");
        assert!(all.iter().any(|text| text.contains("--> lib.cga:2:10\n") && text.contains("Roof --> size(h)")));
        let without = render_in(&compiled, &|_| None, &compiled.diags[0]);
        assert!(without.ends_with("\n --> a.cga"), "{without}");
    }
}
