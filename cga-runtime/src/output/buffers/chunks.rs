//! Buffers of bounded size, passed on as they fill.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use glam::{DAffine3, DVec3};

use super::chunk_result::ChunkResult;
use super::submesh::SubmeshStart;
use super::{Buffers, Vertex};
use crate::geometry::each::Each;
use crate::geometry::mesh::Mesh;
use crate::output::flatten::PlacedFace;
use crate::run::building::Building;
use crate::run::sink::{Cuboid, Filled, Flow, Leaf, Quad, Replay, Sink};

/// The number of vertices of a box, which is never divided.
const LEAST: usize = 24;

/// The largest number of vertices in a chunk. A face with holes may have more triangles than vertices, and both are
/// counted in `u32`.
const MOST: usize = u32::MAX as usize / 2;

/// Streams leaves as chunks of triangles in constant memory.
///
/// Each chunk is complete in itself: indices count from 0, and rules and materials have their own numbers. All chunks
/// together have the triangles of [`Buffers`], in the same order. A chunk is passed to `each` when the next leaf does
/// not fit, and the last one at [`into_result`](Chunks::into_result) or [`finish`](Sink::finish). A run does not end a chunk: one
/// chunk may have leaves of many initial shapes.
///
/// `each` returns a [`Result`] or a [`Flow`]. An error or `Break` ends the run (its report is marked as stopped), later runs end at their
/// first leaves, and `into_result` returns it.
///
/// A mesh with more vertices than a chunk is divided between faces. A face with more vertices than a chunk is divided
/// into its triangles, which then share no vertices.
///
/// ```
/// use std::io::Write;
/// # use cga_runtime::facade as cga;
/// use cga::sink::buffers::{Buffers, Chunks};
///
/// let (mut triangles, mut list) = (0, Vec::new());
/// let chunks = Chunks::new(10_000, |chunk: &Buffers| {
///     triangles += chunk.triangle_count();
///     writeln!(list, "{triangles}")
/// });
/// // … `grammar.run(&shape, &settings, &mut chunks)?` for each shape, then:
/// chunks.into_result()?;
/// assert_eq!(triangles, 0);
/// # std::io::Result::Ok(())
/// ```
pub struct Chunks<F, R = Flow> {
    buffers: Buffers,
    capacity: usize,
    /// The capacity; 0 before memory is reserved and after the end, so that adding a leaf needs one comparison.
    full: usize,
    each: F,
    chunks: u64,
    /// The last result of `each`.
    result: R,
}

impl<F, R> fmt::Debug for Chunks<F, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Chunks").field("capacity", &self.capacity).field("chunks", &self.chunks).finish_non_exhaustive()
    }
}

impl<R: ChunkResult, F: FnMut(&Buffers) -> R> Chunks<F, R> {
    /// Chunks of at most `max_vertices` vertices, but at least 24. `each` gets them in order; an error or `Break` ends the run.
    pub fn new(max_vertices: usize, each: F) -> Self {
        let capacity = max_vertices.clamp(LEAST, MOST);
        Chunks { buffers: Buffers::new(), capacity, full: 0, each, chunks: 0, result: R::go_on() }
    }

    /// Subtracts a point of the world from every position; see [`Buffers::with_origin`].
    pub fn with_origin(mut self, origin: DVec3) -> Self {
        self.buffers = self.buffers.with_origin(origin);
        self
    }

    /// Records which triangles belong to which initial shape; see [`Buffers::buildings`].
    pub fn with_buildings(mut self) -> Self {
        self.buffers = self.buffers.with_buildings();
        self
    }

    /// Passes on the last chunk, and returns the error or the `Break` with which `each` ended the run.
    pub fn into_result(mut self) -> R {
        let _ = self.hand_out();
        self.result
    }

    /// The number of chunks passed on so far.
    pub fn handed_out(&self) -> u64 {
        self.chunks
    }

    /// Makes room for vertices.
    #[inline]
    fn room(&mut self, vertices: usize) -> Flow {
        if self.full < self.buffers.triangles.vertices.len() + vertices { self.make_room() } else { Flow::Continue(()) }
    }

