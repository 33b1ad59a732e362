//! Comparisons to the last bit.

use cga::sink::buffers::{Buffers, Submesh, Vertex};
use cga::{LeafView, Material, Text};

use crate::compare::Outcome;

/// A triangle with all that is known of it.
pub(crate) type Triangle = ([[u32; 26]; 3], Text, Material);

/// The first line in which two texts differ.
pub(crate) fn texts(what: &str, a: &str, b: &str) -> Option<String> {
    if a == b {
        return None;
    }
    let lines = a.lines().zip(b.lines()).find(|(a, b)| a != b);
    let (a, b) = lines.unwrap_or(("its end", "its end"));
    // Long lines: from shortly before the first difference on.
    let at = a.bytes().zip(b.bytes()).take_while(|(a, b)| a == b).count().saturating_sub(60);
    let near = |text: &str| text.chars().skip(at).take(200).collect::<String>();
    Some(format!("{what}: {:?} and {:?}", near(a), near(b)))
}

/// Compares all that two runs collect.
pub(crate) fn outcomes(a: &Outcome, b: &Outcome) -> Option<String> {
    texts("the report", &format!("{:?}", a.report), &format!("{:?}", b.report))
        .or_else(|| leaves(a.model.leaves(), b.model.leaves()))
        .or_else(|| texts("the OBJ", &a.model.to_obj("a").0, &b.model.to_obj("a").0))
}

/// Compares rules, materials, scopes and texture coordinates.
pub(crate) fn leaves<'a>(
    a: impl Iterator<Item = LeafView<'a>>,
    b: impl Iterator<Item = LeafView<'a>>,
) -> Option<String> {
    let (a, b): (Vec<_>, Vec<_>) = (a.collect(), b.collect());
    let differs = |(a, b): (&LeafView<'_>, &LeafView<'_>)| {
        let ((mesh, _), (other, _)) = (a.mesh(), b.mesh());
        (a.rule(), a.material(), a.scope()) != (b.rule(), b.material(), b.scope())
            || (0..10).any(|set| mesh.uv_set(set) != other.uv_set(set))
    };
    if let Some(at) = a.iter().zip(&b).position(differs) {
        let tell = |leaf: &LeafView<'_>| {
            let uvs = (0..10).map(|set| leaf.mesh().0.uv_set(set).to_vec()).collect::<Vec<_>>();
            format!("{} {:?} {:?} {uvs:?}", leaf.rule(), leaf.material(), leaf.scope())
        };
        return texts(&format!("leaf {at}"), &tell(&a[at]), &tell(&b[at]));
    }
    (a.len() != b.len()).then(|| format!("the number of leaves: {} and {}", a.len(), b.len()))
}

/// All of the buffers, as text that tells every bit.
pub(crate) fn buffers(a: &Buffers, b: &Buffers) -> Option<String> {
    let bits = |buffers: &Buffers| {
        let vertices = buffers.vertices().iter().map(|vertex| vertex.map(f32::to_bits)).collect::<Vec<_>>();
        let of_set = |set: usize| buffers.uv_set(set).iter().map(|uv| uv.map(f32::to_bits)).collect::<Vec<_>>();
        (vertices, (0..10).map(of_set).collect::<Vec<_>>())
    };
    let submeshes = |buffers: &Buffers| {
        let submeshes = buffers.submeshes().collect::<Vec<_>>();
        format!("{submeshes:?} {:?} {:?} {:?}", buffers.rules(), buffers.materials(), buffers.indices())
    };
    texts("the submeshes of buffers", &submeshes(a), &submeshes(b))
        .or_else(|| (bits(a) != bits(b)).then(|| "the vertices of buffers".to_owned()))
}

/// The triangles of buffers, in order.
pub(crate) fn triangles(buffers: &Buffers) -> Vec<Triangle> {
    let corner = |index: u32| {
        let [x, y, z, u, v, w]: Vertex = buffers.vertices()[index as usize];
        let mut all = [0.0; 26];
        all[..6].copy_from_slice(&[x, y, z, u, v, w]);
        for (set, place) in all[6..].chunks_exact_mut(2).enumerate() {
            place.copy_from_slice(&buffers.uv_set(set).get(index as usize).copied().unwrap_or_default());
        }
        all.map(f32::to_bits)
    };
    let of = |submesh: Submesh| {
        let (rule, material) =
            (&buffers.rules()[submesh.rule as usize], &buffers.materials()[submesh.material as usize]);
        let (triangles, _) = buffers.indices()[submesh.indices].as_chunks::<3>();
        triangles.iter().map(move |t| (t.map(corner), rule.clone(), Material::clone(material))).collect::<Vec<_>>()
    };
    buffers.submeshes().flat_map(of).collect()
}
