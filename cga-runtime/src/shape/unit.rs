//! The meshes of boxes and rectangles, with sides of length 1.
//!
//! A box or a rectangle needs no mesh of its own: its scope gives its corners. The rest of its mesh (the order of
//! faces and vertices, the first edge of each face, tags) is one of few unit meshes. All boxes of a program share
//! them, and equal unit meshes are one, so a box carries only a reference. The unit meshes that follow from a cut or
//! an extrusion are found once, by cutting or extruding a unit mesh. So a box has the numbering of the equal mesh, by
//! construction.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use cga_split::tags::matches;
use glam::{DAffine3, DMat3, DVec3};

use super::tags::tag_query;
use crate::geometry::Axis;
use crate::geometry::cut;
use crate::geometry::each::Each;
use crate::geometry::extrude::{Extrude, extrude};
use crate::geometry::mesh::{Mesh, TaggedComponents};
use crate::geometry::primitive;
use crate::geometry::provenance::Provenance;
use crate::geometry::solid;
use crate::geometry::uv_map::UvMap;
use crate::shape::texture::unit_cube_side;

/// The mesh of a box or a rectangle with a length of 1 along each of its axes. A rectangle is at 0 on the axis across
/// it.
#[derive(Clone, Copy)]
pub(crate) struct UnitMesh(&'static UnitShape);

struct UnitShape {
    mesh: Arc<Mesh>,
    /// The faces in order; six equal faces for a rectangle.
    faces: [UnitFace; 6],
    face_count: usize,
    /// The parts of a split, by axis and [`Band`].
    parts: [OnceLock<UnitMesh>; 9],
    /// True for each axis along which the parts of a split have other unit meshes.
    has_bands: [OnceLock<bool>; 3],
    grown: OnceLock<UnitMesh>,
    /// The same mesh marked as inserted.
    inserted: OnceLock<UnitMesh>,
    /// The unmarked unit of an inserted one.
    plain: Option<UnitMesh>,
    /// The mesh with the texture coordinates of a cube.
    textured: OnceLock<Arc<Mesh>>,
}

/// A face of a unit mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UnitFace {
    pub(crate) side: BoxSide,
    /// The corners from the first edge on, as numbers x + 2y + 4z.
    pub(crate) corners: [u8; 4],
    /// The first corner.
    pub(crate) origin: DVec3,
    /// The axes of the face as axes of the box, each with a sign: x along the first edge, z outwards.
    pub(crate) along: [(Axis, f64); 3],
    pub(crate) provenance: Provenance,
}

/// A side of a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BoxSide {
    Front,
    Right,
    Back,
    Left,
    Top,
    Bottom,
}

impl BoxSide {
    pub(crate) const ALL: [BoxSide; 6] =
        [BoxSide::Front, BoxSide::Right, BoxSide::Back, BoxSide::Left, BoxSide::Top, BoxSide::Bottom];

    /// The outward normal.
    pub(crate) const fn normal(self) -> DVec3 {
        match self {
            BoxSide::Front => DVec3::Z,
            BoxSide::Right => DVec3::X,
            BoxSide::Back => DVec3::NEG_Z,
            BoxSide::Left => DVec3::NEG_X,
            BoxSide::Top => DVec3::Y,
            BoxSide::Bottom => DVec3::NEG_Y,
        }
    }
}

/// The position of a piece in a box: at the low end of the axis, between two cuts, at the high end, or the whole box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Band {
    Low,
    Middle,
    High,
    All,
}

impl Band {
    /// The band of a piece that begins at the low end, or ends at the high end, or both.
    #[inline]
    pub(crate) fn of(is_first: bool, is_last: bool) -> Self {
        match (is_first, is_last) {
            (true, true) => Band::All,
            (true, false) => Band::Low,
            (false, true) => Band::High,
            (false, false) => Band::Middle,
        }
    }
}

impl UnitMesh {
    /// The initial box.
    pub(crate) fn cuboid() -> Self {
        static CUBOID: OnceLock<UnitMesh> = OnceLock::new();
        *CUBOID.get_or_init(|| UnitMesh::shared(solid::cuboid()))
    }

