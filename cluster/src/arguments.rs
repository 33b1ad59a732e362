//! The arguments of functions, which are checked when a query is planned.

use cga_geo::reader::arrow::{check as check_column, is_binary};
use datafusion::arrow::array::{ArrayRef, AsArray as _};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, FieldRef};
use datafusion::error::{DataFusionError, Result};

/// An argument of a function.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Argument {
    /// The address of a work or a plan.
    Address,
    /// A geometry as WKB.
    Geometry,
    /// A group of columns.
    Columns,
    /// A whole number.
    Number,
    /// The footprints of a group.
    Footprints,
}

impl Argument {
    /// Returns true if the argument may have a type.
    fn accepts(self, kind: &DataType) -> bool {
        match self {
            Argument::Address => matches!(kind, DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View),
            Argument::Geometry => is_binary(kind),
            Argument::Columns => matches!(kind, DataType::Struct(_)),
            Argument::Number => kind.is_integer() || kind.is_null(),
            Argument::Footprints => {
                matches!(kind, DataType::List(item) | DataType::LargeList(item) if is_binary(item.data_type()))
            }
        }
    }

    /// The words for a person who wrote another type.
    fn wanted(self) -> &'static str {
        match self {
            Argument::Address => "the address of a file in the store as text, as in `'file:///city/jobs/0123.json'`",
            Argument::Geometry => "a geometry as WKB, which has the type Binary",
            Argument::Columns => "a group of columns, as in `named_struct('height', height)`",
            Argument::Number => "a whole number",
            Argument::Footprints => "footprints, as in `array_agg(lot['footprint'])`",
        }
    }
}

/// Checks the types of the arguments of a function.
///
/// # Errors
/// A sentence with the type that is wanted.
pub(crate) fn check(name: &str, arguments: &[Argument], kinds: &[DataType]) -> Result<()> {
    for (at, (argument, kind)) in arguments.iter().zip(kinds).enumerate() {
        if !argument.accepts(kind) {
            let (number, wanted) = (at + 1, argument.wanted());
            return Err(DataFusionError::Plan(format!(
                "argument {number} of `{name}` has the type {kind}; write {wanted}"
            )));
        }
        if let DataType::Struct(columns) = kind {
            let check = |column: &FieldRef| check_column(column.name(), column.data_type());
            columns.iter().try_for_each(check).map_err(DataFusionError::Plan)?;
        }
    }
    Ok(())
}

/// The address of a work or a plan, which all rows of a batch have.
///
/// # Errors
/// A sentence: a row has no address, or another one than the first row.
pub(crate) fn address(column: &ArrayRef) -> Result<String> {
    let failed = |why: &str| Err(DataFusionError::Execution(why.to_owned()));
    let column = cast(column, &DataType::Utf8)?;
    let mut texts = column.as_string::<i32>().iter();
    let Some(first) = texts.next().flatten() else { return failed("the address of a work or a plan is NULL") };
    if texts.any(|text| text != Some(first)) {
        return failed("the rows have different addresses of works or plans; write a query for each address");
    }
    Ok(first.to_owned())
}
