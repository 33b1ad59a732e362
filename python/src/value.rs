//! Values of rules as Python objects, and the other way.

use cga::{Array, Text, Value, ValueType};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyInt, PyList, PyString, PyTuple};

/// The most elements of a list.
const MOST_ELEMENTS: usize = 1_000_000;

/// A value as a Python object: float, bool, str, or a list of them. An array of several rows is a list of lists.
pub(crate) fn to_python<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Value::Float(number) => Ok(number.into_pyobject(py)?.into_any()),
        Value::Bool(truth) => Ok(truth.into_pyobject(py)?.to_owned().into_any()),
        Value::Text(text) => Ok(text.as_str().into_pyobject(py)?.into_any()),
        Value::Floats(array) => rows(py, array, |number| *number),
        Value::Bools(array) => rows(py, array, |truth| *truth),
        Value::Texts(array) => rows(py, array, |text| text.to_string()),
        _ => Ok(value.to_string().into_pyobject(py)?.into_any()),
    }
}

fn rows<'py, T, P: IntoPyObject<'py>>(
    py: Python<'py>,
    array: &Array<T>,
    element: impl Fn(&T) -> P,
) -> PyResult<Bound<'py, PyAny>> {
    let row = |row: &[T]| PyList::new(py, row.iter().map(&element).collect::<Vec<_>>());
    match array.rows() {
        0 | 1 => Ok(row(array.as_slice())?.into_any()),
        _ => Ok(PyList::new(py, array.iter_rows().map(row).collect::<PyResult<Vec<_>>>()?)?.into_any()),
    }
}

/// A Python object as a value. `wanted` is the type of the attribute, which an empty list has.
///
/// # Errors
/// A sentence about the object.
pub(crate) fn from_python(given: &Bound<'_, PyAny>, wanted: Option<ValueType>) -> Result<Value, String> {
    let plain = plain(given)?;
    if let Some(single) = single(&plain)? {
        return Ok(single);
    }
    let Some(elements) = elements(&plain) else {
        return Err(format!("{} is not a number, a truth value, text, or a list of them", type_name(&plain)));
    };
    let Some(first) = elements.first() else { return Ok(empty(wanted)) };
    let rows = match self::elements(&self::plain(first)?) {
        Some(_) => elements
            .iter()
            .map(|row| {
                self::elements(&self::plain(row)?).ok_or("some elements are lists and others are not".to_owned())
            })
            .collect::<Result<_, _>>()?,
        None => vec![elements],
    };
    let columns = rows[0].len();
    if rows.iter().any(|row| row.len() != columns) {
        return Err("its rows have different lengths".to_owned());
    }
    if MOST_ELEMENTS < rows.len().saturating_mul(columns.max(1)) {
        return Err(format!("it has more than {MOST_ELEMENTS} elements"));
    }
    let element = |element: &Bound<'_, PyAny>| {
        let plain = self::plain(element)?;
        single(&plain)?.ok_or_else(|| format!("an element is {}", type_name(&plain)))
    };
    let rows = rows.iter().map(|row| row.iter().map(element).collect()).collect::<Result<Vec<Vec<Value>>, String>>()?;
    let mixed = || "its elements have different types".to_owned();
    match rows[0].first() {
        None => Some(empty(wanted)),
        Some(Value::Float(_)) => array(&rows, |value| if let Value::Float(own) = value { Some(*own) } else { None }),
        Some(Value::Bool(_)) => array(&rows, |value| if let Value::Bool(own) = value { Some(*own) } else { None }),
        Some(_) => array(&rows, |value| if let Value::Text(own) = value { Some(own.clone()) } else { None }),
    }
    .ok_or_else(mixed)
}

/// Rows of elements of one type. `None` if an element has another type.
fn array<T: Clone>(rows: &[Vec<Value>], own: impl Fn(&Value) -> Option<T>) -> Option<Value>
where
    Array<T>: From<Vec<Vec<T>>>,
    Value: From<Array<T>>,
{
    let rows: Option<Vec<Vec<T>>> = rows.iter().map(|row| row.iter().map(&own).collect()).collect();
    rows.map(|rows| Array::from(rows).into())
}

/// The array without elements.
pub(crate) fn empty(wanted: Option<ValueType>) -> Value {
    match wanted {
        Some(ValueType::Bools) => Array::<bool>::default().into(),
        Some(ValueType::Texts) => Array::<Text>::default().into(),
        _ => Array::<f64>::default().into(),
    }
}

/// A number, a truth value or text; `None` for other objects.
fn single(given: &Bound<'_, PyAny>) -> Result<Option<Value>, String> {
    if let Ok(truth) = given.cast::<PyBool>() {
        return Ok(Some(Value::Bool(truth.is_true())));
    }
    if given.is_instance_of::<PyFloat>() || given.is_instance_of::<PyInt>() {
        return given.extract::<f64>().map(|number| Some(Value::Float(number))).map_err(|why| why.to_string());
    }
    match given.cast::<PyString>() {
        Ok(text) => text.to_str().map(|text| Some(Value::from(text))).map_err(|why| why.to_string()),
        Err(_) => Ok(None),
    }
}

/// The elements of a list or a tuple; `None` for other objects.
pub(crate) fn elements<'py>(given: &Bound<'py, PyAny>) -> Option<Vec<Bound<'py, PyAny>>> {
    match given.cast::<PyList>() {
        Ok(list) => Some(list.iter().collect()),
        Err(_) => given.cast::<PyTuple>().ok().map(|tuple| tuple.iter().collect()),
    }
}

/// An object of NumPy as a list or a number, and other objects as they are.
pub(crate) fn plain<'py>(given: &Bound<'py, PyAny>) -> Result<Bound<'py, PyAny>, String> {
    if given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>() || given.is_instance_of::<PyFloat>() {
        return Ok(given.clone());
    }
    match given.getattr_opt("tolist").map_err(|why| why.to_string())? {
        Some(list) => list.call0().map_err(|why| why.to_string()),
        None => Ok(given.clone()),
    }
}

/// The type of an object, for messages.
pub(crate) fn type_name(given: &Bound<'_, PyAny>) -> String {
    given.get_type().name().map_or_else(|_| "an object".to_owned(), |name| format!("an object of the type `{name}`"))
}

/// A value of a map for an attribute of another type: maps often have numbers as text. A value that is not one of the type stays as it is,
/// and the run reports it.
pub(crate) fn coerced(value: Value, wanted: ValueType) -> Value {
    if value.ty() == wanted {
        return value;
    }
    let other = match &value {
        Value::Text(text) => Value::parse(text, wanted),
        Value::Float(_) | Value::Bool(_) => Value::parse(&value.to_string(), wanted),
        Value::Floats(array) if array.is_empty() && wanted != ValueType::Float => Some(empty(Some(wanted))),
        _ => None,
    };
    other.unwrap_or(value)
}
