//! The attributes at the edges of the initial shape, for functions and operations that sample them.

use std::sync::Arc;

use super::Env;
use crate::fault::FaultKind;
use crate::shape::edge_attributes::SampledAttributes;

impl Env {
    /// The attributes of the edges of the initial shape, if it has some. A fault, once a run, if it has no outline.
    pub(crate) fn edge_attributes(&mut self) -> Option<Arc<SampledAttributes>> {
        if let Some(known) = &self.kept.edge_attributes {
            return known.clone();
        }
        let found = match self.initial.shape.as_ref().map(crate::shape::Shape::find_edge_attributes) {
            Some(Ok(found)) => found,
            Some(Err(())) => {
                let message =
                    "the initial shape has no outline, or one with more than 5000 edges: edge attributes have no value";
                self.fault_once(FaultKind::Geometry, message);
                None
            }
            None => None,
        };
        self.kept.edge_attributes = Some(found.clone());
        found
    }
}
