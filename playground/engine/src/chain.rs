//! The chain of rules from a lot to a leaf.

use std::sync::Arc;
use std::time::Duration;

use cga::{Scene, Settings, ShapeTree, Watch};
use serde_json::{Value, json};

use crate::engine::{Clock, Run};
use crate::limits::SECONDS;
use crate::rule_lines::{NameLines, rule_lines};

/// The tree of shapes of an initial shape, kept for the next leaf.
#[derive(Debug, Default)]
pub struct Trees {
    last: Option<(usize, Arc<ShapeTree>)>,
}

impl Trees {
    /// The rules that led to a leaf of a run, as JSON: the first is the rule of the lot. Each has the name, the arguments, the lines of the
    /// rule, and the scope with which the rule begins: origin, axes and size in metres. The attributes are the values that the lot used.
    ///
    /// # Errors
    /// A sentence for the person at the page.
    pub fn chain(&mut self, run: &Run, leaf: usize, clock: Clock) -> Result<String, String> {
        let lot = run.starts.partition_point(|&start| start <= leaf).checked_sub(1).ok_or("there is no such part")?;
        let tree = self.tree(run, lot, clock)?;
        let node = tree.of_leaf(leaf - run.starts[lot]).ok_or("there is no such part")?;
        let mut nodes: Vec<_> = std::iter::successors(Some(node), |node| node.parent()).collect();
        nodes.reverse();
        let lines = rule_lines(&run.text);
        let step = |node: &cga::ShapeNode<'_>| {
            let scope = node.scope();
            json!({
                "rule": node.rule(),
                "arguments": serde_json::to_value(node.arguments()).unwrap_or_default(),
                "lines": lines.get(node.rule()).map_or(&[][..], NameLines::shown),
                "number": node.number(),
                "siblings": node.parent().map_or(1, |parent| parent.children().len()),
                "isLeaf": node.leaf().is_some(),
                "origin": scope.origin.to_array(),
                "axes": scope.axes.to_cols_array(),
                "size": scope.size.to_array(),
            })
        };
        let attributes = run.model.buildings().nth(lot).map(|(building, _)| &building.attributes);
        let attributes: serde_json::Map<String, Value> = attributes
            .into_iter()
            .flatten()
            .map(|(name, value)| (name.to_string(), serde_json::to_value(value).unwrap_or_default()))
            .collect();
        Ok(json!({ "lot": lot, "attributes": attributes, "steps": nodes.iter().map(step).collect::<Vec<_>>() })
            .to_string())
    }

    /// The tree of an initial shape.
    fn tree(&mut self, run: &Run, lot: usize, clock: Clock) -> Result<Arc<ShapeTree>, String> {
        if let Some((_, tree)) = self.last.as_ref().filter(|(number, _)| *number == lot) {
            return Ok(tree.clone());
        }
        let watch = Some(Watch::deadline_by(Duration::from_secs(SECONDS), clock));
        let settings = Settings { tree: true, watch, ..run.settings.clone() };
        let model = Scene::new(&run.grammar, &run.lots).generate_lot(lot, &settings);
        let model = model.map_err(|error| error.error.to_string())?;
        let tree = model.buildings().next().and_then(|(building, _)| building.tree.clone());
        let tree = tree.ok_or("the rules of this part take too long to follow")?;
        self.last = Some((lot, tree.clone()));
        Ok(tree)
    }
}
