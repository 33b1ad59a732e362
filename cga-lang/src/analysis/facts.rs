//! The abstract state at one point of a rule.

use super::shape::Shape;
use super::uvs::UvSets;
use super::value::Value;
use crate::ir::GlobalId;
use crate::link::InstanceId;
use crate::resolve::globals::Declared;

/// The abstract state at one point of a rule.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct AbstractState {
    /// The instance whose entries the names have.
    pub(crate) own: InstanceId,
    pub(crate) shape: Shape,
    /// Parameters, then locals.
    pub(crate) params: Vec<Value>,
    /// Attributes and constants refined by conditions, each once, in order.
    pub(super) globals: Vec<(GlobalId, Value)>,
    pub(crate) uvs: UvSets,
    /// The inserted asset, while the shape is that asset or parts of it: the token of the file's name.
    pub(crate) asset: Option<u32>,
}

impl AbstractState {
    /// The state without any knowledge.
    pub(crate) fn any(own: InstanceId, params: usize) -> AbstractState {
        AbstractState {
            own,
            shape: Shape::ANY,
            params: vec![Value::Any; params],
            globals: Vec::new(),
            uvs: UvSets::ANY,
            asset: None,
        }
    }

    /// The state at the start of a run.
    pub(super) fn initial(item: &Declared) -> AbstractState {
        AbstractState { shape: Shape::INITIAL, ..AbstractState::any(item.own, item.decl.params.len()) }
    }

    /// The state at the start of a run on a shape without height.
    pub(super) fn lot(item: &Declared) -> AbstractState {
        AbstractState { shape: Shape::LOT, ..AbstractState::initial(item) }
    }

    /// The same values on another shape.
    pub(super) fn on(&self, shape: Shape) -> AbstractState {
        AbstractState { shape, ..self.clone() }
    }

    /// The same values on an unknown shape.
    pub(crate) fn on_any_shape(&self) -> AbstractState {
        self.on(Shape::ANY)
    }

    /// The same shape in another declaration, with its parameters.
    pub(super) fn with(&self, own: InstanceId, params: Vec<Value>) -> AbstractState {
        AbstractState { own, params, ..self.clone() }
    }

    /// The refined value of an attribute or a constant.
    pub(super) fn global(&self, which: GlobalId) -> Option<Value> {
        let at = self.globals.binary_search_by_key(&which, |(global, _)| *global).ok()?;
        Some(self.globals[at].1)
    }

    /// Sets the refined value of an attribute or a constant.
    pub(super) fn set_global(&mut self, which: GlobalId, value: Value) {
        match self.globals.binary_search_by_key(&which, |(global, _)| *global) {
            Ok(at) => self.globals[at].1 = value,
            Err(at) => self.globals.insert(at, (which, value)),
        }
    }

    /// The join of two states.
    pub(super) fn or(&self, other: &AbstractState) -> AbstractState {
        self.joined(other, self.shape.or(&other.shape), Value::or)
    }

    /// Widens the parts that have changed since `before`.
    pub(super) fn widen(&self, before: &AbstractState) -> AbstractState {
        self.joined(before, self.shape.widen(&before.shape), Value::widen)
    }

    fn joined(&self, other: &AbstractState, shape: Shape, join: fn(Value, Value) -> Value) -> AbstractState {
        let params = self.params.iter().zip(&other.params).map(|(a, b)| join(*a, *b)).collect();
        let both = |(which, value): &(GlobalId, Value)| Some((*which, join(*value, other.global(*which)?)));
        let globals = self.globals.iter().filter_map(both).collect();
        let asset = self.asset.filter(|_| self.asset == other.asset);
        AbstractState { own: self.own, shape, params, globals, uvs: self.uvs.or(other.uvs), asset }
    }
}
