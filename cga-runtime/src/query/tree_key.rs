//! The place of a shape in the tree of shapes (*getTreeKey function*).

use crate::run::env::Env;
use crate::value::text::Text;

/// `getTreeKey()`: the numbers of children from the initial shape on, each followed by `;`. The key of the initial shape is `0;`.
///
/// Each call of a rule and each leaf symbol has a number among the children of its rule, in order. A part of a split without a rule of its
/// own has the key of the rule around it, as do expressions in conditions, sizes and selectors. `NIL`, labelled copies and occluders take no
/// numbers. Shapes below an operation with operands, as `inline`, have keys below the current shape; the next child has the same number
/// again. Where rules nest so deeply that a block waits, its children but the first have the next free numbers of the rule.
pub fn get_tree_key(env: &Env) -> Text {
    let numbers = env.tree_key().into_iter().map(|number| format!("{number};"));
    Text::from(numbers.collect::<String>())
}
