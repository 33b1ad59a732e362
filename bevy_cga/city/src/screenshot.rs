//! A picture without a window.

#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};
use std::time::Duration;

use bevy::app::ScheduleRunnerPlugin;
use bevy::camera::RenderTarget;
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::render_resource::TextureFormat;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured};
use bevy::window::ExitCondition;
use bevy::winit::WinitPlugin;
use bevy_cga::{Cga, CgaRun};

use crate::pick::Picked;
use crate::scene::Building;

const WIDTH: u32 = 960;
const HEIGHT: u32 = 540;
/// The building that is picked and changed; in other districts, the one with the nearest number.
const CHANGED: usize = 144;

/// The path of the picture, and the image that the camera fills.
#[derive(Resource)]
struct Order {
    path: PathBuf,
    target: Handle<Image>,
    step: Step,
}

#[derive(Clone, Copy, PartialEq)]
enum Step {
    /// Runs have not begun.
    Start,
    /// The first models are on their way.
    Models,
    /// A building has been changed.
    Change,
    /// Frames until the renderer has everything.
    Wait(u32),
    /// The picture is on its way, or the program ends without one.
    End,
}

/// Adds Bevy's plugins without a window, and the systems that take the picture.
pub(crate) fn add(app: &mut App, path: PathBuf) {
    let plugins = DefaultPlugins
        .set(WindowPlugin { primary_window: None, exit_condition: ExitCondition::DontExit, ..WindowPlugin::default() })
        // Otherwise the first frames are empty: shaders are still being compiled.
        .set(RenderPlugin { synchronous_pipeline_compilation: true, ..RenderPlugin::default() })
        .disable::<WinitPlugin>();
    app.add_plugins((plugins, ScheduleRunnerPlugin::run_loop(Duration::ZERO)));
    let image = Image::new_target_texture(WIDTH, HEIGHT, TextureFormat::Rgba8UnormSrgb, None);
    let target = app.world_mut().resource_mut::<Assets<Image>>().add(image);
    app.insert_resource(Order { path, target, step: Step::Start });
    app.add_systems(PostStartup, aim).add_systems(Update, take);
}

/// Points the camera at the image. It rests until the models are there.
fn aim(order: Res<Order>, camera: Single<(Entity, &mut Camera)>, mut commands: Commands) {
    let (entity, mut camera) = camera.into_inner();
    camera.is_active = false;
    commands.entity(entity).insert(RenderTarget::Image(order.target.clone().into()));
}

/// Waits for the models, changes a building, waits for its model, takes the picture and ends the program.
fn take(
    mut order: ResMut<Order>,
    runs: Query<(), With<CgaRun>>,
    mut buildings: Query<(Entity, &mut Cga, &Building)>,
    mut picked: ResMut<Picked>,
    mut camera: Single<&mut Camera>,
    mut exit: MessageWriter<AppExit>,
    mut commands: Commands,
) {
    const FRAMES: u32 = 3;
    order.step = match order.step {
        Step::Start => Step::Models,
        Step::Models | Step::Change if !runs.is_empty() => order.step,
        Step::Models => {
            let nearest = buildings.iter_mut().min_by_key(|(.., number)| (number.0.abs_diff(CHANGED), number.0));
            let Some((entity, mut cga, _)) = nearest else {
                error!("no picture: the district has no buildings");
                exit.write(AppExit::error());
                order.step = Step::End;
                return;
            };
            for (name, value) in
                [("storeys", 6.0.into()), ("wall", cga::Value::from("#b5533c")), ("shops", true.into())]
            {
                if let Err(error) = cga.grammar.set(name, value) {
                    error!("{error}");
                }
            }
            *picked = Picked { building: Some(entity), rule: None };
            Step::Change
        }
        Step::Change => {
            camera.is_active = true;
            Step::Wait(FRAMES)
        }
        Step::Wait(0) => {
            let shot = Screenshot::image(order.target.clone());
            let path = order.path.clone();
            let end = move |shot: On<ScreenshotCaptured>, mut exit: MessageWriter<AppExit>| {
                let saved = save(&shot.image, &path);
                exit.write(saved.map_or_else(
                    |why| {
                        error!("no picture: {why}");
                        AppExit::error()
                    },
                    |()| AppExit::Success,
                ));
            };
            commands.spawn(shot).observe(end);
            Step::End
        }
        Step::Wait(frames) => Step::Wait(frames - 1),
        Step::End => Step::End,
    };
}

/// Writes an image with a palette, in a third of the bytes.
fn save(image: &Image, path: &Path) -> Result {
    let UVec2 { x: width, y: height } = image.size();
    let rgba = image.data.clone().ok_or("the image has no pixels")?;
    let image = cga::sink::picture::Image { width: width as usize, height: height as usize, rgba };
    Ok(image.write_indexed_png(path)?)
}
