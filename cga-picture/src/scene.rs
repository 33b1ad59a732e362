//! Triangles with paints, ready to be drawn.

use std::collections::HashMap;

use cga_geometry::each::Each;
use cga_geometry::mesh::Bounds;
use glam::{DVec2, DVec3, Vec3};

use crate::bitmap::Bitmap;
use crate::face::Face;
use crate::paint::{ImageId, Paint, PaintId};
use crate::texture::{Encoding, Texture};

/// A triangle, its coordinates relative to [`Scene::centre`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Triangle {
    corners: [Vec3; 3],
    normal: Vec3,
    /// The index in [`Scene::paints`].
    pub(crate) paint: u32,
    /// The plane, equal for all triangles in one plane.
    pub(crate) plane: u32,
    /// The number of its leaf.
    pub(crate) leaf: u32,
    /// The number of its face in the scene.
    pub(crate) face: u32,
    /// The index in the scene's smooth normals; [`FLAT`] for flat triangles.
    smooth: u32,
    /// The index in [`Scene::uvs`]; [`PLAIN`] without texture coordinates.
    pub(crate) uvs: u32,
}

const FLAT: u32 = u32::MAX;

/// The mark of a triangle without texture coordinates.
pub(crate) const PLAIN: u32 = u32::MAX;

/// The places of a triangle's corners in an image, moved near 0, as an image repeats.
pub(crate) type CornerUvs = [[f32; 2]; 3];

/// The triangles, paints and images of a picture.
#[derive(Debug)]
pub struct Scene {
    pub(crate) bounds: Bounds,
    pub(crate) centre: DVec3,
    pub(crate) triangles: Vec<Triangle>,
    pub(crate) paints: Vec<Paint>,
    /// The places of triangles' corners in the images for colour, for opacity and for normals.
    pub(crate) uvs: Vec<[Option<CornerUvs>; 3]>,
    /// True if facets may represent round surfaces.
    pub(crate) round: bool,
    textures: Vec<Texture>,
    smooth: Vec<[Vec3; 3]>,
    /// The number of faces that were added.
    faces: u32,
    /// Only for look-ups, never iterated.
    planes: HashMap<[i64; 4], u32>,
    /// Coordinates closer than this belong to one plane.
    grain: f64,
}

impl Triangle {
    #[inline]
    pub(crate) fn corners(&self) -> [DVec3; 3] {
        self.corners.each(|corner| corner.as_dvec3())
    }

    #[inline]
    pub(crate) fn normal(&self) -> DVec3 {
        self.normal.as_dvec3()
    }
}

impl Scene {
    /// An empty scene. `bounds` is the box around the faces that it will get: it decides the default camera, the height of
    /// the ground, and the region that casts shadows.
    pub fn new(bounds: Bounds) -> Self {
        let finite = bounds.low.is_finite() && bounds.high.is_finite();
        Scene {
            bounds,
            centre: if finite { (bounds.low + bounds.high) * 0.5 } else { DVec3::ZERO },
            triangles: Vec::new(),
            paints: Vec::new(),
            uvs: Vec::new(),
            round: false,
            textures: Vec::new(),
            smooth: Vec::new(),
            faces: 0,
            planes: HashMap::new(),
            grain: if finite { (bounds.size().length() * 1e-5).max(1e-9) } else { 1e-3 },
        }
    }

    /// Adds an image for paints. An image without pixels is white.
    pub fn add_image(&mut self, image: Bitmap) -> ImageId {
        self.add_texture(image, [255; 4], Encoding::Srgb)
    }

    /// Adds a normal map for paints, encoded as in glTF: red, green and blue are the parts of the normal along u, along v and outwards,
    /// from −1 to 1. An image without pixels is flat.
    pub fn add_normal_map(&mut self, image: Bitmap) -> ImageId {
        self.add_texture(image, [128, 128, 255, 255], Encoding::Linear)
    }

    fn add_texture(&mut self, image: Bitmap, plain: [u8; 4], encoding: Encoding) -> ImageId {
        let is_empty = image.width == 0 || image.height == 0;
        self.textures.push(Texture::new(if is_empty { Bitmap::filled(1, 1, plain) } else { image }, encoding));
        ImageId((self.textures.len() - 1) as u32)
    }

    /// Adds a paint for faces. Its images must be images of this scene; unknown ones are ignored.
    pub fn add_paint(&mut self, paint: Paint) -> PaintId {
        let is_known = |image: ImageId| (image.0 as usize) < self.textures.len();
        self.paints.push(Paint {
            color_image: paint.color_image.filter(|image| is_known(*image)),
            opacity_image: paint.opacity_image.filter(|(image, _)| is_known(*image)),
            normal_image: paint.normal_image.filter(|image| is_known(*image)),
            ..paint
        });
        PaintId((self.paints.len() - 1) as u32)
    }

