//! Fixtures of several files.

use super::{annotate, compare, dialect, fixtures, strip};
use cga_lang::compile::{Compiled, Dialect, compile};
use cga_lang::link::{Asset, Files, Unit, candidates, folder};
use cga_lang::snippet::bytes;
use cga_lang::span::Span;
use cga_lang::syntax::lex::{Lexed, lex};
use std::fs;
use std::ops::Range;

/// The files of a fixture.
pub(crate) struct Parts<'t> {
    text: &'t str,
    list: Vec<Part>,
}

struct Part {
    name: String,
    dialect: Dialect,
    /// Where it is in the fixture.
    range: Range<usize>,
    lexed: Lexed,
}

impl<'t> Parts<'t> {
    /// Cuts a fixture in parts. What is compiled is called `main.cga`.
    pub(crate) fn new(text: &'t str) -> Self {
        let mut heads = vec![(0, "main.cga")];
        let mut at = 0;
        for line in text.split_inclusive('\n') {
            heads.extend(line.strip_prefix("// file: ").map(|name| (at, name.trim())));
            at += line.len();
        }
        let ends = heads.iter().skip(1).map(|(start, _)| *start).chain([text.len()]);
        let part = |((start, name), end): (&(usize, &str), usize)| {
            let own = &text[*start..end];
            Part { name: (*name).into(), dialect: dialect(own), range: *start..end, lexed: lex(own) }
        };
        Parts { text, list: heads.iter().zip(ends).map(part).collect() }
    }

    pub(crate) fn compile(&mut self) -> Compiled {
        let root = self.unit(0);
        compile(root, self, &[])
    }

    fn unit(&self, number: usize) -> Unit {
        let Part { name, dialect, lexed, .. } = &self.list[number];
        Unit { name: name.clone(), tokens: lexed.tokens.clone(), dialect: *dialect, found: lexed.diags.clone() }
    }

    /// The bytes of a span of the program.
    pub(crate) fn range(&self, compiled: &Compiled, span: Span) -> Range<usize> {
        let (file, first) = compiled.locate(span.first);
        let (other, last) = compiled.locate(span.last);
        assert_eq!(file, other, "a finding stays inside its file");
        let name = &compiled.files[file].name;
        let part = self.list.iter().find(|part| part.name == *name).expect("a part of the fixture");
        let own = bytes(&self.text[part.range.clone()], &part.lexed.ranges, Span { first, last });
        own.start + part.range.start..own.end + part.range.start
    }
}

impl Files for Parts<'_> {
    fn open(&mut self, path: &str, from: &str) -> Result<Unit, String> {
        let names = candidates(path, from);
        let number = names.iter().find_map(|name| self.list.iter().position(|part| part.name == *name));
        number.map(|number| self.unit(number)).ok_or_else(|| "there is no such part".into())
    }

    fn beside(&mut self, path: &str, from: &str) -> Vec<String> {
        let folder = folder(path, from);
        let names = self.list.iter().map(|part| part.name.rsplit_once('/').unwrap_or(("", &part.name)));
        names.filter(|(own, _)| *own == folder).map(|(_, name)| name.to_owned()).collect()
    }

    fn asset(&mut self, name: &str) -> Option<Asset> {
        let part = self.list.iter().find(|part| part.name == name || part.name == format!("assets/{name}"));
        Some(match part {
            Some(part) if name.ends_with(".obj") => Asset::obj(&self.text[part.range.clone()]),
            Some(_) => Asset::There,
            None => {
                let names = self.list.iter().map(|part| part.name.trim_start_matches("assets/").to_owned());
                Asset::Missing(names.collect())
            }
        })
    }
}

/// Compares the findings of a folder's fixtures.
pub(crate) fn walk(folder: &str) {
    let bless = std::env::var_os("CGA_BLESS").is_some();
    let mut wrong = String::new();
    for path in fixtures(folder) {
        let stored = fs::read_to_string(&path).expect("readable fixture");
        let text = strip(&stored);
        let mut parts = Parts::new(&text);
        let compiled = parts.compile();
        let actual = annotate(&text, &|span| parts.range(&compiled, span), &compiled.diags);
        compare(&path, &stored, &actual, bless, &mut wrong);
    }
    assert!(wrong.is_empty(), "{wrong}\nCGA_BLESS=1 accepts this");
}
