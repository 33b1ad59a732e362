//! The components of a mesh.

use std::cell::{OnceCell, RefCell};
use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::found_tags::TagQueries;
use super::roof::RoofMesh;
use super::select::{RoofEdge, Sense, Subcomponent, Word};
use super::uv_edges::UvEdges;
use super::{Arm, Components, Select};
use crate::comp::orientation::Orientation;
use crate::geometry::Frame;
use crate::geometry::derive::{CornerValues, Derivation, FaceOrigin};
use crate::geometry::each::Each;
use crate::geometry::extract::extract;
use crate::geometry::face_frame::{FaceAxes, along, beside, face_axes, face_frame, upright};
use crate::geometry::mesh::{Adjacency, FaceTag, Mesh, flip, unit};
use crate::geometry::provenance::Provenance;
use crate::geometry::small_sort::SmallSort;
use crate::geometry::tol::{COPLANAR_EPSILON, UP_EPSILON};
use crate::geometry::wire::Wire;

/// A mesh in scope coordinates, with its components of one kind.
#[derive(Debug)]
pub(super) struct MeshParts {
    pub(super) mesh: Arc<Mesh>,
    pub(super) kind: Components,
    /// True if rectangles are held as meshes.
    as_meshes: bool,
    /// The normals of the faces; zero for faces without area.
    normals: Vec<DVec3>,
    /// The faces of each group or material.
    sets: Vec<Vec<u32>>,
    /// The face and the loop of each hole.
    holes: Vec<[u32; 2]>,
    /// True for each point at the end of a border edge.
    border: OnceCell<Vec<bool>>,
    roof: OnceCell<RoofMesh>,
    /// The set of texture coordinates that selectors mean.
    pub(super) uv_set: usize,
    uvs: OnceCell<UvEdges>,
    queries: RefCell<TagQueries>,
}

impl MeshParts {
    pub(super) fn new(mesh: Arc<Mesh>, kind: Components, as_meshes: bool) -> Self {
        let normals = mesh.face_normals();
        let sets = match kind {
            Components::Groups => sets(&mesh, mesh.groups().len(), |tag| tag.group),
            Components::Materials => sets(&mesh, mesh.material_list().len(), |tag| tag.material),
            _ => Vec::new(),
        };
        let mut holes = Vec::new();
        if kind == Components::Holes {
            for face in mesh.faces() {
                holes.extend((1..face.loops().len()).map(|ring| [face.index() as u32, ring as u32]));
            }
        }
        MeshParts {
            mesh,
            kind,
            as_meshes,
            normals,
            sets,
            holes,
            border: OnceCell::new(),
            roof: OnceCell::new(),
            uv_set: 0,
            uvs: OnceCell::new(),
            queries: RefCell::default(),
        }
    }

    fn adjacency(&self) -> &Adjacency {
        self.mesh.adjacency()
    }

    pub(super) fn len(&self) -> usize {
        match self.kind {
            Components::Faces => self.mesh.face_count(),
            Components::Edges => self.adjacency().edge_count(),
            Components::FaceEdges | Components::FaceVertices => self.mesh.corners().len(),
            Components::Vertices => self.mesh.points().len(),
            Components::Groups | Components::Materials => self.sets.len(),
            Components::Holes => self.holes.len(),
        }
    }

    /// The corners at both ends of an edge, in the order of its last face or of the face itself (*comp operation*, edge split
    /// details; *modify operation*, corrugated facade).
    fn end_corners(&self, index: usize) -> [u32; 2] {
        let last = |uses: &[u32]| uses[uses.len() - 1];
        let corner = if self.kind == Components::Edges { last(self.adjacency().uses(index)) } else { index as u32 };
        [corner, self.adjacency().next(corner)]
    }

    fn ends(&self, index: usize) -> [DVec3; 2] {
        self.end_corners(index).each(|corner| self.at(corner))
    }

    fn at(&self, corner: u32) -> DVec3 {
        self.mesh.points()[self.mesh.corners()[corner as usize] as usize]
    }