    /// Adds a triangle whose corners are counter-clockwise as seen from its front.
    pub fn add_triangle(&mut self, corners: [DVec3; 3], paint: PaintId) {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).normalize_or(DVec3::Y);
        self.add_face(&Face::new(&corners, &[[0, 1, 2]], normal, paint));
    }

    /// Adds a face. Triangles that are not finite as 32-bit floats are not drawn; then the others have neither texture
    /// coordinates nor smooth normals. A face with an unknown paint is not drawn.
    pub fn add_face(&mut self, face: &Face<'_>) {
        let &Face { corners, triangles, normal, paint: PaintId(paint), leaf, round, .. } = face;
        let Some(&Paint { color_image, opacity_image, normal_image, .. }) = self.paints.get(paint as usize) else {
            return;
        };
        self.round |= round;
        let (Some(&point), first) = (corners.first(), self.triangles.len()) else { return };
        let plane = self.plane(point - self.centre, normal);
        let flat = normal.as_vec3();
        let number = self.faces;
        self.faces = self.faces.wrapping_add(1);
        for triangle in triangles {
            let exact = triangle.each(|i| corners.get(i as usize).map_or(DVec3::NAN, |p| p - self.centre));
            let corners = exact.each(|corner| corner.as_vec3());
            // Coordinates that are not finite cannot be drawn.
            if corners.iter().all(|corner| corner.is_finite()) {
                let normal = own_normal(&exact, normal).as_vec3();
                self.triangles.push(Triangle {
                    corners,
                    normal,
                    paint,
                    plane,
                    leaf,
                    face: number,
                    smooth: FLAT,
                    uvs: PLAIN,
                });
            }
        }
        let added = &mut self.triangles[first..];
        if added.len() != triangles.len() {
            return;
        }
        if let Some(normals) = face.normals {
            for (triangle, corners) in added.iter_mut().zip(triangles) {
                triangle.smooth = self.smooth.len() as u32;
                self.smooth.push(corners.each(|i| normals.get(i as usize).map_or(flat, |normal| normal.as_vec3())));
            }
        }
        let uvs =
            [color_image.and(face.color_uvs), opacity_image.and(face.opacity_uvs), normal_image.and(face.normal_uvs)];
        if uvs.iter().any(Option::is_some) {
            for (triangle, corners) in added.iter_mut().zip(triangles) {
                triangle.uvs = self.uvs.len() as u32;
                self.uvs.push(uvs.each(|uvs| uvs.map(|uvs| corner_uvs(uvs, *corners))));
            }
        }
    }

    /// The normal at a point of a triangle, in the scene's coordinates. Smooth normals are interpolated.
    pub(crate) fn normal_at(&self, triangle: &Triangle, point: DVec3) -> DVec3 {
        if triangle.smooth == FLAT {
            return triangle.normal();
        }
        let [a, b, c] = triangle.corners();
        let n = triangle.normal();
        let area = (b - a).cross(c - a).dot(n);
        let u = (c - b).cross(point - b).dot(n) / area;
        let v = (a - c).cross(point - c).dot(n) / area;
        let [na, nb, nc] = self.smooth[triangle.smooth as usize].each(|normal| normal.as_dvec3());
        (na * u + nb * v + nc * (1.0 - u - v)).normalize_or(n)
    }

    /// An image of the scene.
    #[inline]
    pub(crate) fn texture(&self, ImageId(image): ImageId) -> &Texture {
        &self.textures[image as usize]
    }

    /// The number of the plane through a point.
    fn plane(&mut self, point: DVec3, normal: DVec3) -> u32 {
        let key = normal * 512.0;
        let at = point.dot(normal) / self.grain;
        let key = [key.x, key.y, key.z, at].each(|c| libm::floor(c + 0.5) as i64);
        let next = self.planes.len() as u32;
        *self.planes.entry(key).or_insert(next)
    }
}

/// The places of a triangle's corners in an image. A missing place is (0, 0).
fn corner_uvs(uvs: &[DVec2], corners: [u32; 3]) -> CornerUvs {
    let places = corners.each(|corner| uvs.get(corner as usize).copied().unwrap_or_default());
    let near = places[0].floor();
    places.each(|place| (place - near).as_vec2().to_array())
}

/// The normal of a triangle of a face. A face that is bent has no normal for all of its triangles: light would come from the wrong side.
fn own_normal([a, b, c]: &[DVec3; 3], face: DVec3) -> DVec3 {
    /// The cosine of the angle up to which a face is flat: 2.6 degrees.
    const FLAT: f64 = 0.999;
    let own = (*b - *a).cross(*c - *a).normalize_or(face);
    if own.dot(face) < FLAT { own } else { face }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_of_bent_faces_have_their_own_normals() {
        let square = |height: f64| {
            let corners = [[0.0, 0.0, 0.0], [0.0, height, 1.0], [1.0, 0.0, 1.0], [1.0, height, 0.0]].map(DVec3::from);
            let mut scene = Scene::new(Bounds { low: DVec3::ZERO, high: DVec3::ONE });
            let paint = scene.add_paint(Paint::default());
            scene.add_face(&Face::new(&corners, &[[0, 1, 2], [0, 2, 3]], DVec3::Y, paint));
            let [one, other] = [0, 1].map(|triangle| scene.triangles[triangle].normal());
            (one, other, scene.triangles[0].plane == scene.triangles[1].plane)
        };
        let (one, other, is_one_plane) = square(2.0);
        assert!(one.dot(other) < 0.0 && is_one_plane, "{one} {other}");
        // Rounding does not bend a face.
        assert_eq!(square(1e-3), (DVec3::Y, DVec3::Y, true));
    }
}
