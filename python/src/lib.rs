//! CGA rules in Python: rules are loaded at run time, lots come from coordinates, WKB, GeoJSON or Arrow, models leave as GLB or NumPy arrays.
//!
//! `pycga.pyi` has the interface with its types; the texts of `help(pycga)` are the doc comments here. Work on lots runs on threads of its own
//! and without the interpreter lock (`run`). No panic reaches Python: it becomes a `RunError`.
#![forbid(unsafe_code)]

mod arrow_table;
mod attribute;
mod call;
mod city;
mod city_choices;
mod city_plan;
mod diagnostic;
mod errors;
mod failure;
mod fault;
mod geometry;
mod jobs;
mod lot_table;
mod material;
mod mesh;
mod model;
mod models;
mod outline;
mod proposal;
mod report_table;
mod reports;
mod rows;
mod rule_file;
mod run;
mod shape;
mod source;
mod value;
mod wkb;

use pyo3::prelude::*;

/// CGA rules in Python.
///
/// Rules are loaded from a file or from text; lots come from coordinates, WKB, GeoJSON, shapely or Arrow; models leave as GLB, OBJ, PNG, SVG or
/// NumPy arrays. `City` makes 3D Tiles of tables on many machines. Lengths are metres. Maps have x to the east and y to the north; rules and models have x to the east, y up and z to the south.
#[pymodule]
mod pycga {
    #[pymodule_export]
    use crate::attribute::{Attribute, StartRule};
    #[pymodule_export]
    use crate::city::City;
    #[pymodule_export]
    use crate::city_plan::CityPlan;
    #[pymodule_export]
    use crate::diagnostic::Diagnostic;
    #[pymodule_export]
    use crate::errors::{
        AttributeValueError, CgaError, CityError, DeadlineError, RuleError, RunError, ShapeError, WriteError,
    };
    #[pymodule_export]
    use crate::failure::Failure;
    #[pymodule_export]
    use crate::fault::Fault;
    #[pymodule_export]
    use crate::lot_table::LotTable;
    #[pymodule_export]
    use crate::material::Material;
    #[pymodule_export]
    use crate::mesh::Mesh;
    #[pymodule_export]
    use crate::model::Model;
    #[pymodule_export]
    use crate::models::Models;
    #[pymodule_export]
    use crate::report_table::ReportTable;
    #[pymodule_export]
    use crate::rule_file::RuleFile;
    #[pymodule_export]
    use crate::shape::{Shape, shapes};

    /// The version of the package.
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "Python's name")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
