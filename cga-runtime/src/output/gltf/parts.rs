//! Repeated parts as instances: a mesh for each part, with a list of its places (`EXT_mesh_gpu_instancing`).
//!
//! Parts are equal if their triangles, looks and rules are. So the file does not depend on the templates that a
//! session keeps. The identity of a part only saves making its mesh again.

use std::collections::HashMap;

use glam::DAffine3;

use super::Glb;
use super::primitive::Primitive;
use super::scene::{MeshInstance, MeshPlacement, SceneMesh};
use crate::material::layer::SetMask;
use crate::output::interner::Interner;
use crate::run::sink::{Flow, PartId, Replay};

/// The parts in the order of their first use.
#[derive(Debug, Default)]
pub(super) struct RepeatedParts {
    parts: Interner<Vec<Primitive>>,
    /// The first place of each part, and all its places.
    places: Vec<(DAffine3, Vec<MeshInstance>)>,
    /// The parts of the current run. Only for look-ups, never iterated.
    by_id: HashMap<PartId, usize>,
}

/// The bytes of a place.
const PLACE_BYTES: u64 = size_of::<MeshInstance>() as u64;

impl RepeatedParts {
    /// Begins another run, in which identities have another meaning.
    pub(super) fn begin(&mut self) {
        self.by_id.clear();
    }
}

impl Glb {
    /// Records a place of a part that repeats.
    pub(super) fn place_part(&mut self, parts: &mut RepeatedParts, replay: &Replay<'_>) -> Flow {
        let placement = replay.placement();
        // A host program may set axes that are not a rotation, which a list of places cannot express.
        if 1e-6 < (placement.matrix3.determinant() - 1.0).abs() {
            return replay.each(self);
        }
        let number = match parts.by_id.get(&replay.part()) {
            Some(&known) => known,
            None => {
                let number = parts.parts.index(self.local(replay));
                if number == parts.places.len() {
                    parts.places.push((placement, Vec::new()));
                    self.add(replay.corner_count(), replay.corner_count() / 4 * 6, 0)?;
                }
                parts.by_id.insert(replay.part(), number);
                number
            }
        };
        parts.places[number].1.push(MeshInstance::new(&placement, self.buildings.next(), self.origin));
        self.add_bytes(PLACE_BYTES)
    }

    /// The triangles of a part in its own coordinates.
    fn local(&mut self, replay: &Replay<'_>) -> Vec<Primitive> {
        let (main, buildings) = (std::mem::take(&mut self.primitives), std::mem::take(&mut self.buildings));
        let (origin, bytes) = (std::mem::take(&mut self.origin), self.bytes);
        // The part is far below the size limit of a file.
        let _ = replay.each_local(self);
        (self.origin, self.bytes, self.buildings) = (origin, bytes, buildings);
        let mut list = std::mem::replace(&mut self.primitives, main).into_list();
        // They are compared with others.
        list.iter_mut().for_each(|primitive| primitive.faces = std::mem::take(&mut primitive.faces).into_loose());
        list
    }

    /// Turns parts at several places into separate meshes; the others join the rest.
    pub(super) fn place_parts(&mut self, parts: RepeatedParts) -> Vec<SceneMesh> {
        let mut shared = Vec::new();
        for (primitives, (first, places)) in parts.parts.list.into_iter().zip(parts.places) {
            if let [only] = places[..] {
                for primitive in &primitives {
                    let index = self.primitives.with_look(primitive.look, SetMask::default());
                    self.primitives.list[index].add_moved(primitive, &first, only.building, self.origin);
                }
                continue;
            }
            shared.push(SceneMesh { primitives, places: MeshPlacement::Instances(places), building: None });
        }
        shared
    }
}