    #[cold]
    fn make_room(&mut self) -> Flow {
        self.hand_out()?;
        if self.full == 0 {
            // One reservation, so that a chunk does not grow beyond its size by doubling. The four vertices of a
            // rectangle have six indices.
            self.buffers.triangles.vertices.reserve_exact(self.capacity);
            self.buffers.triangles.indices.reserve_exact(self.capacity / 4 * 6);
            self.full = self.capacity;
        }
        Flow::Continue(())
    }

    /// Passes the chunk to `each`, unless it is empty, and begins another.
    #[cold]
    fn hand_out(&mut self) -> Flow {
        if !self.result.is_end() && self.buffers.triangles.vertices.len() != 0 {
            self.chunks += 1;
            self.result = (self.each)(&self.buffers);
            self.buffers.clear();
        }
        if self.result.is_end() {
            self.full = 0;
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }

    /// Adds a mesh with more vertices than a chunk, face by face.
    #[cold]
    fn large_mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let mut flattener = std::mem::take(&mut self.buffers.flattener);
        let mut flow = Flow::Continue(());
        flattener.faces(mesh, placement, |face| {
            let first = face.corners.start;
            flow = if face.corners.len() <= self.capacity {
                self.face(leaf, &face, face.corners.clone(), face.triangles)
            } else {
                let mut corners = face.triangles.iter().map(|triangle| triangle.each(|i| first + i as usize));
                corners.try_for_each(|corners| self.face(leaf, &face, corners.into_iter(), &[[0, 1, 2]]))
            };
            flow.is_continue()
        });
        self.buffers.flattener = flattener;
        flow
    }

    /// Adds triangles of a face; see [`Buffers::face`].
    fn face(
        &mut self,
        leaf: &Leaf<'_>,
        face: &PlacedFace<'_>,
        corners: impl ExactSizeIterator<Item = usize> + Clone,
        triangles: &[[u32; 3]],
    ) -> Flow {
        self.room(corners.len())?;
        let numbers = self.buffers.numbers.leaf(leaf);
        self.buffers.face(face, numbers, corners, triangles);
        self.buffers.pad_uvs();
        Flow::Continue(())
    }
}

impl Buffers {
    /// The bytes reserved for vertices, indices, texture coordinates and submeshes.
    pub fn memory(&self) -> usize {
        size_of::<Vertex>() * self.triangles.vertices.capacity()
            + size_of::<u32>() * self.triangles.indices.capacity()
            + self.uvs.memory()
            + size_of::<SubmeshStart>() * self.runs.capacity()
    }
}

impl<R: ChunkResult, F: FnMut(&Buffers) -> R> Sink for Chunks<F, R> {
    fn begin(&mut self) {
        self.buffers.begin();
    }

    fn begin_building(&mut self, name: &str, seed: u64) {
        self.buffers.begin_building(name, seed);
    }

    fn end_building(&mut self, building: &dyn Fn() -> Building) {
        self.buffers.end_building(building);
    }

    #[inline]
    fn filled(&mut self, leaf: &Filled<'_>) -> Flow {
        self.room(leaf.corner_count())?;
        self.buffers.filled(leaf)
    }

    fn replay(&mut self, replay: &Replay<'_>) -> Flow {
        // The leaves go one by one if the chunk ends between them.
        if self.full < self.buffers.triangles.vertices.len() + replay.corner_count() {
            return replay.each(self);
        }
        self.buffers.replay(replay)
    }

    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        self.room(4)?;
        self.buffers.quad(leaf, quad)
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        self.room(LEAST)?;
        self.buffers.cuboid(leaf, cuboid)
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        match mesh.corners().len() {
            // Its material would stay in the table, and a chunk of such meshes would never end.
            0 => Flow::Continue(()),
            count if count <= self.capacity => {
                self.room(count)?;
                self.buffers.mesh(leaf, mesh, placement)
            }
            _ => self.large_mesh(leaf, mesh, placement),
        }
    }

    /// Passes on the last chunk and releases its memory.
    fn finish(&mut self) -> Flow {
        let flow = self.hand_out();
        let buildings = self.buffers.buildings.take();
        self.buffers = Buffers { buildings, ..Buffers::new().with_origin(self.buffers.origin()) };
        self.full = 0;
        flow
    }
}
