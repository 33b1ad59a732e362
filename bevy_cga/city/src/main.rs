//! A district: fly through it, pick a building, change its attributes.
//!
//! `cargo run -p city` opens a window, `cargo run -p city -- --screenshot city.png` writes a picture without one.

mod detail;
mod lots;
#[path = "../../../examples/materials/mod.rs"]
mod materials;
mod panel;
mod pick;
mod rules;
mod scene;
mod screenshot;
#[cfg(test)]
mod tests;

use std::path::PathBuf;

use bevy::camera_controller::free_camera::FreeCameraPlugin;
use bevy::prelude::*;
use bevy_cga::CgaPlugin;

fn main() -> AppExit {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let mut app = App::new();
    rules::add_images(&mut app);
    match arguments[..] {
        [] => {
            let window = Window { title: "city".into(), ..Window::default() };
            app.add_plugins(
                DefaultPlugins.set(WindowPlugin { primary_window: Some(window), ..WindowPlugin::default() }),
            );
            app.add_plugins(FreeCameraPlugin).add_systems(Update, pick::pick);
        }
        ["--screenshot", path] => screenshot::add(&mut app, PathBuf::from(path)),
        _ => {
            eprintln!("usage: city [--screenshot file.png]");
            return AppExit::error();
        }
    }
    app.add_plugins(CgaPlugin::default()).add_observer(detail::fade);
    app.add_systems(Startup, (scene::light, scene::camera, scene::district).chain());
    add_panel(&mut app);
    app.run()
}

/// Adds the panel and the pin of the picked building.
fn add_panel(app: &mut App) {
    app.init_resource::<pick::Picked>();
    app.add_systems(Startup, (panel::add, pick::add_pin));
    app.add_systems(Update, (panel::keys, panel::compute_values, panel::refresh, pick::mark).chain().after(pick::pick));
}
