//! The tree of shapes of a run, as data: rules, parents, keys and scopes, for inspectors, picking and debugging.

pub(crate) mod builder;

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

use crate::shape::scope::Scope;
use crate::value::Value;
use crate::value::text::Text;

/// The tree of shapes of one initial shape (CityEngine's model hierarchy): each call of a rule is a node, and each leaf. Parents come
/// before their children. [`Settings::tree`](crate::run::settings::Settings::tree) asks for it,
/// [`Building::tree`](crate::run::building::Building::tree) has it.
///
/// Blocks, as the parts of a split with several operations, belong to the rule that contains them. `NIL` makes no node. Shapes that an
/// operand derives, as of `union` or `inline`, are not in the tree: the operation takes their leaves.
///
/// Trees are equal if their shapes are equal. Arguments are not compared, as compiled rules do not keep them.
///
/// It is displayed with a line for each shape, indented below its parent:
///
/// ```
/// # use cga_runtime::facade as cga;
/// # use cga::Model;
/// # let model = Model::new();
/// for (building, leaves) in model.buildings() {
///     let Some(tree) = &building.tree else { continue };
///     println!("{}\n{tree}", building.name);
///     // The leaves of the model below a shape, here below the first child of the initial shape.
///     let below = tree.find("0;0;").into_iter().flat_map(|shape| shape.subtree()).filter_map(|shape| shape.leaf());
///     let below: Vec<_> = below.filter_map(|leaf| model.leaves().nth(leaves.start + leaf)).collect();
/// }
/// ```
#[derive(Clone, Default)]
pub struct ShapeTree {
    /// The shapes in the order of derivation.
    shapes: Vec<TreeShape>,
    /// The children of each shape, in order.
    children: Vec<u32>,
    /// The shape of each leaf.
    leaves: Vec<u32>,
    /// The arguments of shapes whose rules have some, by their indices.
    arguments: BTreeMap<u32, Box<[Value]>>,
}

/// A shape of a tree.
#[derive(Clone, Debug, PartialEq)]
struct TreeShape {
    rule: Text,
    scope: Scope,
    parent: Option<u32>,
    /// The number among the children of the parent.
    number: u32,
    leaf: Option<u32>,
    /// The range of its children in the list of the tree.
    children: Range<u32>,
}

impl ShapeTree {
    /// The number of shapes.
    pub fn len(&self) -> usize {
        self.shapes.len()
    }

    /// Returns true if the tree is empty.
    pub fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    /// The initial shape; `None` for an empty tree.
    pub fn root(&self) -> Option<ShapeNode<'_>> {
        self.node(0)
    }

    /// The shape with an index, in the order of derivation.
    pub fn node(&self, index: usize) -> Option<ShapeNode<'_>> {
        self.shapes.get(index).map(|shape| ShapeNode { tree: self, shape, index })
    }

    /// All shapes in the order of derivation: parents before their children, leaves in the order of the model.
    pub fn nodes(&self) -> impl ExactSizeIterator<Item = ShapeNode<'_>> + Clone {
        self.shapes.iter().enumerate().map(|(index, shape)| ShapeNode { tree: self, shape, index })
    }

    /// The shape of a leaf, by the index of the leaf among the leaves of the building.
    pub fn of_leaf(&self, leaf: usize) -> Option<ShapeNode<'_>> {
        self.node(*self.leaves.get(leaf)? as usize)
    }

    /// The number of leaves.
    pub fn leaf_count(&self) -> usize {
        self.leaves.len()
    }

    /// The shape with a key; see [`ShapeNode::key`].
    pub fn find(&self, key: &str) -> Option<ShapeNode<'_>> {
        let mut numbers = key.strip_suffix(';')?.split(';');
        let root = self.root().filter(|_| numbers.next() == Some("0"))?;
        numbers.try_fold(root, |shape, number| {
            let is_written =
                number == "0" || number.bytes().all(|byte| byte.is_ascii_digit()) && !number.starts_with('0');
            shape.children().nth(number.parse().ok().filter(|_| is_written)?)
        })
    }
}

impl PartialEq for ShapeTree {
    fn eq(&self, other: &Self) -> bool {
        (&self.shapes, &self.children, &self.leaves) == (&other.shapes, &other.children, &other.leaves)
    }
}

impl fmt::Debug for ShapeTree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ShapeTree").field("shapes", &self.len()).field("leaves", &self.leaf_count()).finish()
    }
}