    /// The box of `primitiveCube`.
    pub(crate) fn cube() -> Self {
        static CUBE: OnceLock<UnitMesh> = OnceLock::new();
        *CUBE.get_or_init(|| UnitMesh::shared(primitive::cube()).as_inserted())
    }

    /// The rectangle of `primitiveQuad` across an axis.
    pub(crate) fn quad(across: Axis) -> Self {
        UnitMesh::rectangle(across).as_inserted()
    }

    /// The same mesh marked as inserted (*geometry.isInstanced function*). Its parts do not have the mark.
    fn as_inserted(self) -> Self {
        *self.0.inserted.get_or_init(|| {
            let UnitShape { mesh, faces, face_count, .. } = self.0;
            let unit = UnitShape { plain: Some(self), ..UnitShape::with(mesh.clone(), *faces, *face_count) };
            UnitMesh(Box::leak(Box::new(unit)))
        })
    }

    /// Returns true if an operation has inserted it and nothing has changed it since.
    pub(crate) fn is_inserted(self) -> bool {
        self.0.plain.is_some()
    }

    /// Returns true for the same unit mesh, which equal unit meshes are.
    #[inline]
    pub(crate) fn is(self, other: Self) -> bool {
        std::ptr::eq(self.0, other.0)
    }

    /// The same mesh without the mark of an insertion.
    #[inline]
    pub(crate) fn plain(self) -> Self {
        self.0.plain.unwrap_or(self)
    }

    /// A rectangle across an axis, with its normal along that axis.
    pub(crate) fn rectangle(across: Axis) -> Self {
        UnitMesh::face(across, Provenance::Unknown)
    }

    /// A single face, as a rectangle across an axis with its normal along that axis.
    #[inline]
    pub(crate) fn face(across: Axis, provenance: Provenance) -> Self {
        const COUNT: usize = 3 * Provenance::COUNT;
        static RECTANGLES: [OnceLock<UnitMesh>; COUNT] = [const { OnceLock::new() }; COUNT];
        *RECTANGLES[Provenance::COUNT * across.index() + provenance.number()]
            .get_or_init(|| UnitMesh::shared(solid::square(across, provenance)))
    }

    /// The shared unit mesh that equals a mesh with all corners at 0 or 1.
    fn shared(mesh: Mesh) -> Self {
        static ALL: Mutex<BTreeMap<Vec<u32>, UnitMesh>> = Mutex::new(BTreeMap::new());
        // A panic in another thread cannot leave the map half changed.
        let mut all = ALL.lock().unwrap_or_else(PoisonError::into_inner);
        *all.entry(key(&mesh)).or_insert_with(|| UnitMesh(Box::leak(Box::new(UnitShape::new(mesh)))))
    }

