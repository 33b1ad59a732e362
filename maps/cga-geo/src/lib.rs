//! Lots from map files.
//!
//! A [`reader`] gives the rows of a file: GeoJSON, FlatGeobuf, Shapefile or GeoParquet. A [`Surveyor`](survey::Surveyor) makes checked
//! [`Footprint`](footprint::Footprint)s of them, in degrees on the ellipsoid WGS 84, and reports each row and each value that it cannot
//! use. A footprint becomes a [`Shape`](cga::Shape) in the metres of a [`Frame`](frame::Frame): x to the east, y up, z to the south.
//!
//! ```
//! use cga::Grammar as _;
//! use cga_geo::frame::Frame;
//! use cga_geo::reader::geojson;
//! use cga_geo::survey::{Columns, Surveyor};
//!
//! cga::cga! { grammar House; attr height = 9  Lot --> extrude(height) comp(f) { side : Wall. | top : Roof. } }
//!
//! let text = r#"{ "type": "Feature", "id": "mill", "properties": { "height": 12 }, "geometry": { "type": "Polygon",
//!     "coordinates": [[[10.0, 50.0], [10.0002, 50.0], [10.0002, 50.0001], [10.0, 50.0001], [10.0, 50.0]]] } }"#;
//! let house = House::default();
//! let surveyor = Surveyor::new(vec![&house], Columns::default());
//! for row in geojson::read(std::io::Cursor::new(text))?.rows {
//!     let survey = surveyor.survey(row);
//!     assert!(survey.problems.is_empty());
//!     for footprint in survey.footprints {
//!         let frame = Frame::at(footprint.middle());
//!         let model = house.generate(&footprint.lot(&house, &frame)?)?;
//!         assert!((model.bounds().high.y - 12.0).abs() < 1e-9);
//!     }
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Equal rows make equal footprints, whatever the format and the order of the file: corners run counter-clockwise from the first corner of
//! the file, and [`Footprint::key`](footprint::Footprint::key) orders them by id, then by digest.
#![forbid(unsafe_code)]
// A program may make rows itself, without a reader.
#![cfg_attr(
    not(any(feature = "geojson", feature = "flatgeobuf", feature = "shapefile", feature = "geoparquet")),
    allow(dead_code)
)]

pub mod column;
pub mod crs;
pub mod footprint;
pub mod frame;
pub mod missing;
pub mod outline;
pub mod plain;
pub mod reader;
pub mod row;
pub mod survey;
#[cfg(feature = "synthetic")]
pub mod synthetic;
pub mod terrain;
