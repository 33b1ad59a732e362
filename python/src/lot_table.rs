//! The lots of units as a table of Arrow.

use std::sync::Arc;

use arrow_array::builder::{BinaryBuilder, Int32Builder};
use arrow_array::{ArrayRef, RecordBatch};
use arrow_schema::{DataType, Field, Schema, SchemaRef};
use pyo3::prelude::*;
use pyo3::types::PyCapsule;

use crate::arrow_table::stream;

/// The most bytes of the lots of a batch. The offsets of the column have 32 bits, which all engines read.
const MOST_BYTES: usize = 1 << 30;

/// A table of Arrow with the columns `unit`, a number, and `lot`, bytes: give it to `pyarrow.table`, or another function that takes an object with
/// `__arrow_c_stream__`.
#[pyclass(frozen, module = "pycga")]
#[derive(Debug)]
pub(crate) struct LotTable {
    batches: Vec<RecordBatch>,
}

#[pymethods]
impl LotTable {
    /// The stream of the Arrow PyCapsule interface.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyCapsule>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        stream(py, self.batches.clone(), schema(), requested_schema)
    }

    fn __len__(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }
}

fn schema() -> SchemaRef {
    let field = |name: &str, kind| Field::new(name, kind, true);
    Arc::new(Schema::new(vec![field("unit", DataType::Int32), field("lot", DataType::Binary)]))
}

/// Collects lots.
#[derive(Default)]
pub(crate) struct LotTableBuilder {
    units: Int32Builder,
    lots: BinaryBuilder,
    bytes: usize,
    batches: Vec<RecordBatch>,
}

impl LotTableBuilder {
    /// Adds a lot that a unit reads.
    ///
    /// # Errors
    /// A sentence: the unit has a number above 2³¹.
    pub(crate) fn add(&mut self, unit: usize, lot: &[u8]) -> Result<(), String> {
        if MOST_BYTES < self.bytes + lot.len() {
            self.end_batch()?;
        }
        self.bytes += lot.len();
        self.units.append_value(i32::try_from(unit).map_err(|why| why.to_string())?);
        self.lots.append_value(lot);
        Ok(())
    }

    fn end_batch(&mut self) -> Result<(), String> {
        let columns: Vec<ArrayRef> = vec![Arc::new(self.units.finish()), Arc::new(self.lots.finish())];
        self.batches.push(RecordBatch::try_new(schema(), columns).map_err(|why| why.to_string())?);
        self.bytes = 0;
        Ok(())
    }

    /// The table.
    ///
    /// # Errors
    /// A sentence: the columns do not fit together.
    pub(crate) fn finish(mut self) -> Result<LotTable, String> {
        self.end_batch()?;
        Ok(LotTable { batches: self.batches })
    }
}