    /// The direction of a component, of length 1; zero for a component that is never selected.
    fn normal(&self, kind: Components, index: usize) -> DVec3 {
        let mean = |faces: &mut dyn Iterator<Item = u32>| {
            let mut normals = faces.map(|face| self.normals[face as usize]).filter(|normal| *normal != DVec3::ZERO);
            let first = normals.next().unwrap_or_default();
            let sum = normals.fold(first, |sum, normal| sum + normal);
            // The rest of cancelling normals is rounding, so the first face's normal is taken.
            if sum.length() <= COPLANAR_EPSILON { first } else { unit(sum) }
        };
        match kind {
            Components::Faces => self.normals[index],
            Components::Groups | Components::Materials => DVec3::ZERO,
            Components::Holes => self.normals[self.holes[index][0] as usize],
            Components::Edges => {
                let [a, b] = self.ends(index);
                let normal = mean(&mut self.adjacency().faces_at(index));
                // Faces without area give no direction.
                let normal = if normal == DVec3::ZERO { upright(unit(b - a)) } else { normal };
                if a == b { DVec3::ZERO } else { normal }
            }
            Components::Vertices => {
                let normal = mean(&mut self.adjacency().faces_around(index));
                if normal == DVec3::ZERO { DVec3::Y } else { normal }
            }
            Components::FaceEdges => {
                let [a, b] = self.ends(index);
                unit((b - a).cross(self.face_normal(index)))
            }
            Components::FaceVertices => unit(self.tangent(index).cross(self.face_normal(index))),
        }
    }

    fn face_normal(&self, corner: usize) -> DVec3 {
        self.normals[self.adjacency().face(corner as u32) as usize]
    }

    /// The direction of an outline at a corner.
    fn tangent(&self, corner: usize) -> DVec3 {
        let (adjacency, corner) = (self.adjacency(), corner as u32);
        let [before, here, after] =
            [adjacency.before(corner), corner, adjacency.next(corner)].each(|corner| self.at(corner));
        let (to, from) = (unit(here - before), unit(after - here));
        let both = unit(to + from);
        if both == DVec3::ZERO { from } else { both }
    }

    /// A place of a component.
    fn place(&self, kind: Components, index: usize) -> DVec3 {
        match kind {
            Components::Edges | Components::FaceEdges => self.ends(index).into_iter().sum::<DVec3>() * 0.5,
            Components::Vertices => self.mesh.points()[index],
            Components::FaceVertices => self.at(index as u32),
            Components::Faces => self.middle(index),
            Components::Holes => self.middle(self.holes[index][0] as usize),
            Components::Groups | Components::Materials => DVec3::ZERO,
        }
    }

    /// The mean of a face's corners.
    fn middle(&self, face: usize) -> DVec3 {
        let face = self.mesh.face(face);
        face.outline().sum::<DVec3>() / face.outer().len() as f64
    }

    /// Returns true if a word matches a component.
    #[inline]
    pub(super) fn is(&self, looks: &Orientation, index: usize, word: Word) -> bool {
        match self.kind {
            // *comp operation*: one matching face is enough.
            Components::Groups | Components::Materials => {
                let faces = &self.sets[index];
                faces.iter().any(|&face| self.is_of_kind(Components::Faces, looks, face as usize, word.0))
            }
            kind => self.is_of_kind(kind, looks, index, word.0),
        }
    }

    #[inline]
    fn is_of_kind(&self, kind: Components, looks: &Orientation, index: usize, sense: Sense) -> bool {
        let normal = self.normal(kind, index);
        normal != DVec3::ZERO && self.matches(kind, looks, index, normal, sense)
    }

    /// The first arm that takes a face. Arms have no conditions.
    #[inline]
    pub(super) fn arm_of_face(&self, looks: &Orientation, face: usize, arms: &[Arm]) -> Option<usize> {
        let normal = self.normals[face];
        if normal == DVec3::ZERO {
            return None;
        }
        arms.iter().position(|arm| match arm.select {
            Select::Word(word) => self.matches(Components::Faces, looks, face, normal, word.0),
            Select::Index(number) => number == face as f64,
            Select::When => false,
        })
    }

