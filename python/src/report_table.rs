//! Reports of many lots as a table of Arrow.

use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, LargeBinaryArray, LargeStringArray, RecordBatch, UInt64Array};
use arrow_schema::{DataType, Field, Schema};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::arrow_table::stream;
use crate::errors::RunError;
use crate::reports::Column;

/// A table of Arrow: give it to `pyarrow.table`, `polars.DataFrame`, or another function that takes an object with `__arrow_c_stream__`.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct ReportTable {
    batch: RecordBatch,
}

/// The columns that each table has.
#[derive(Default)]
pub(crate) struct Fixed {
    pub(crate) rows: Vec<u64>,
    pub(crate) names: Vec<String>,
    pub(crate) errors: Vec<Option<String>>,
    /// The files of the models, if they are wanted.
    pub(crate) glbs: Option<Vec<Option<Vec<u8>>>>,
}

#[pymethods]
impl ReportTable {
    /// The stream of the Arrow PyCapsule interface.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyCapsule>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        stream(py, vec![self.batch.clone()], self.batch.schema(), requested_schema)
    }

    /// The names of the columns.
    #[getter]
    fn columns(&self) -> Vec<String> {
        self.batch.schema().fields().iter().map(|field| field.name().clone()).collect()
    }

    fn __len__(&self) -> usize {
        self.batch.num_rows()
    }
}

impl ReportTable {
    /// # Errors
    /// A `RunError` if the columns do not fit together.
    pub(crate) fn new(fixed: Fixed, reports: Vec<(String, Column)>) -> PyResult<Self> {
        let column = |name: &str, ty: DataType, is_nullable: bool| Field::new(name, ty, is_nullable);
        let mut fields = vec![
            column("row", DataType::UInt64, false),
            column("name", DataType::LargeUtf8, false),
            column("error", DataType::LargeUtf8, true),
        ];
        let mut arrays: Vec<ArrayRef> = vec![
            Arc::new(UInt64Array::from(fixed.rows)),
            Arc::new(LargeStringArray::from(fixed.names)),
            Arc::new(LargeStringArray::from(fixed.errors)),
        ];
        if let Some(glbs) = fixed.glbs {
            fields.push(column("glb", DataType::LargeBinary, true));
            arrays.push(Arc::new(LargeBinaryArray::from_iter(glbs)));
        }
        let taken: Vec<String> = fields.iter().map(|field| field.name().clone()).collect();
        for (key, cells) in reports {
            let name = if taken.contains(&key) { format!("{key} (report)") } else { key };
            let (ty, array): (_, ArrayRef) = match cells {
                Column::Numbers(cells) => (DataType::Float64, Arc::new(Float64Array::from(cells))),
                Column::Texts(cells) => (DataType::LargeUtf8, Arc::new(LargeStringArray::from(cells))),
            };
            fields.push(column(&name, ty, true));
            arrays.push(array);
        }
        let batch = RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays);
        Ok(ReportTable { batch: batch.map_err(|why| RunError::new_err(why.to_string()))? })
    }
}
