//! The lots of a call: a list, a collection, or a table.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use crate::arrow_table::ArrowTable;
use crate::errors::{AttributeValueError, ShapeError};
use crate::rows::{Columns, Row, check_properties, features, row_of};
use crate::value::{elements, plain, type_name};

/// The lots of a call.
pub(crate) struct Source {
    pub(crate) rows: Vec<Row>,
    /// The table that has the rows instead.
    pub(crate) table: Option<ArrowTable>,
    /// True if values come from columns or properties.
    pub(crate) has_columns: bool,
}

impl Source {
    /// # Errors
    /// An object without lots.
    pub(crate) fn of(lots: &Bound<'_, PyAny>, columns: &Columns) -> PyResult<Self> {
        if let Some(table) = ArrowTable::of(lots)? {
            return Ok(Source { rows: Vec::new(), table: Some(table), has_columns: true });
        }
        let plain = plain(lots).map_err(ShapeError::new_err)?;
        let (list, has_columns) = match elements(&plain) {
            Some(list) => (list, false),
            None => match features(lots).map_err(ShapeError::new_err)? {
                Some(features) => {
                    check_properties(&features, columns).map_err(AttributeValueError::new_err)?;
                    (features, true)
                }
                None => {
                    let why = "give a list of shapes, a FeatureCollection, or a table of Arrow";
                    return Err(PyTypeError::new_err(format!("{} has no lots; {why}", type_name(lots))));
                }
            },
        };
        let mut rows = Vec::with_capacity(list.len());
        for (at, given) in list.iter().enumerate() {
            if at % 1024 == 0 {
                lots.py().check_signals()?;
            }
            rows.push(row_of(given, columns));
        }
        Ok(Source { rows, table: None, has_columns })
    }
}
