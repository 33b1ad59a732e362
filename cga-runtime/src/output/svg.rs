//! Flat vector pictures, for documents.
//!
//! The projection is parallel. Faces are polygons shaded by their direction to the light, farther ones first. Faces
//! that pass through each other are not cut. Equal models give equal text. Textures are not drawn: faces have their
//! material's colour.

use std::convert::Infallible;
use std::fmt::Write as _;
use std::io;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use cga_picture::{Viewport, direction};
use glam::{DAffine3, DVec3};

use super::error::WriteError;
use super::flatten::{corner_point, unit};
use super::number_text::Short;
use super::order;
use super::picture::Viewpoint;
use super::sink_table::SinkTable;
use super::whole_file;
use crate::geometry::mesh::Mesh;
use crate::geometry::mesh::map::normal_map;
use crate::material::Material;
use crate::output::model::Model;
use crate::run::sink::{Cuboid, Flow, Leaf, Quad, Sink};

/// The size of text, in bytes, from which it is written out.
const MUCH: usize = 1 << 15;

/// The settings of a vector picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Svg {
    /// The width in user units, which most programs take as pixels.
    pub width: usize,
    /// The height in user units.
    pub height: usize,
    /// The viewpoint; only the direction of a perspective camera counts.
    pub view: Viewpoint,
    /// The azimuth of the light in degrees around the model, relative to the camera.
    pub light_azimuth: f64,
    /// The elevation of the light, in degrees.
    pub light_elevation: f64,
    /// The width of the lines, in user units; 0 for no lines.
    pub line_width: f64,
    /// The colour of the lines, in SVG notation. Quotes, angle brackets and `&` are escaped.
    pub line_color: String,
    /// The colour of the background, in SVG notation; empty for none. Quotes, angle brackets and `&` are escaped.
    pub background: String,
}

/// A face in the picture.
struct Shown {
    face: order::DepthFace,
    /// Outline and holes, in user units, with their depth.
    rings: Vec<Vec<DVec3>>,
    material: u32,
    /// The share of light that it reflects, 0 to 1.
    light: f64,
}

impl Svg {
    /// A picture of that size, with default settings.
    pub fn new(width: usize, height: usize) -> Self {
        Svg {
            width,
            height,
            view: Viewpoint::default(),
            light_azimuth: -55.0,
            light_elevation: 50.0,
            line_width: 0.6,
            line_color: String::from("#2b3038"),
            background: String::new(),
        }
    }

    /// The picture of a model as SVG text.
    pub fn render(&self, model: &Model) -> String {
        let Ok(text) = self.draw(model, |_| Ok::<(), Infallible>(()));
        text
    }

    /// Writes the text of [`Svg::render`] to `out`, in blocks, and flushes `out`.
    ///
    /// # Errors
    /// [`WriteError::Io`] with an error of `out`.
    pub fn render_to(&self, model: &Model, mut out: impl io::Write) -> Result<(), WriteError> {
        let rest = self.draw(model, |text| {
            if MUCH <= text.len() {
                out.write_all(text.as_bytes())?;
                text.clear();
            }
            io::Result::Ok(())
        })?;
        out.write_all(rest.as_bytes())?;
        Ok(out.flush()?)
    }

    /// Draws a model as text. After each face, `each` may take the text so far. Returns the rest.
    fn draw<E>(&self, model: &Model, mut each: impl FnMut(&mut String) -> Result<(), E>) -> Result<String, E> {
        let camera = self.view.camera(model.bounds()).orthographic();
        let mut faces = VisibleFaces {
            view: Viewport::new(&camera, self.width, self.height),
            light: direction(camera.azimuth + self.light_azimuth, self.light_elevation),
            table: SinkTable::new(),
            shown: Vec::new(),
        };
        let _ = model.replay(&mut faces);
        let order = order::back_to_front(&faces.shown.iter().map(|shown| &shown.face).collect::<Vec<_>>());
        let (w, h) = (self.width, self.height);
        let mut svg = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {w} {h}\">\n");
        if !self.background.is_empty() {
            let _ = writeln!(svg, "<rect width=\"{w}\" height=\"{h}\" fill=\"{}\"/>", escaped(&self.background));
        }
        let _ = match 0.0 < self.line_width {
            true => writeln!(
                svg,
                "<g stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\" fill-rule=\"evenodd\">",
                escaped(&self.line_color),
                self.line_width
            ),
            false => writeln!(svg, "<g fill-rule=\"evenodd\">"),
        };
        for index in order {
            let shown = &faces.shown[index];
            write_face(&mut svg, shown, &faces.table.materials()[shown.material as usize]);
            each(&mut svg)?;
        }
        svg.push_str("</g>\n</svg>\n");
        Ok(svg)
    }
}

