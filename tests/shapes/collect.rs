//! A sink that keeps points and texture coordinates.

use std::sync::Arc;

use cga::glam::{DAffine3, DVec2, DVec3};
use cga::{Error, Flow, Leaf, Mesh, Repeats, Report, Settings, Shape, Sink};

/// A corner of a face of a leaf: where it is, and its coordinates in each set, if it has any.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Corner {
    pub(crate) point: DVec3,
    pub(crate) uvs: [Option<DVec2>; 10],
}

/// The leaves: their rules and the corners of their faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Leaves(pub(crate) Vec<(String, Vec<Vec<Corner>>)>);

impl Sink for Leaves {
    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let corner = |corner: usize| Corner {
            point: placement.transform_point3(mesh.points()[mesh.corners()[corner] as usize]),
            uvs: std::array::from_fn(|set| mesh.uv_set(set).get(corner).copied()),
        };
        let faces = mesh.faces().map(|face| face.corner_range().map(corner).collect()).collect();
        self.0.push((leaf.rule.to_string(), faces));
        Flow::Continue(())
    }
}

impl Leaves {
    /// The corners of all leaves of a rule.
    pub(crate) fn corners(&self, rule: &str) -> Vec<Corner> {
        let of_rule = self.0.iter().filter(|(name, _)| name == rule);
        of_rule.flat_map(|(_, faces)| faces.iter().flatten().cloned()).collect()
    }

    /// The least and the largest coordinates of a set in the leaves of a rule.
    pub(crate) fn range(&self, rule: &str, set: usize) -> [DVec2; 2] {
        let corners = self.corners(rule);
        assert!(!corners.is_empty(), "no leaf `{rule}`");
        let uvs = corners.iter().map(|corner| corner.uvs[set].expect("coordinates"));
        uvs.fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], uv| [low.min(uv), high.max(uv)])
    }
}

/// Runs a grammar from a shape into a sink.
pub(crate) trait Run: Fn(&Shape, &Settings, &mut Leaves) -> Result<Report, Error> {}

impl<F: Fn(&Shape, &Settings, &mut Leaves) -> Result<Report, Error>> Run for F {}

fn once(run: &impl Run, shape: &Shape, repeats: Repeats) -> Leaves {
    let (settings, mut leaves) = (Settings { repeats, ..Settings::default() }, Leaves::default());
    let report = run(shape, &settings, &mut leaves).expect("no error");
    assert!(report.faults().is_empty(), "{:?}", report.faults());
    leaves
}

/// Runs a grammar in all ways, which must agree: boxes and rectangles as such and as meshes, with templates and without.
pub(crate) fn generate(run: impl Run, shape: &Shape) -> Leaves {
    let leaves = once(&run, shape, Repeats::Kept);
    assert_eq!(leaves, once(&run, shape, Repeats::Again), "templates that are kept and templates that are not");
    close(&leaves, &once(&run, shape, Repeats::Direct), "templates and direct derivation");
    close(&leaves, &once(&run, &shape.clone().held_as_meshes(), Repeats::Kept), "boxes and meshes");
    leaves
}

/// Runs a grammar on a shape in all ways.
macro_rules! leaves {
    ($grammar:expr, $shape:expr) => {{
        let grammar = $grammar;
        $crate::collect::generate(|shape, settings, sink| grammar.run(shape, settings, sink), $shape)
    }};
}

pub(crate) use leaves;

fn close(a: &Leaves, b: &Leaves, what: &str) {
    let names = |leaves: &Leaves| leaves.0.iter().map(|(rule, faces)| (rule.clone(), faces.len())).collect::<Vec<_>>();
    assert_eq!(names(a), names(b), "{what}");
    for ((rule, a), (_, b)) in a.0.iter().zip(&b.0) {
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            let points = a.point.abs_diff_eq(b.point, 1e-9);
            let same = a.uvs.iter().zip(&b.uvs).all(|(a, b)| match (a, b) {
                (Some(a), Some(b)) => a.abs_diff_eq(*b, 1e-9),
                (a, b) => a.is_none() && b.is_none(),
            });
            assert!(points && same, "{what}: {rule}: {a:?} and {b:?}");
        }
    }
}