    /// Returns true if a word matches a component with a direction.
    #[inline(always)]
    fn matches(&self, kind: Components, looks: &Orientation, index: usize, normal: DVec3, sense: Sense) -> bool {
        match sense {
            Sense::All => true,
            Sense::Shape | Sense::Remainder => false,
            Sense::Looks(axes, direction) => {
                // Edges and vertices of a face look out of it within its plane, independently of its normal.
                let within = matches!(kind, Components::FaceEdges | Components::FaceVertices);
                let normal = if within { normal } else { looks.outwards(normal) };
                looks.takes(axes, direction, normal, || self.place(kind, index))
            }
            Sense::Uv(side) => {
                let uvs = self.uvs.get_or_init(|| UvEdges::of(&self.mesh, self.uv_set));
                let face = || self.adjacency().face(index as u32) as usize;
                kind == Components::FaceEdges && uvs.takes(&self.mesh, face(), self.end_corners(index), side)
            }
            Sense::Border(border) => self.at_border(kind, index) == border,
            Sense::Roof(edge) => {
                let roof = || RoofMesh::new(&self.mesh, &self.normals, looks.inwards);
                kind == Components::Edges && self.roof.get_or_init(roof).edge(index) == Some(edge)
            }
        }
    }

    /// Returns true if a tag of a component matches. Faces pass their tags on to their edges and vertices, and edges to
    /// their vertices. If subcomponents are named, their tags are tested instead of the component's own (*comp operation*,
    /// isTagged).
    pub(super) fn tagged(&self, index: usize, of: Option<Subcomponent>, query: &str) -> bool {
        let (mesh, tags) = (&self.mesh, self.mesh.subcomponent_tags());
        if mesh.tag_sets().is_empty() && tags.is_empty() {
            return false;
        }
        let mut queries = self.queries.borrow_mut();
        let found = queries.found(query, mesh.tag_sets(), tags);
        if found.is_empty() {
            return false;
        }
        let (adjacency, point_of) = (self.adjacency(), |corner: u32| mesh.corners()[corner as usize]);
        let face = |face: u32| found.face(mesh.face(face as usize).tag().tags);
        let edge = |corner: u32| {
            let ends = [corner, adjacency.next(corner)].each(point_of);
            found.edge(tags, ends) || adjacency.faces_at(adjacency.edge(corner)).any(face)
        };
        let own = |point: u32| found.point(tags, mesh.points().len(), point);
        let point = |point: u32| own(point) || adjacency.faces_around(point as usize).any(face);
        let by_face = |number: u32| {
            let mut corners = mesh.face(number as usize).corner_range().map(|corner| corner as u32);
            match of {
                None => face(number),
                Some(Subcomponent::Edges) => corners.any(edge),
                Some(Subcomponent::Vertices) => corners.any(|corner| point(point_of(corner))),
            }
        };
        match self.kind {
            Components::Faces => by_face(index as u32),
            Components::Holes => by_face(self.holes[index][0]),
            Components::Groups | Components::Materials => self.sets[index].iter().copied().any(by_face),
            Components::Edges | Components::FaceEdges if of == Some(Subcomponent::Vertices) => {
                self.end_corners(index).into_iter().any(|corner| point(point_of(corner)))
            }
            Components::Edges | Components::FaceEdges => edge(self.end_corners(index)[0]),
            Components::Vertices => point(index as u32),
            Components::FaceVertices => point(point_of(index as u32)),
        }
    }

    fn at_border(&self, kind: Components, index: usize) -> bool {
        let is_border = |corner: u32| self.adjacency().is_border(self.adjacency().edge(corner));
        match kind {
            Components::Faces => self.mesh.face(index).corner_range().any(|corner| is_border(corner as u32)),
            Components::Edges | Components::FaceEdges => is_border(self.end_corners(index)[0]),
            Components::Vertices => self.border_points()[index],
            Components::FaceVertices => self.border_points()[self.mesh.corners()[index] as usize],
            Components::Groups | Components::Materials | Components::Holes => false,
        }
    }

