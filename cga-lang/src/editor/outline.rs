//! The outline of rules for editors: declarations, and the context of each name, from the tokens alone.
//!
//! An editor asks while a rule is half written. The parser leaves a declaration out if it cannot read it; the outline
//! keeps its name, its parameters and the contexts of its names.

use super::contexts::{Context, contexts};
use super::view::View;
use crate::syntax::token::{Sym, Tok};

/// The kind of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartKind {
    /// `attr name = …`.
    Attr,
    /// `const name = …`.
    Const,
    /// `name(…) = …`.
    Function,
    /// `Name(…) --> …`.
    Rule,
    /// Tokens without a declaration: `style`, `import`, the tokens before the first declaration.
    Other,
}

/// A declaration with all tokens up to the next one.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The kind of declaration.
    pub kind: PartKind,
    /// The token of the declared name. `None` for names with dots.
    pub name: Option<u32>,
    /// The tokens of its parameters.
    pub params: Vec<u32>,
    /// The tokens of its local values, after `with`.
    pub locals: Vec<u32>,
    /// Its doc comments.
    pub docs: Vec<String>,
    /// The first token without annotations, and the token after the last.
    pub range: (u32, u32),
    /// Its names in order, annotations included and declared names left out.
    pub words: Vec<Word>,
}

/// A name in a part.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// The token.
    pub token: u32,
    /// The tokens of the names after it, with dots between them: `sx` in `scope.sx`.
    pub fields: Vec<u32>,
    /// The context, which decides what the name can be.
    pub context: Context,
    /// True if parentheses follow.
    pub is_call: bool,
    /// True if a dot follows, as after a leaf.
    pub is_leaf: bool,
}

/// Finds the parts of a file.
pub fn outline(tokens: &[Tok]) -> Vec<Part> {
    let view = View::new(tokens);
    let starts = starts(&view);
    let mut parts = Vec::with_capacity(starts.len());
    for (number, start) in starts.iter().enumerate() {
        let end = starts.get(number + 1).map_or(view.list.len(), |next| next.first);
        parts.push(part(&view, start, end));
    }
    parts
}

/// The start of a part.
struct Start {
    kind: PartKind,
    /// The position of the first annotation, or of the declaration.
    first: usize,
    /// The position of the declaration.
    own: usize,
    /// The position of the name.
    name: usize,
    /// The position of the body.
    body: usize,
}

fn starts(view: &View<'_>) -> Vec<Start> {
    let mut list = Vec::new();
    let (mut position, mut depth, mut annotated) = (0, 0_u32, None);
    if start_at(view, 0, true).is_none() && !view.is(0, Sym::At) {
        list.push(Start { kind: PartKind::Other, first: 0, own: 0, name: 0, body: 0 });
    }
    while let Some(token) = view.at(position) {
        if token.is(Sym::At) && view.ident(position + 1).is_some() {
            annotated.get_or_insert(position);
            depth = 0;
            position = view.after_group(position + 2);
            continue;
        }
        let start = start_at(view, position, depth == 0);
        if let Some(start) = start {
            depth = 0;
            position = start.body.max(position + 1);
            list.push(Start { first: annotated.take().unwrap_or(start.first), ..start });
            continue;
        }
        if let Some(first) = annotated.take() {
            list.push(Start { kind: PartKind::Other, first, own: position, name: position, body: position });
        }
        match token {
            Tok::Sym(Sym::LBrace | Sym::LParen | Sym::LBracket) => depth += 1,
            Tok::Sym(Sym::RBrace | Sym::RParen | Sym::RBracket) => depth = depth.saturating_sub(1),
            _ => {}
        }
        position += 1;
    }
    if let Some(first) = annotated {
        list.push(Start { kind: PartKind::Other, first, own: position, name: position, body: position });
    }
    list
}

/// The declaration that begins at a position. `name = …` is one outside of brackets only: inside it is an arm.
fn start_at(view: &View<'_>, position: usize, is_outside: bool) -> Option<Start> {
    let word = view.ident(position)?;
    let next_is_name = view.ident(position + 1).is_some();
    let start = |kind, name: usize, body| Start { kind, first: position, own: position, name, body };
    match word {
        "attr" if next_is_name => return Some(start(PartKind::Attr, position + 1, after_head(view, position + 1))),
        "const" if next_is_name => return Some(start(PartKind::Const, position + 1, after_head(view, position + 1))),
        "style" | "import" if next_is_name && !view.is(position + 1, Sym::Arrow) => {
            return Some(start(PartKind::Other, position, position + 2));
        }
        _ => {}
    }
    let role = matches!(word, "start" | "extension") && next_is_name;
    let name = if role { position + 1 } else { position };
    // `lib.Name --> …`.
    let last = if view.is(name + 1, Sym::Dot) && view.ident(name + 2).is_some() { name + 2 } else { name };
    let after = after_head(view, last);
    let is_rule = view.is(after, Sym::Arrow);
    if is_rule && last != name && !matches!(view.at(name + 1), Some(Tok::Joint)) {
        // A leaf `foo.` before `Name -->`.
        return None;
    }
    let is_function = !role && is_outside && last == name && view.is(after, Sym::Assign);
    match (is_rule, is_function) {
        (true, _) => Some(start(PartKind::Rule, if last == name { name } else { after }, after + 1)),
        (_, true) => Some(start(PartKind::Function, name, after + 1)),
        _ => None,
    }
}