impl fmt::Display for ShapeTree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        /// The depth from which lines are not indented further.
        const DEEPEST: usize = 60;
        let mut depths = vec![0; self.len()];
        for node in self.root().into_iter().flat_map(|root| root.subtree()) {
            let depth = node.shape.parent.map_or(0, |parent| depths[parent as usize] + 1);
            depths[node.index] = depth;
            let (size, end) = (node.scope().size, if node.leaf().is_some() { "." } else { "" });
            let indent = 2 * depth.min(DEEPEST);
            writeln!(f, "{:indent$}{}{end} {} x {} x {}", "", node.rule(), size.x, size.y, size.z)?;
        }
        Ok(())
    }
}

/// A shape in a [`ShapeTree`].
#[derive(Clone, Copy)]
pub struct ShapeNode<'a> {
    tree: &'a ShapeTree,
    shape: &'a TreeShape,
    index: usize,
}

impl fmt::Debug for ShapeNode<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut fields = f.debug_struct("ShapeNode");
        fields.field("index", &self.index).field("rule", &self.rule()).field("scope", self.scope());
        fields.field("children", &self.children().len()).field("leaf", &self.leaf()).finish()
    }
}

impl<'a> ShapeNode<'a> {
    /// The index in the order of derivation.
    pub fn index(&self) -> usize {
        self.index
    }

    /// The name of the rule or leaf symbol, without the dot.
    pub fn rule(&self) -> &'a str {
        &self.shape.rule
    }

    /// The scope, in the world: the scope of the leaf, or the scope with which the rule begins.
    pub fn scope(&self) -> &'a Scope {
        &self.shape.scope
    }

    /// The arguments with which the rule was called. Rules that were loaded at run time keep them (`RuleFile`); for compiled rules, and for
    /// leaf symbols, the list is empty.
    pub fn arguments(&self) -> &'a [Value] {
        self.tree.arguments.get(&(self.index as u32)).map_or(&[], |list| list)
    }

    /// The parent; `None` for the initial shape.
    pub fn parent(&self) -> Option<ShapeNode<'a>> {
        self.tree.node(self.shape.parent? as usize)
    }

    /// The number among the children of the parent, from 0, in the order in which the rule makes them.
    pub fn number(&self) -> usize {
        self.shape.number as usize
    }

    /// The children, in the order in which the rule makes them.
    pub fn children(&self) -> impl ExactSizeIterator<Item = ShapeNode<'a>> + Clone + use<'a> {
        let tree = self.tree;
        self.child_indices().iter().map(move |&index| {
            let index = index as usize;
            ShapeNode { tree, shape: &tree.shapes[index], index }
        })
    }

    fn child_indices(&self) -> &'a [u32] {
        &self.tree.children[self.shape.children.start as usize..self.shape.children.end as usize]
    }

    /// The shape and all shapes below it, depth first: each one before its children, and children in order.
    pub fn subtree(&self) -> impl Iterator<Item = ShapeNode<'a>> + use<'a> {
        let (tree, mut open) = (self.tree, vec![self.index as u32]);
        std::iter::from_fn(move || {
            let node = tree.node(open.pop()? as usize)?;
            open.extend(node.child_indices().iter().rev());
            Some(node)
        })
    }

    /// The index of its leaf among the leaves of the building; `None` if it is not a leaf. In a model with several buildings,
    /// [`Model::buildings`](crate::output::model::Model::buildings) tells where the leaves of each begin.
    pub fn leaf(&self) -> Option<usize> {
        self.shape.leaf.map(|leaf| leaf as usize)
    }

    /// The key (*getTreeKey function*): the numbers of children from the initial shape on, each followed by `;`. The key of the initial
    /// shape is `0;`, the key of the third child of its first child `0;0;2;`. It takes time in proportion to the depth.
    ///
    /// A key is unique in the tree of one building. It may change with the seed: where chance or attributes decide how many children a rule
    /// makes, a shape gets another key. Rules read it with `getTreeKey`; the two differ only where rules nest so deeply that a block of
    /// several successors waits.
    pub fn key(&self) -> String {
        let mut numbers = vec![self.number()];
        let mut shape = *self;
        while let Some(parent) = shape.parent() {
            numbers.push(parent.number());
            shape = parent;
        }
        numbers.iter().rev().map(|number| format!("{number};")).collect()
    }
}