    pub(crate) fn mesh(self) -> &'static Arc<Mesh> {
        &self.0.mesh
    }

    /// The mesh of a box with the texture coordinates of an inserted cube (*primitiveCube operation*). Caps have (0, 0).
    pub(crate) fn with_cube_coordinates(self) -> &'static Arc<Mesh> {
        self.0.textured.get_or_init(|| {
            let (faces, points) = (self.faces().iter(), self.mesh().points());
            let is_cap = |face: &UnitFace| face.provenance == Provenance::Cut;
            let maps = faces.flat_map(|face| {
                let map = if is_cap(face) { UvMap::ZERO } else { unit_cube_side(face.side.normal()) };
                [map; 4]
            });
            let uvs = maps.zip(self.mesh().corners()).map(|(map, &corner)| map.at(points[corner as usize]));
            Arc::new(self.mesh().with_uv_set(0, uvs.collect()))
        })
    }

    /// Its faces, in order.
    pub(crate) fn faces(self) -> &'static [UnitFace] {
        &self.0.faces[..self.face_count()]
    }

    #[inline]
    pub(crate) fn face_count(self) -> usize {
        self.0.face_count
    }

    /// The faces of a box, in order.
    #[inline]
    pub(crate) fn sides(self) -> &'static [UnitFace; 6] {
        &self.0.faces
    }

    /// The corners of the vertices, in order, as numbers x + 2y + 4z.
    pub(crate) fn numbers(self) -> impl Iterator<Item = u8> {
        self.0.mesh.points().iter().map(|&point| number_of(point))
    }

    /// The part of a split across an axis, stretched to length 1 again.
    #[inline]
    pub(crate) fn part(self, axis: Axis, band: Band) -> Self {
        if band == Band::All {
            return self.plain();
        }
        match self.0.parts[3 * axis.index() + band as usize].get() {
            Some(part) => *part,
            None => self.cut(axis, band),
        }
    }

    /// Returns true if the parts of a split across an axis have other unit meshes than this one.
    #[inline]
    pub(crate) fn has_bands(self, axis: Axis) -> bool {
        match self.0.has_bands[axis.index()].get() {
            Some(known) => *known,
            None => self.find_bands(axis),
        }
    }

    #[cold]
    fn find_bands(self, axis: Axis) -> bool {
        let differs = |band| !std::ptr::eq(self.part(axis, band).0, self.0);
        *self.0.has_bands[axis.index()]
            .get_or_init(|| self.is_inserted() || [Band::Low, Band::Middle, Band::High].into_iter().any(differs))
    }

    #[cold]
    fn cut(self, axis: Axis, band: Band) -> Self {
        let made = || match cut::slabs(&self.0.mesh, axis, &[0.25, 0.75]).parts.get(band as usize) {
            Some(Some(part)) => UnitMesh::shared(stretched(part)),
            _ => self.plain(),
        };
        *self.0.parts[3 * axis.index() + band as usize].get_or_init(made)
    }

    /// The box that `extrude` makes of a rectangle. Its y axis is the direction of growth, and its x axis is as near
    /// as possible to the old one.
    #[inline]
    pub(crate) fn grown(self, across: Axis) -> Self {
        *self.0.grown.get_or_init(|| {
            let axes = match across {
                Axis::X => DMat3::from_cols(DVec3::NEG_Y, DVec3::X, DVec3::Z),
                Axis::Y => DMat3::IDENTITY,
                Axis::Z => DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y),
            };
            let turn = DAffine3 { matrix3: axes.transpose(), translation: DVec3::ZERO };
            UnitMesh::shared(stretched(&extrude(&self.0.mesh, Extrude::FaceNormal, 1.0).map(&turn)))
        })
    }

    /// The mesh without the tags that a query matches, or without all tags if there is no query.
    pub(crate) fn without_tags(self, query: Option<&str>) -> Self {
        UnitMesh::shared(self.0.mesh.without_tags(&tag_query(query), TaggedComponents::Faces))
    }

    /// Returns true if it has a cap that no operation on texture coordinates has reached.
    pub(crate) fn has_unmapped_caps(self) -> bool {
        self.faces().iter().any(|face| face.provenance == Provenance::Cut)
    }

    /// The mesh whose caps are reached by operations on texture coordinates.
    pub(crate) fn with_mapped_caps(self) -> Self {
        UnitMesh::shared(self.0.mesh.with_mapped_caps())
    }

    /// The mesh mirrored about its middle, with its faces looking outwards as before.
    pub(crate) fn mirrored(self, flips: [bool; 3]) -> Self {
        let mesh = &self.0.mesh;
        let far = DVec3::from_array(flips.each(f64::from));
        let mirrored = mesh.with_points(mesh.points().iter().map(|&point| (far - point).abs()).collect());
        let is_odd = flips.iter().filter(|flip| **flip).count() % 2 == 1;
        UnitMesh::shared(if is_odd { mirrored.reversed() } else { mirrored })
    }

    /// The same rectangle across another axis.
    pub(crate) fn across(self, axis: Axis) -> Self {
        let [face, ..] = &self.0.faces;
        let turned = UnitMesh::face(axis, face.provenance);
        let (from, to) = (&self.0.mesh, &turned.0.mesh);
        let mut points = from.points().to_vec();
        for (here, there) in from.corners().iter().zip(to.corners()) {
            points[*here as usize] = to.points()[*there as usize];
        }
        let turned = UnitMesh::shared(to.with_corners_at(points, from.corners().to_vec()));
        if self.is_inserted() { turned.as_inserted() } else { turned }
    }
}

