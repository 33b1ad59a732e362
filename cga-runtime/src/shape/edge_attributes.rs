//! Values at the edges of the initial shape (*edgeAttr functions*).

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::Shape;
use super::sampled_outline::SampledOutline;
use crate::value::text::Text;

/// The values of an attribute at the edges of an initial shape, one for each edge of each face.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EdgeAttribute {
    /// Numbers.
    Floats(Arc<[f64]>),
    /// Truth values.
    Bools(Arc<[bool]>),
    /// Texts.
    Texts(Arc<[Text]>),
}

impl<const N: usize> From<[f64; N]> for EdgeAttribute {
    fn from(values: [f64; N]) -> Self {
        EdgeAttribute::Floats(values.into())
    }
}

impl From<Vec<f64>> for EdgeAttribute {
    fn from(values: Vec<f64>) -> Self {
        EdgeAttribute::Floats(values.into())
    }
}

impl<const N: usize> From<[bool; N]> for EdgeAttribute {
    fn from(values: [bool; N]) -> Self {
        EdgeAttribute::Bools(values.into())
    }
}

impl From<Vec<bool>> for EdgeAttribute {
    fn from(values: Vec<bool>) -> Self {
        EdgeAttribute::Bools(values.into())
    }
}

impl<const N: usize> From<[&str; N]> for EdgeAttribute {
    fn from(values: [&str; N]) -> Self {
        EdgeAttribute::Texts(values.into_iter().map(Text::from).collect())
    }
}

impl From<Vec<String>> for EdgeAttribute {
    fn from(values: Vec<String>) -> Self {
        EdgeAttribute::Texts(values.into_iter().map(Text::from).collect())
    }
}

/// All attributes, by name.
pub(crate) type EdgeAttributes = Arc<BTreeMap<Text, EdgeAttribute>>;

/// The attributes of an initial shape, and its outline, on which parts sample them.
#[derive(Debug)]
pub(crate) struct SampledAttributes {
    pub(crate) attributes: EdgeAttributes,
    outline: SampledOutline,
}

impl SampledAttributes {
    /// The number of the edge that a part samples: its points and the direction in which it faces, in the world.
    pub(crate) fn edge(&self, points: impl Iterator<Item = DVec3>, facing: DVec3) -> Option<usize> {
        self.outline.edge(points, facing)
    }

    /// The number of the edge that a shape samples: it faces in the mean direction of its faces or edges.
    pub(crate) fn edge_of(&self, shape: &Shape) -> Option<usize> {
        let frame = shape.scope.frame();
        let (points, facing) = match shape.to_wire() {
            Some(wire) => {
                let lengths = (0..wire.edges.len()).map(|edge| {
                    let [a, b] = wire.ends(edge);
                    a.distance(b)
                });
                let weights: Vec<f64> =
                    if wire.edges.is_empty() { vec![1.0; wire.normals.len()] } else { lengths.collect() };
                let facing = wire.normals.iter().zip(weights).map(|(normal, weight)| *normal * weight).sum();
                (wire.points, facing)
            }
            None => {
                let mesh = shape.to_mesh();
                (mesh.points().to_vec(), mesh.faces().map(|face| face.area_vector()).sum::<DVec3>())
            }
        };
        self.outline.edge(points.into_iter().map(|point| frame.to_world(point)), frame.axes * facing)
    }
}

impl Shape {
    /// The outline with the attributes at its edges, if it has attributes. `Err` for an outline with too many edges, or none.
    pub(crate) fn find_edge_attributes(&self) -> Result<Option<Arc<SampledAttributes>>, ()> {
        let Some(attributes) = self.state.get().map(|state| &state.edge_attributes).filter(|list| !list.is_empty())
        else {
            return Ok(None);
        };
        let frame = self.scope.frame();
        let outline = SampledOutline::of(&self.to_mesh(), |point| frame.to_world(point)).ok_or(())?;
        Ok(Some(Arc::new(SampledAttributes { attributes: attributes.clone(), outline })))
    }
}