/// A text inside the quotes of an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn write_face(svg: &mut String, shown: &Shown, material: &Material) {
    let color = material.color();
    let byte = |channel: f64| libm::round(channel * shown.light * 255.0).clamp(0.0, 255.0) as u8;
    svg.push_str("<path d=\"");
    for ring in &shown.rings {
        for (i, point) in ring.iter().enumerate() {
            svg.push(if i == 0 { 'M' } else { 'L' });
            let _ = write!(svg, "{} {}", tenths(point.x), tenths(point.y));
        }
        svg.push('Z');
    }
    let _ = write!(svg, "\" fill=\"#{:02x}{:02x}{:02x}\"", byte(color.r), byte(color.g), byte(color.b));
    let opacity = material.opacity();
    if opacity < 1.0 {
        let _ = write!(svg, " fill-opacity=\"{}\"", Short(libm::round(opacity.max(0.0) * 100.0) / 100.0));
    }
    svg.push_str("/>\n");
}

/// A number with at most one decimal digit.
fn tenths(value: f64) -> Short<f64> {
    Short(libm::round(value * 10.0) / 10.0)
}

/// Collects the visible faces.
struct VisibleFaces {
    view: Viewport,
    light: DVec3,
    table: SinkTable,
    shown: Vec<Shown>,
}

impl VisibleFaces {
    /// Adds a face. If `solid`, only its outside can be visible.
    fn add(&mut self, rings: Vec<Vec<DVec3>>, normal: DVec3, material: u32, solid: bool) {
        let finite = rings.iter().flatten().all(|p| p.is_finite());
        let Some(&first) = rings.first().and_then(|ring| ring.first()) else { return };
        let front = self.view.faces(first, normal);
        let edge_on = self.view.forward().dot(normal).abs() < 1e-6;
        if !finite || edge_on || (solid && !front) {
            return;
        }
        let normal = if front { normal } else { -normal };
        let light = 0.64 + 0.08 * normal.y + 0.34 * normal.dot(self.light).max(0.0);
        let project = |ring: &Vec<DVec3>| ring.iter().map(|&p| DVec3::from_array(self.view.project(p))).collect();
        let rings: Vec<Vec<DVec3>> = rings.iter().map(project).collect();
        self.shown.push(Shown { face: order::DepthFace::new(&rings[0]), rings, material, light });
    }

    fn rectangle(&mut self, quad: &Quad, material: u32, solid: bool) {
        self.add(vec![quad.corners().to_vec()], unit(quad.u.cross(quad.v)), material, solid);
    }
}

impl Sink for VisibleFaces {
    fn quad(&mut self, leaf: &Leaf<'_>, quad: &Quad) -> Flow {
        let material = self.table.material(leaf.material);
        self.rectangle(quad, material, false);
        ControlFlow::Continue(())
    }

    fn cuboid(&mut self, leaf: &Leaf<'_>, cuboid: &Cuboid) -> Flow {
        let material = self.table.material(leaf.material);
        // A box that is inside out shows its far sides, from within.
        cuboid.faces().iter().for_each(|face| self.rectangle(face, material, 0.0 < cuboid.sides.determinant()));
        ControlFlow::Continue(())
    }

    fn mesh(&mut self, leaf: &Leaf<'_>, mesh: &Arc<Mesh>, placement: &DAffine3) -> Flow {
        let material = self.table.material(leaf.material);
        let turn = normal_map(&placement.matrix3);
        let solid = mesh.is_closed() && 0.0 < placement.matrix3.determinant();
        for face in mesh.faces() {
            let place = |corner| placement.transform_point3(corner_point(mesh, corner));
            let rings = face.loop_ranges().map(|range| range.map(place).collect()).collect();
            let shown = self.table.face_material(material, mesh.material_list(), face.tag().material);
            self.add(rings, unit(turn * face.area_vector()), shown, solid);
        }
        ControlFlow::Continue(())
    }
}

impl Model {
    /// The model as SVG text, in the default view.
    pub fn to_svg(&self, width: usize, height: usize) -> String {
        Svg::new(width, height).render(self)
    }

    /// Writes the model as an SVG file of 800 by 600 in the default view; see [`Svg`] for others.
    ///
    /// # Errors
    /// Errors of the file system.
    pub fn write_svg(&self, path: impl AsRef<Path>) -> Result<(), WriteError> {
        whole_file::write_with(path.as_ref(), |out| self.write_svg_to(out))
    }

    /// Writes the text of the file of [`Model::write_svg`] to `out`.
    ///
    /// # Errors
    /// As [`Svg::render_to`].
    pub fn write_svg_to(&self, out: impl io::Write) -> Result<(), WriteError> {
        Svg::new(800, 600).render_to(self, out)
    }
}