impl UnitShape {
    fn new(mesh: Mesh) -> Self {
        let face = |number: usize| UnitFace::of(&mesh, number % mesh.face_count());
        let (faces, face_count) = ([0, 1, 2, 3, 4, 5].map(face), mesh.face_count());
        UnitShape::with(Arc::new(mesh), faces, face_count)
    }

    fn with(mesh: Arc<Mesh>, faces: [UnitFace; 6], face_count: usize) -> Self {
        UnitShape {
            mesh,
            faces,
            face_count,
            parts: [const { OnceLock::new() }; 9],
            has_bands: [const { OnceLock::new() }; 3],
            grown: OnceLock::new(),
            inserted: OnceLock::new(),
            plain: None,
            textured: OnceLock::new(),
        }
    }
}

impl UnitFace {
    /// Returns true if a query matches the tag of the face.
    pub(crate) fn is_tagged(&self, query: &str) -> bool {
        self.provenance.tag().is_some_and(|tag| matches(query, tag))
    }

    fn of(mesh: &Mesh, number: usize) -> Self {
        let face = mesh.face(number);
        let mut corners = [0; 4];
        for (corner, point) in corners.iter_mut().zip(face.outline()) {
            *corner = number_of(point);
        }
        let [origin, next, _, last] = corners.each(solid::corner);
        let [x, y] = [next - origin, last - origin];
        let outwards = x.cross(y);
        let along = |direction: DVec3| {
            let axis = [Axis::X, Axis::Y, Axis::Z].into_iter().find(|axis| direction[axis.index()] != 0.0);
            (axis.unwrap_or(Axis::X), direction.element_sum())
        };
        let side = BoxSide::ALL.into_iter().find(|side| side.normal() == outwards).unwrap_or(BoxSide::Front);
        let provenance = Provenance::of(mesh, face.tag()).unwrap_or_default();
        UnitFace { side, corners, origin, along: [x, y, outwards].each(along), provenance }
    }

    /// The axes of the face in a scope with the axes `scope`: x along the first edge, z outwards.
    #[inline]
    pub(crate) fn axes(&self, scope: &DMat3) -> DMat3 {
        let columns = [scope.x_axis, scope.y_axis, scope.z_axis];
        let [x, y, z] = self.along.each(|(axis, sign)| columns[axis.index()] * sign);
        DMat3::from_cols(x, y, z)
    }

    /// The lengths along the first edge and across it, in a scope of that size.
    #[inline]
    pub(crate) fn extent(&self, size: DVec3) -> [f64; 2] {
        let sizes = [size.x, size.y, size.z];
        [self.along[0], self.along[1]].each(|(axis, _)| sizes[axis.index()])
    }
}

/// The number of a corner of the unit box.
fn number_of(point: DVec3) -> u8 {
    point.cmpgt(DVec3::splat(0.5)).bitmask() as u8
}

/// The mesh with its box stretched to length 1; a flat axis is at 0.
fn stretched(mesh: &Mesh) -> Mesh {
    let bounds = mesh.bounds();
    let middle = (bounds.low + bounds.high) * 0.5;
    let at = |point: &DVec3| DVec3::select(point.cmpgt(middle), DVec3::ONE, DVec3::ZERO);
    mesh.with_points(mesh.points().iter().map(at).collect())
}

/// The properties that distinguish unit meshes.
fn key(mesh: &Mesh) -> Vec<u32> {
    let points = mesh.points().iter().map(|&point| u32::from(number_of(point)));
    let faces = mesh.faces().map(|face| Provenance::of(mesh, face.tag()).unwrap_or_default().number() as u32);
    points.chain(mesh.corners().iter().copied()).chain(faces).collect()
}

impl PartialEq for UnitMesh {
    fn eq(&self, other: &Self) -> bool {
        // Inserted units share the mesh of the plain one.
        Arc::ptr_eq(&self.0.mesh, &other.0.mesh)
    }
}

impl std::fmt::Debug for UnitMesh {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let faces = self.faces().iter().map(|face| face.corners);
        f.debug_list().entries(faces).finish()
    }
}
