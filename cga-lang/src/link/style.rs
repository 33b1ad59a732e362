//! Styles of a file.

use crate::diag::Diags;
use crate::diag::code::Code;
use crate::suggest::nearest;
use crate::syntax::ast::{Ast, DEFAULT};
use std::collections::HashMap;

/// The style in force and its base styles.
pub(crate) struct Styles {
    /// The number of the style in force, as in [`Decl::style`](crate::syntax::ast::Decl::style).
    in_force: u32,
    /// The distance of each style from the one in force, by number; 0 is the nearest. `None` for a style that is not
    /// a base. `Default` is the farthest.
    ranks: Vec<Option<usize>>,
    /// The name of the style in force; `None` for `Default`.
    pub(crate) name: Option<String>,
}

impl Styles {
    /// Follows the base styles from `style` to `Default`. Reports bases that do not exist or form a cycle.
    pub(crate) fn new(ast: &Ast, style: u32, diags: &mut Diags) -> Self {
        let mut ranks = vec![None; ast.styles.len() + 1];
        let first = style.checked_sub(1).and_then(|index| ast.styles.get(index as usize));
        // The first style with a name counts.
        let numbers: HashMap<&str, usize> =
            ast.styles.iter().enumerate().rev().map(|(index, own)| (own.name.text.as_str(), index + 1)).collect();
        let (mut at, mut rank) = (style as usize, 0);
        while let Some(own) = at.checked_sub(1).and_then(|index| ast.styles.get(index)) {
            ranks[at] = Some(rank);
            rank += 1;
            let Some(base) = &own.base else { break };
            match numbers.get(base.text.as_str()) {
                Some(&next) if ranks[next].is_some() => {
                    // The cycle is reported at its first style, whichever style is in force, because it is one
                    // mistake.
                    let ring = |(index, rank): (usize, &Option<usize>)| {
                        rank.filter(|own| ranks[next] <= Some(*own)).map(|_| index)
                    };
                    let first = ranks.iter().enumerate().find_map(ring).unwrap_or(at);
                    if let Some((own, Some(base))) = ast.styles.get(first - 1).map(|own| (own, &own.base)) {
                        let message = format!("style `{}` extends itself", own.name.text);
                        diags.report(Code::UnknownStyle, base.span, message);
                    }
                    break;
                }
                Some(&next) => at = next,
                None => {
                    let names = ast.styles.iter().map(|style| style.name.text.as_str()).chain([DEFAULT]);
                    let near = nearest(&base.text, names).map(str::to_owned);
                    let message = format!("there is no style `{}`", base.text);
                    diags.report(Code::UnknownStyle, base.span, message).suggest(near);
                    break;
                }
            }
        }
        ranks[0] = Some(rank);
        let in_force = if first.is_some() { style } else { 0 };
        Styles { in_force, ranks, name: first.map(|style| style.name.text.clone()) }
    }

    /// The number of the style in force.
    pub(crate) fn in_force(&self) -> u32 {
        self.in_force
    }

    /// The distance of a style from the one in force, 0 being the nearest. `None` for a style that is not a base.
    pub(crate) fn rank(&self, style: u32) -> Option<usize> {
        self.ranks.get(style as usize).copied().flatten()
    }
}
