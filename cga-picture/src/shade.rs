//! Colours from light and surface.

use cga_geometry::each::Each;
use glam::{DVec3, Vec3};

use crate::light::{Light, surface};
use crate::paint::Paint;
use crate::scene::Scene;
use crate::style::Style;
use crate::viewport::Viewport;
use crate::visible::{GROUND, SKY, VisibilityBuffer};

/// The data that colours depend on.
pub(crate) struct Shader<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) view: &'a Viewport,
    pub(crate) style: &'a Style,
    /// The direction to the sun.
    pub(crate) sun: DVec3,
    /// The radius of the scene, seen from above.
    pub(crate) radius: f64,
    pub(crate) ground: f64,
}

pub(crate) fn mix(a: Vec3, b: Vec3, share: f32) -> Vec3 {
    a + (b - a) * share
}

fn smooth(low: f64, high: f64, value: f64) -> f32 {
    let t = ((value - low) / (high - low)).clamp(0.0, 1.0);
    (t * t * (3.0 - 2.0 * t)) as f32
}

/// Skylight with darker corners, which makes small details visible.
fn deepened(sky: f32) -> f32 {
    0.05 + 0.95 * sky * (0.55 + 0.45 * sky)
}

impl Shader<'_> {
    /// The backdrop at a height in the picture, 0 at the top and 1 at the bottom.
    pub(crate) fn backdrop(&self, down: f64) -> Vec3 {
        let [top, bottom] = self.style.backdrop.each(Vec3::from);
        mix(top, bottom, smooth(0.0, 0.85, down))
    }

    /// The colour of a sample of the opaque layer.
    pub(crate) fn opaque(&self, layer: &VisibilityBuffer, light: &Light, sample: usize) -> Vec3 {
        let down = (sample / layer.width) as f64 / layer.height as f64;
        let backdrop = self.backdrop(down);
        let Some((point, normal)) = surface(self.scene, layer, self.view, sample) else { return backdrop };
        match layer.seen[sample] {
            SKY => backdrop,
            GROUND => self.ground(backdrop, point, light.sun[sample], light.sky[sample]),
            seen => {
                let triangle = &self.scene.triangles[seen as usize];
                let surface = (point, normal);
                let (paint, normal) = self.scene.look_at(triangle, self.view, layer.place(sample), surface);
                self.lit(&paint, point, normal, light.sun[sample], light.sky[sample])
            }
        }
    }

    /// The colour of a sample of the transparent layer over the colour behind it.
    pub(crate) fn clear(&self, layer: &VisibilityBuffer, light: &Light, sample: usize, behind: Vec3) -> Vec3 {
        let Some((point, normal)) = surface(self.scene, layer, self.view, sample) else { return behind };
        let Some(triangle) = self.scene.triangles.get(layer.seen[sample] as usize) else { return behind };
        let (paint, normal) = self.scene.look_at(triangle, self.view, layer.place(sample), (point, normal));
        // Glass takes the shadows of the surface behind it: a good approximation, and hardly visible.
        let lit = self.lit(&paint, point, normal, light.sun[sample], light.sky[sample]);
        if paint.opacity_image.is_some() {
            return mix(behind, lit, paint.opacity);
        }
        let glossy = Paint { gloss: paint.gloss.max(0.9), ..paint };
        let (mirror, share) = self.reflection(&glossy, point, normal);
        mix(mix(behind, lit, paint.opacity), mirror, share * (1.0 - paint.opacity))
    }

    /// The colour of the ground: the backdrop, darker where less light falls. It has no edge and no horizon.
    fn ground(&self, backdrop: Vec3, point: DVec3, sun: f32, sky: f32) -> Vec3 {
        let style = self.style;
        let slope = self.sun.y as f32;
        let [sunlight, skylight] = [style.sun, style.sky].each(Vec3::from);
        let shade = (sunlight * slope * sun + skylight * deepened(sky)) / (sunlight * slope + skylight);
        let flat = DVec3::new(point.x, 0.0, point.z).length();
        let far = smooth(2.5 * self.radius, 9.0 * self.radius, flat);
        mix(style.ground.into(), backdrop, 0.25 + 0.75 * far) * mix(shade, Vec3::ONE, far)
    }

    fn lit(&self, paint: &Paint, point: DVec3, normal: DVec3, sun: f32, sky: f32) -> Vec3 {
        let style = self.style;
        let sun_share = normal.dot(self.sun).max(0.0) as f32 * sun;
        let up = (0.5 + 0.5 * normal.y) as f32;
        // The lower half of the surroundings is ground, lit by the sun. Its share is larger close to the ground.
        let height = (point.y - self.ground).max(0.0) / self.radius.max(1e-9);
        let bounce = (1.0 - up) * (1.0 - 0.35 * smooth(0.0, 2.0, height));
        let open = deepened(sky);
        // White surroundings brighten each other's shade, and brighter surfaces more so.
        let brighter = open + (1.0 - open) * 0.35 * paint.color * open;
        let [sunlight, skylight, bounced] = [style.sun, style.sky, style.bounce].each(Vec3::from);
        let arriving = sunlight * sun_share + skylight * up * brighter + bounced * bounce * brighter;
        let diffuse = paint.color * arriving * style.albedo * (1.0 - paint.metallic);
        let (mirror, share) = self.reflection(paint, point, normal);
        if share == 0.0 {
            return diffuse;
        }
        diffuse + mirror * mix(Vec3::ONE, paint.color, paint.metallic) * (share * (0.35 + 0.65 * sky))
    }

    /// The mirrored colour of a surface and its share.
    fn reflection(&self, paint: &Paint, point: DVec3, normal: DVec3) -> (Vec3, f32) {
        if paint.gloss == 0.0 && paint.metallic == 0.0 {
            return (Vec3::ZERO, 0.0);
        }
        let look = (point - self.view.eye).normalize();
        let facing = (-look.dot(normal)).clamp(0.0, 1.0) as f32;
        let base = 0.04 + 0.86 * paint.metallic;
        let grazing = (1.0 - facing) * (1.0 - facing);
        let fresnel = base + (1.0 - base) * grazing * grazing * (1.0 - facing);
        let out = look - normal * (2.0 * look.dot(normal));
        let [top, bottom] = self.style.backdrop.each(Vec3::from);
        let mirror = match out.y {
            y if 0.0 <= y => mix(bottom, top, smooth(0.0, 0.6, y)),
            y => mix(bottom, self.style.ground.into(), smooth(0.0, 0.15, -y) * 0.7),
        };
        (mirror, fresnel * paint.gloss.max(0.3 * paint.metallic))
    }
}

/// Compresses bright linear light, so that bright surfaces keep their colour.
pub(crate) fn display(color: Vec3) -> Vec3 {
    color.map(|c| {
        let knee = 0.8;
        if c <= knee { c } else { knee + (1.0 - knee) * (1.0 - libm::expf((knee - c) / (1.0 - knee))) }
    })
}
