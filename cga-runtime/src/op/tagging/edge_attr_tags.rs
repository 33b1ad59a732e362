//! `setTagsFromEdgeAttrs`: tags of edges from attributes of the initial shape's edges.

use std::sync::Arc;

use cga_split::tags::matches;
use glam::DVec3;

use crate::geometry::each::Each;
use crate::geometry::mesh::{Mesh, SubcomponentTagsBuilder, TagSet, TaggedComponents};
use crate::geometry::wire::Wire;
use crate::op::tagging::tag::tag_name;
use crate::run::env::Env;
use crate::shape::edge_attributes::SampledAttributes;
use crate::shape::{EdgeAttribute, Geometry, Inserted, Placed, PlacedWire, Shape};
use crate::value::text::Text;

/// `setTagsFromEdgeAttrs()`: each edge of each face gets the tag `edgeattr.NAME.VALUE` for each text attribute of the initial
/// shape's edges, with the value that `edgeAttr.getString` would give for the edge of the face (*setTagsFromEdgeAttrs operation*).
/// The edge of two faces gets the values of both. Tags of an earlier call are replaced. Empty values give no tag, and the wildcards
/// of queries are left out.
pub fn set_tags_from_edge_attrs(env: &mut Env, shape: &mut Shape) {
    let Some(known) = env.edge_attributes() else { return };
    let texts = |(name, values): (&Text, &EdgeAttribute)| match values {
        EdgeAttribute::Texts(values) => Some((name.clone(), values.clone())),
        _ => None,
    };
    let attributes: Vec<(Text, Arc<[Text]>)> = known.attributes.iter().filter_map(texts).collect();
    if attributes.is_empty() || !(shape.geometry.has_surface() || shape.to_wire().is_some()) {
        return;
    }
    let sampled = Sampled { known: &known, attributes: &attributes, shape };
    let tagger = match shape.to_wire() {
        Some(wire) => sampled.wire(&wire),
        None => {
            let mesh = shape.to_mesh();
            if env.count_vertices(&mesh).is_break() {
                return;
            }
            sampled.mesh(&mesh)
        }
    };
    shape.hold_as_points();
    match &shape.geometry {
        Geometry::Mesh(placed) => {
            let tags = cleared(placed.mesh.subcomponent_tags(), &attributes, tagger);
            let mesh = Mesh::clone(&placed.mesh).with_subcomponent_tags(tags);
            let placed = Placed { mesh: Arc::new(mesh), inserted: Inserted::No, ..Placed::clone(placed) };
            shape.geometry = Geometry::Mesh(Arc::new(placed));
        }
        Geometry::Wire(placed) => {
            let tags = cleared(&placed.wire.tags, &attributes, tagger).finish();
            let wire = Wire { tags, ..placed.wire.clone() };
            shape.geometry = Geometry::Wire(Arc::new(PlacedWire { wire, ..PlacedWire::clone(placed) }));
        }
        _ => {}
    }
}

/// New tags of edges, and the old tags without the tags of the same attributes.
fn cleared(
    old: &crate::geometry::mesh::SubcomponentTags,
    attributes: &[(Text, Arc<[Text]>)],
    mut tagger: SubcomponentTagsBuilder,
) -> SubcomponentTagsBuilder {
    let mut old = old.clone();
    for (name, _) in attributes {
        let attribute = format!("edgeattr.{}", tag_name(name));
        old = old.without(&|tag| matches(&attribute, tag), TaggedComponents::Edges);
    }
    tagger.append(&old, &|point| point);
    tagger
}

/// The tags that edges of a shape sample.
struct Sampled<'s> {
    known: &'s SampledAttributes,
    attributes: &'s [(Text, Arc<[Text]>)],
    shape: &'s Shape,
}

impl Sampled<'_> {
    /// The tags of an edge that faces in a direction, in scope coordinates.
    fn tags(&self, ends: [DVec3; 2], facing: DVec3) -> TagSet {
        let frame = self.shape.scope.frame();
        let ends = ends.each(|end| frame.to_world(end));
        let Some(edge) = self.known.edge(ends.into_iter(), frame.axes * facing) else { return TagSet::default() };
        let tag = |(name, values): &(Text, Arc<[Text]>)| {
            let value = values.get(edge).map(tag_name).filter(|value| !value.is_empty())?;
            Some(format!("edgeattr.{}.{value}", tag_name(name)))
        };
        TagSet::new(self.attributes.iter().filter_map(tag))
    }

    fn mesh(&self, mesh: &Mesh) -> SubcomponentTagsBuilder {
        let mut tagger = SubcomponentTagsBuilder::default();
        for face in mesh.faces() {
            let normal = face.normal();
            for edge in face.edges() {
                let [a, b] = edge.each(|corner| face.position(corner));
                // Out of the face, as the z axis of `comp(fe)`.
                let tags = self.tags([a, b], (b - a).cross(normal));
                tagger.edge(edge.each(|corner| mesh.corners()[corner]), &tags);
            }
        }
        tagger
    }

    fn wire(&self, wire: &Wire) -> SubcomponentTagsBuilder {
        let mut tagger = SubcomponentTagsBuilder::default();
        for (edge, normal) in wire.normals.iter().enumerate().take(wire.edges.len()) {
            tagger.edge(wire.edges[edge], &self.tags(wire.ends(edge), *normal));
        }
        tagger
    }
}