/// The position after a name, its parameters and its local values.
fn after_head(view: &View<'_>, name: usize) -> usize {
    let after = view.after_group(name + 1);
    if view.ident(after) == Some("with") { view.after_group(after + 1) } else { after }
}

fn part(view: &View<'_>, start: &Start, end: usize) -> Part {
    let index = |position: usize| view.list.get(position).copied().unwrap_or(view.tokens.len() as u32);
    let (mut params, mut locals) = (Vec::new(), Vec::new());
    if start.kind != PartKind::Other {
        let group = view.after_group(start.name + 1);
        let names = start.name + 2..group.max(start.name + 2);
        params = names.filter(|at| view.ident(*at).is_some()).map(index).collect();
        if view.ident(group) == Some("with") {
            let assigned =
                |at: &usize| view.ident(*at).is_some() && view.is(at + 1, Sym::Colon) && view.is(at + 2, Sym::Assign);
            locals = (group..view.after_group(group + 1)).filter(assigned).map(index).collect();
        }
    }
    let name = view.ident(start.name).filter(|_| start.kind != PartKind::Other).map(|_| index(start.name));
    let (first, last) = (index(start.first), index(start.own));
    // Doc comments are before the annotations or between them.
    let before = match start.first.checked_sub(1) {
        Some(before) => index(before) + 1,
        None => 0,
    };
    let docs = view.tokens[before as usize..last.max(first) as usize].iter();
    let docs = docs.filter_map(|token| if let Tok::Doc(text) = token { Some(text.clone()) } else { None });
    let mut words: Vec<Word> = (start.first..start.own)
        .filter(|at| view.is(*at, Sym::At) && view.ident(at + 1).is_some())
        .map(|at| Word {
            token: index(at + 1),
            fields: Vec::new(),
            context: Context::Annotation,
            is_call: true,
            is_leaf: false,
        })
        .collect();
    let mut add = |position: usize, context: Context| {
        let mut last = position;
        let mut fields = Vec::new();
        while context != Context::Operation && view.is(last + 1, Sym::Dot) && view.ident(last + 2).is_some() {
            last += 2;
            fields.push(index(last));
        }
        let is_call = view.is(last + 1, Sym::LParen);
        let is_leaf = context == Context::Operation && view.is(last + 1, Sym::Dot);
        words.push(Word { token: index(position), fields, context, is_call, is_leaf });
    };
    if start.kind != PartKind::Other {
        // The values of locals.
        let group = view.after_group(start.name + 1);
        contexts(view, group + 1, start.body, false, &mut |position, context| {
            if !locals.contains(&index(position)) {
                add(position, context);
            }
        });
        contexts(view, start.body, end, start.kind == PartKind::Rule, &mut add);
    }
    Part { kind: start.kind, name, docs: docs.collect(), range: (last, index(end)), words, params, locals }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::lex::lex;

    /// The names of declarations with their parameters, then the words with their contexts.
    fn shown(text: &str) -> Vec<String> {
        let tokens = lex(text).tokens;
        let name = |token: &u32| tokens.as_slice()[*token as usize].ident().unwrap_or("?").to_owned();
        let names = |list: &[u32]| list.iter().map(name).collect::<Vec<_>>().join(" ");
        let part = |part: &Part| {
            let words: Vec<String> = part
                .words
                .iter()
                .map(|word| {
                    let about = match word.context {
                        Context::Operation => if word.is_leaf { "leaf" } else { "op" }.into(),
                        Context::Value => "value".into(),
                        Context::Selector => "selector".into(),
                        Context::Annotation => "annotation".into(),
                        Context::Argument { call, number } => format!("{}/{number}", name(&call)),
                    };
                    let dots: String = word.fields.iter().map(|field| format!(".{}", name(field))).collect();
                    format!("{}{dots}:{about}", name(&word.token))
                })
                .collect();
            let own = part.name.iter().map(name).collect::<String>();
            format!("{:?} {own}({}){} [{}]", part.kind, names(&part.params), names(&part.locals), words.join(" "))
        };
        outline(tokens.as_slice()).iter().map(part).collect()
    }

    #[test]
    fn contexts_follow_the_brackets() {
        assert_eq!(
            shown(
                "/// High.\n@Range(min = 1) attr h = rand(2, k) const k = 3 f(n) = case n > h : n else : k
                 Lot --> case h > 2 : A(h) else : extrude(world.up, h) comp(f) { side : B | top = C t(1, h, 0) }
                 A(w) with (d := w * 2) --> split(x, adjust) { d : B | { ~w : [ C ] B }* } set(h, 3) i(f(w)) B.
                 B --> splitArea(x) { w : C } offset(1, inside) set(material.color.r, scope.sx) C"
            ),
            [
                "Attr h() [Range:annotation rand:value k:rand/1]",
                "Const k() []",
                "Function f(n) [case:value n:value h:value n:value else:value k:value]",
                "Rule Lot() [case:op h:value A:op h:A/0 else:op extrude:op world.up:extrude/0 h:extrude/1 comp:op \
                 f:comp/0 side:selector B:op top:selector C:op t:op h:t/1]",
                "Rule A(w)d [w:value split:op x:split/0 adjust:split/1 d:value B:op w:value C:op B:op set:op \
                 h:set/0 i:op f:value w:f/0 B:leaf]",
                "Rule B() [splitArea:op x:splitArea/0 w:value C:op offset:op inside:offset/1 set:op \
                 material.color.r:set/0 scope.sx:set/1 C:op]",
            ]
        );
    }
}