    fn border_points(&self) -> &[bool] {
        self.border.get_or_init(|| {
            let (adjacency, corners) = (self.adjacency(), self.mesh.corners());
            let mut found = vec![false; self.mesh.points().len()];
            for corner in (0..corners.len() as u32).filter(|&corner| adjacency.is_border(adjacency.edge(corner))) {
                for end in [corner, adjacency.next(corner)] {
                    found[corners[end as usize] as usize] = true;
                }
            }
            found
        })
    }

    /// The coordinate system of a face. `None` for other components, and for a face without area.
    #[inline(always)]
    pub(super) fn face_axes(&self, index: usize) -> Option<FaceAxes> {
        match self.kind {
            Components::Faces => face_axes(&self.mesh, index, self.normals[index]),
            _ => None,
        }
    }

    /// The provenance of a face that has no other attributes. `None` for a face that is to be a mesh.
    pub(super) fn provenance(&self, index: usize) -> Option<Provenance> {
        let mesh = &self.mesh;
        if self.as_meshes || mesh.has_corner_values() {
            return None;
        }
        if !mesh.subcomponent_tags().is_empty() && self.has_tagged_subcomponents(index) {
            return None;
        }
        Provenance::of(mesh, mesh.face(index).tag())
    }

    /// Returns true if an edge or a vertex of a face has tags.
    fn has_tagged_subcomponents(&self, face: usize) -> bool {
        let (mesh, tags) = (&self.mesh, self.mesh.subcomponent_tags());
        mesh.face(face).edges().any(|edge| {
            let ends = edge.each(|corner| mesh.corners()[corner]);
            tags.edge(ends).is_some() || tags.vertex(ends[0]).is_some()
        })
    }

    /// The coordinate system of a component (*comp operation*). `None` for groups and materials, which keep the system of
    /// the shape, and for degenerate components.
    pub(super) fn frame(&self, index: usize, as_roof: bool) -> Option<Frame> {
        let (x, origin) = match self.kind {
            Components::Faces => return self.face_axes(index).map(|found| found.frame),
            Components::Groups | Components::Materials => return None,
            Components::Holes => return face_frame(&self.filled(&[index as u32]), 0).map(|found| found.frame),
            Components::Edges | Components::FaceEdges => {
                let [a, b] = self.directed(index, as_roof).each(|corner| self.at(corner));
                (unit(b - a), a)
            }
            Components::Vertices => (beside(self.normal(self.kind, index)), self.mesh.points()[index]),
            Components::FaceVertices => (self.tangent(index), self.at(index as u32)),
        };
        let z = self.normal(self.kind, index);
        (x != DVec3::ZERO).then(|| Frame { origin, axes: along(x, z) })
    }

    /// The ends of an edge. As an edge of a roof it runs upwards, or around the roof's face if it is an eave (*comp
    /// operation*, roof edges). A level ridge runs as its first face (*modify operation*, modified roof ridge).
    fn directed(&self, edge: usize, as_roof: bool) -> [u32; 2] {
        let [a, b] = self.end_corners(edge);
        let Some(roof) = self.roof.get().filter(|_| as_roof) else { return [a, b] };
        match roof.edge(edge) {
            Some(RoofEdge::Eave) => {
                let corner = roof.corner(edge).unwrap_or(a);
                [corner, self.adjacency().next(corner)]
            }
            Some(_) => {
                let [from, to] = [a, b].each(|corner| self.at(corner));
                if UP_EPSILON < unit(to - from).y { [a, b] } else { [b, a] }
            }
            None => [a, b],
        }
    }

