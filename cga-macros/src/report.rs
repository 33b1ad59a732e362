//! Diagnostics as compiler errors and warnings.

use cga_lang::diag::{Basis, Diag, Level, Line};
use cga_lang::snippet::{Lines, Quote, place};
use cga_source::rust::Problem;
use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::quote_spanned;

use crate::source::Source;

/// The largest number of errors shown, and of warnings: rustc takes long over more.
const MOST_SHOWN: usize = 100;

/// Diagnostics as tokens.
pub(crate) struct Findings {
    pub(crate) tokens: TokenStream,
    pub(crate) has_errors: bool,
}

/// Turns diagnostics into tokens, in source order.
pub(crate) fn findings(list: &[Diag], source: &Source) -> Findings {
    let mut list: Vec<&Diag> = list.iter().filter(|diag| diag.level != Level::Allow).collect();
    list.sort_by_key(|diag| diag.span);
    let count = |level: Level| list.iter().filter(|diag| diag.level == level).count();
    let (errors, warnings) = (count(Level::Error), count(Level::Warning));
    let (mut errors_shown, mut warnings_shown) = (0, 0);
    let finding = |diag: &Diag| {
        let (shown, all) = match diag.level {
            Level::Error => (&mut errors_shown, errors),
            _ => (&mut warnings_shown, warnings),
        };
        *shown += 1;
        if MOST_SHOWN < *shown {
            return TokenStream::new();
        }
        let mut message = message(diag, source);
        if *shown == MOST_SHOWN && *shown < all {
            message.push_str(&format!("\nnote: {} more are not shown", all - *shown));
        }
        let (first, last) = source.span(diag.span);
        match diag.level {
            Level::Error => error(first, last, &message),
            _ => warning(first, diag.code.name(), &message),
        }
    };
    let tokens = list.iter().copied().map(finding).collect();
    Findings { tokens, has_errors: 0 < errors }
}

/// Errors alone, for editors: they show warnings when the package is checked.
pub(crate) fn errors(list: &[Diag], source: &Source) -> TokenStream {
    let errors: Vec<Diag> = list.iter().filter(|diag| diag.level == Level::Error).cloned().collect();
    findings(&errors, source).tokens
}

/// The lines of a diagnostic. Rules in text are quoted.
fn message(diag: &Diag, source: &Source) -> String {
    // Warnings show their code anyway.
    let is_lint = diag.level == Level::Error && diag.code.is_lint();
    let level = is_lint.then(|| format!("this is `{}`, whose level can be changed", diag.code.name()));
    if let Some((text, first)) = source.text_of(diag.span.first) {
        let token = |token: u32| source.text_of(token).map_or(token, |(_, token)| token);
        let span = cga_lang::span::Span { first, last: token(diag.span.last) };
        let related = |place: cga_lang::span::Span| source.line(place.first);
        let mut shown = diag.clone();
        (shown.notes, shown.basis) = (diag.reasons().collect(), Basis::Rules);
        level.into_iter().for_each(|level| _ = shown.note(level));
        let quote = Quote { name: &text.name, lines: &Lines::new(&text.written), ranges: &text.ranges };
        return format!("{}\n{}", diag.message, place(quote, span, &shown, &related));
    }
    let mut message = spelled(&diag.message);
    for note in diag.reasons() {
        message.push_str(&format!("\nnote: {}", spelled(&note.text)));
        if let Some(line) = note.related.and_then(|place| source.line(place.first)) {
            message.push_str(&format!(" ({line})"));
        }
    }
    level.into_iter().for_each(|level| message.push_str(&format!("\nnote: {level}")));
    for help in &diag.help {
        message.push_str(&format!("\nhelp: {}", spelled(help)));
    }
    message
}

/// A line in the spelling of inline rules: `^` for relative sizes.
fn spelled(line: &Line) -> String {
    line.spelled('^')
}

/// The error of a source that cannot be opened.
pub(crate) fn problem(problem: &Problem) -> TokenStream {
    error(problem.first, problem.last, &problem.message)
}

/// A compiler error underlined from one place to another: rustc takes the span of the first and the last token.
pub(crate) fn error(first: Span, last: Span, message: &str) -> TokenStream {
    let path = quote_spanned!(first=> ::core::compile_error);
    let mut text = Literal::string(message);
    text.set_span(last);
    let mut group = Group::new(Delimiter::Brace, TokenTree::Literal(text).into());
    group.set_span(last);
    let mut bang = Punct::new('!', Spacing::Alone);
    bang.set_span(first);
    path.into_iter().chain([TokenTree::Punct(bang), TokenTree::Group(group)]).collect()
}

/// A compiler warning, underlined at one token. Stable Rust has none for macros, but the use of a deprecated item makes one
/// with our text. Of a macro, rustc shows the path as it is written: "use of deprecated macro `cga::no_effect`: …".
///
/// Rejected, after a build of each with Rust 1.95: other deprecated items, whose line shows the anonymous constant around
/// them ("constant `walls::_::no_effect`"); `#[must_use = "…"]`, and reasons of `#[expect]` and `#[warn]`, which move our
/// text to a note below a line about something else; `#[cfg]`, `#[doc]` and `#[diagnostic]` with unknown words, which show
/// their own text; the assembler's `.warning`, which shows our text alone, but has no place and needs code generation.
fn warning(place: Span, code: &str, message: &str) -> TokenStream {
    let (ours, name) = (Ident::new("cga", place), Ident::new(code, place));
    quote_spanned! { Span::mixed_site()=>
        const _: () = {
            mod #ours {
                #[deprecated(note = #message)]
                macro_rules! #name {
                    () => {};
                }
                #[allow(deprecated)]
                pub(super) use #name;
            }
            #ours::#name!();
        };
    }
}
