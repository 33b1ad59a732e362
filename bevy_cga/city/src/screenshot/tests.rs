//! The steps before the picture, without a renderer.

use bevy::prelude::*;
use bevy_cga::Cga;
use cga::Shape;

use super::{Order, Step, take};
use crate::pick::Picked;
use crate::rules::House;
use crate::scene::Building;

/// An app that has chosen one of the buildings with these numbers, or ends.
fn chosen(numbers: &[usize]) -> App {
    let mut app = App::new();
    app.init_resource::<Picked>().add_systems(Update, take);
    app.insert_resource(Order { path: "unused.png".into(), target: Handle::default(), step: Step::Start });
    app.world_mut().spawn(Camera::default());
    for &number in numbers {
        app.world_mut().spawn((Cga::new(House::default(), Shape::rectangle(14.0, 12.0)), Building(number)));
    }
    app.update();
    app.update();
    app
}

/// The number of the picked building, whose grammar has been changed.
fn number(app: &App) -> usize {
    assert!(app.world().resource::<Order>().step == Step::Change && app.should_exit().is_none());
    let building = app.world().resource::<Picked>().building.expect("a building");
    let cga = app.world().get::<Cga>(building).expect("a grammar");
    assert_eq!(cga.grammar.get("storeys"), Ok(6.0.into()));
    app.world().get::<Building>(building).expect("a number").0
}

#[test]
fn the_building_with_the_nearest_number_is_picked() {
    assert_eq!(number(&chosen(&[143, 144, 145])), 144);
    assert_eq!(number(&chosen(&[0, 2, 1])), 2);
    assert_eq!(number(&chosen(&[145, 143])), 143);
}

#[test]
fn without_buildings_the_program_ends_with_an_error() {
    assert_eq!(chosen(&[]).should_exit(), Some(AppExit::error()));
}
