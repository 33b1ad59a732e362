//! The place of shapes on Earth (*getGeoCoord function*, `scope.elevation`).

use std::sync::Arc;

use cga::glam::DVec3;
use cga::{CoordinateSystem, Settings, Shape, cga};

use crate::lines;

/// A plan in feet with an origin, 40 m above the sea.
#[derive(Debug)]
struct Plan;

impl CoordinateSystem for Plan {
    fn projected(&self, point: DVec3) -> [f64; 2] {
        [1000.0 + point.x / 0.3048, 2000.0 - point.z / 0.3048]
    }

    fn geographic(&self, point: DVec3) -> [f64; 2] {
        [8.5 + point.x / 1000.0, 47.0 - point.z / 1000.0]
    }

    fn elevation(&self, point: DVec3) -> f64 {
        40.0 + point.y
    }
}

cga! {
    grammar Places = r#"
        attr north = getGeoCoord(lat)
        Lot --> print(north) t(3.048, 2, 6.096) A
        A --> print(getGeoCoord(X)) print(getGeoCoord(Y)) print(getGeoCoord(lon)) print(getGeoCoord(lat)) print(scope.elevation) X.
    "#;
}

#[test]
fn the_coordinate_system_of_the_settings_gives_coordinates_of_the_origin() {
    let settings = Settings { coordinates: Some(Arc::new(Plan)), ..Settings::default() };
    let model = Places::default().generate_with(&Shape::rectangle(10.0, 10.0), &settings).expect("a model");
    assert_eq!(lines(&crate::clean(model)), ["47", "1010", "1980", "8.503048", "46.993904", "42"]);
}

#[test]
fn without_a_coordinate_system_x_is_east_and_y_north() {
    let model = Places::default().generate(&Shape::rectangle(10.0, 10.0)).expect("a model");
    assert_eq!(lines(&model), ["0", "3.048", "-6.096", "0", "0", "2"]);
    let faults: Vec<&str> = model.faults().iter().map(|fault| fault.message.as_str()).collect();
    assert_eq!(faults, ["`getGeoCoord` gives 0: the settings have no coordinate system"]);
}
