//! GLB files from buffers: chunks of a stream, or batches made in parallel.

use std::io;
use std::ops::ControlFlow;
use std::path::Path;

use glam::DVec3;

use super::Glb;
use super::primitive::{Owner, Primitive};
use crate::geometry::each::Each;
use crate::material::layer::SetMask;
use crate::output::batches::Batches;
use crate::output::buffers::{Buffers, Submesh, Vertex};
use crate::output::error::WriteError;
use crate::run::sink::Flow;

impl Glb {
    /// Adds all triangles of buffers, and their [buildings](Buffers::buildings) if they record them. Several buffers make one file, without
    /// being joined first. In a set that only
    /// some of the buffers' vertices use, the others have (0, 0).
    ///
    /// ```
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::gltf::Glb;
    /// use cga::sink::buffers::Buffers;
    ///
    /// let list = [Buffers::new(), Buffers::new()];
    /// let mut glb = Glb::new();
    /// let _ = list.iter().try_for_each(|buffers| glb.buffers(buffers));
    /// assert!(glb.into_bytes().unwrap().starts_with(b"glTF"));
    /// ```
    pub fn buffers(&mut self, buffers: &Buffers) -> Flow {
        let sets = SetMask::of(|set| !buffers.uv_set(set).is_empty());
        let moved = buffers.origin() - self.origin;
        for (building, submeshes) in buffers.submeshes_of_buildings() {
            if let Some(building) = building {
                self.buildings.begin(&building.name, building.seed);
            }
            for submesh in submeshes {
                let table = &mut self.numbers.table;
                let rule = table.rule(&buffers.rules()[submesh.rule as usize]);
                let material = table.material(&buffers.materials()[submesh.material as usize]);
                self.add(submesh.vertices.len(), submesh.indices.len(), sets.sets().count())?;
                let owner = self.owner(rule);
                let primitive = self.primitives.of(&mut self.looks, &self.numbers.table, material, sets);
                primitive.submesh(buffers, &submesh, owner, moved);
            }
            building.cloned().into_iter().for_each(|building| self.buildings.end(building));
        }
        ControlFlow::Continue(())
    }
}

impl Primitive {
    /// Adds the triangles of a submesh of buffers.
    fn submesh(&mut self, buffers: &Buffers, submesh: &Submesh, owner: Owner, moved: DVec3) {
        self.begin(owner);
        let vertices = &buffers.vertices()[submesh.vertices.clone()];
        let first = submesh.vertices.start as u32;
        let to_file = |vertex: &Vertex| match (*vertex, moved) {
            (vertex, DVec3::ZERO) => vertex,
            ([x, y, z, u, v, w], moved) => {
                let [x, y, z] = (DVec3::from_array([x, y, z].each(f64::from)) + moved).as_vec3().to_array();
                [x, y, z, u, v, w]
            }
        };
        let indices = buffers.indices()[submesh.indices.clone()].iter().map(|index| index - first);
        self.faces.extend(vertices.iter().map(to_file), indices);
        for (set, list) in self.sets.sets().zip(&mut self.uvs) {
            // The v axis of glTF points down.
            list.extend(buffers.uv_set(set)[submesh.vertices.clone()].iter().map(|&[u, v]| [u, 1.0 - v]));
        }
    }
}

impl Buffers {
    /// The buffers as a GLB file; see [`Glb`]. Positions stay relative to the origin of the buffers. Images are
    /// referenced: [`Glb::with_assets`] and [`Glb::buffers`] embed them.
    ///
    /// # Errors
    /// As [`Glb::into_bytes`].
    pub fn to_glb(&self) -> Result<Vec<u8>, WriteError> {
        self.glb().into_bytes()
    }

    /// Writes the buffers as a GLB file: a chunk of a stream, for example.
    ///
    /// ```no_run
    /// # use cga_runtime::facade as cga;
    /// use cga::sink::buffers::{Buffers, Chunks};
    ///
    /// let mut number = 0;
    /// let chunks = Chunks::new(1_000_000, |chunk: &Buffers| {
    ///     number += 1;
    ///     chunk.write_glb(format!("city-{number:05}.glb"))
    /// });
    /// // … `grammar.run(&shape, &settings, &mut chunks)?` for each shape, then:
    /// chunks.into_result()?;
    /// # Ok::<(), cga_runtime::output::error::WriteError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Glb::into_bytes`], and errors of the file system.
    pub fn write_glb(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        self.glb().write_file(path.as_ref())
    }

    /// Writes the bytes of [`Buffers::to_glb`] to `out`.
    ///
    /// # Errors
    /// As [`Glb::write_to`].
    pub fn write_glb_to(&self, out: impl io::Write) -> Result<(), WriteError> {
        self.glb().write_to(out)
    }

    fn glb(&self) -> Glb {
        from_buffers(std::iter::once(self))
    }
}

impl Batches<Buffers> {
    /// All batches as one GLB file, with positions relative to the origin of the first.
    ///
    /// # Errors
    /// As [`Glb::into_bytes`].
    pub fn to_glb(&self) -> Result<Vec<u8>, WriteError> {
        self.glb().into_bytes()
    }

    /// Writes all batches as one GLB file.
    ///
    /// # Errors
    /// As [`Glb::into_bytes`], and errors of the file system.
    pub fn write_glb(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        self.glb().write_file(path.as_ref())
    }

    /// Writes the bytes of one GLB file with all batches to `out`.
    ///
    /// # Errors
    /// As [`Glb::write_to`].
    pub fn write_glb_to(&self, out: impl io::Write) -> Result<(), WriteError> {
        self.glb().write_to(out)
    }

    fn glb(&self) -> Glb {
        from_buffers(self.sinks())
    }
}

/// A file of buffers, with positions relative to the origin of the first.
fn from_buffers<'a>(list: impl Iterator<Item = &'a Buffers> + Clone) -> Glb {
    let origin = list.clone().next().map_or(DVec3::ZERO, Buffers::origin);
    let mut glb = Glb::new().with_origin(origin);
    // It stops when it is full; `into_bytes` reports that.
    let _ = list.clone().try_for_each(|buffers| glb.buffers(buffers));
    glb
}