    /// The faces of some components, as a mesh in the coordinates of a frame; `None` for edges and vertices.
    pub(super) fn surface(&self, indices: &[u32], frame: &Frame) -> Option<Mesh> {
        match self.kind {
            Components::Faces => Some(extract(&self.mesh, indices, frame)),
            Components::Groups | Components::Materials => {
                let mut faces: Vec<u32> =
                    indices.iter().flat_map(|&index| &self.sets[index as usize]).copied().collect();
                faces.small_sort();
                Some(extract(&self.mesh, &faces, frame))
            }
            Components::Holes => {
                let filled = self.filled(indices);
                let all: Vec<u32> = (0..filled.face_count() as u32).collect();
                Some(extract(&filled, &all, frame))
            }
            _ => None,
        }
    }

    /// Faces that fill holes, with the direction of the faces around them. They begin with the first edges of the
    /// holes, and have the tags of edges and vertices.
    fn filled(&self, indices: &[u32]) -> Mesh {
        let mut filled = Derivation::new(&self.mesh, CornerValues::Dropped, 0);
        let mut numbers = BTreeMap::new();
        for &index in indices {
            let [face, ring] = self.holes[index as usize];
            let face = self.mesh.face(face as usize);
            let mut ring = face.loops().nth(ring as usize).unwrap_or_default().to_vec();
            flip(&mut ring);
            ring.iter_mut()
                .for_each(|point| *point = *numbers.entry(*point).or_insert_with(|| filled.old_point(*point)));
            filled.face([ring], FaceOrigin::filling(&face));
        }
        filled.finish()
    }

    /// The edges or points of some components.
    pub(super) fn wire(&self, indices: &[u32], as_roof: bool) -> Wire {
        let indices = indices.iter().map(|&index| index as usize);
        let normals = indices.clone().map(|index| self.normal(self.kind, index)).collect();
        if !matches!(self.kind, Components::Edges | Components::FaceEdges) {
            let point = |index: usize| match self.kind {
                Components::FaceVertices => self.mesh.corners()[index],
                _ => index as u32,
            };
            let numbers: Vec<u32> = indices.clone().map(point).collect();
            let points = indices.map(|index| self.place(self.kind, index)).collect();
            return Wire::of_points(points, self.mesh.subcomponent_tags(), self.mesh.trace(), &numbers, normals);
        }
        let point = |corner: u32| self.mesh.corners()[corner as usize];
        let mut edges = indices.map(|index| self.directed(index, as_roof).each(point));
        Wire::of_edges(self.mesh.points(), self.mesh.subcomponent_tags(), self.mesh.trace(), &mut edges, normals)
    }

    /// Calls `bond` with the number of each edge of a component with faces, or of each point of another component.
    /// Components with a common number are connected (*comp operation*, `=:`).
    pub(super) fn bonds(&self, index: usize, mut bond: impl FnMut(u32)) {
        let (adjacency, corners) = (self.adjacency(), self.mesh.corners());
        let mut of_face = |face: u32| {
            self.mesh.face(face as usize).corner_range().for_each(|corner| bond(adjacency.edge(corner as u32) as u32));
        };
        match self.kind {
            Components::Faces => of_face(index as u32),
            Components::Groups | Components::Materials => self.sets[index].iter().for_each(|&face| of_face(face)),
            // Holes share no edges.
            Components::Holes => {}
            Components::Edges | Components::FaceEdges => {
                self.end_corners(index).iter().for_each(|&corner| bond(corners[corner as usize]));
            }
            Components::Vertices => bond(index as u32),
            Components::FaceVertices => bond(corners[index]),
        }
    }
}

/// Faces by the number of their group or material, in the order of numbers. Faces without a number come last.
fn sets(mesh: &Mesh, count: usize, number: impl Fn(FaceTag) -> u32) -> Vec<Vec<u32>> {
    let mut sets = vec![Vec::new(); count + 1];
    for face in mesh.faces() {
        sets[(number(face.tag()) as usize).min(count)].push(face.index() as u32);
    }
    sets.retain(|faces| !faces.is_empty());
    sets
}
