//! A scene: rules, the shapes that they start with, and the view of its picture.

use cga::{Error, Flow, Grammar, Model, Settings, Shape};

use super::materials;

/// Rules and what they are run on. Nothing is read from disk. A scene without compiled rules is a `Scene<()>`.
pub struct Scene<G = Box<dyn Grammar + Send + Sync>> {
    /// The name of its picture and of its file.
    pub name: &'static str,
    pub title: &'static str,
    /// A sentence about the scene and its rules.
    pub sentence: &'static str,
    /// The text of the grammar.
    pub rules: String,
    pub grammar: G,
    pub shapes: Vec<Start>,
    pub view: View,
}

/// An initial shape and the rule that it starts with.
pub struct Start {
    pub rule: &'static str,
    pub shape: Shape,
}

/// The camera and the sun of a scene, in degrees and metres.
#[derive(Clone, Copy)]
pub struct View {
    /// The azimuth of the camera around the scene: 0 in front (+z), 90 to the right (+x).
    pub azimuth: f64,
    pub elevation: f64,
    /// The vertical field of view.
    pub field_of_view: f64,
    /// The azimuth of the sun relative to the camera: negative to the left of the viewer.
    pub sun_azimuth: f64,
    pub sun_elevation: f64,
    /// The lowest and the highest corner of the region that must be in the picture. `None` is the whole scene.
    pub region: Option<[[f64; 3]; 2]>,
    /// The width and height of the picture in pixels.
    pub size: [usize; 2],
}

impl Default for View {
    fn default() -> Self {
        View {
            azimuth: 32.0,
            elevation: 18.0,
            field_of_view: 26.0,
            sun_azimuth: -62.0,
            sun_elevation: 42.0,
            region: None,
            size: [1200, 800],
        }
    }
}

impl Scene<()> {
    /// The scene with compiled rules.
    pub fn with(self, grammar: Box<dyn Grammar + Send + Sync>) -> Scene {
        let Scene { name, title, sentence, rules, grammar: (), shapes, view } = self;
        Scene { name, title, sentence, rules, grammar, shapes, view }
    }
}

impl Scene {
    /// The result of the rules for all shapes. Each image of the materials is one pixel.
    ///
    /// # Errors
    /// The first error of a run.
    pub fn model(&self) -> Result<Model, Error> {
        self.model_with(&Settings { assets: materials::single_pixels(), ..Settings::default() })
    }

    /// The result of the rules for all shapes, with those settings.
    ///
    /// # Errors
    /// The first error of a run.
    pub fn model_with(&self, settings: &Settings) -> Result<Model, Error> {
        let lots: Vec<Shape> = self.shapes.iter().map(|start| start.shape.clone().start(start.rule)).collect();
        let mut model = Model::new().with_assets(settings.assets.clone());
        cga::Scene::new(&*self.grammar, &lots)
            .generate_each(settings, |_, one| {
                model.append(&one);
                Flow::Continue(())
            })
            .map_err(|error| error.error)?;
        Ok(model)
    }
}

impl Start {
    pub fn new(rule: &'static str, shape: Shape) -> Self {
        Start { rule, shape }
    }
}

/// The text of the grammar in a source file, without the indentation inside `cga!`.
pub fn grammar_text(source: &str) -> String {
    let (_, rest) = source.split_once("cga! {\n").unwrap_or(("", source));
    let (rules, _) = rest.split_once("\n}\n").unwrap_or((rest, ""));
    let lines = rules.lines().map(|line| line.strip_prefix("    ").unwrap_or(line));
    lines.collect::<Vec<_>>().join("\n")
}
