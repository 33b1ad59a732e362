//! Accessors: lists of numbers in the binary data.

use super::GltfError;
use super::document::{BufferView, Document};
use super::item::{Item, item};

/// The greatest number of elements of an accessor whose elements are not in the file.
const MOST_ABSENT: usize = 1 << 20;

/// The type of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ComponentType {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl ComponentType {
    fn of(item: &Item<'_>) -> Result<Self, GltfError> {
        Ok(match item.required("componentType")? {
            5120 => ComponentType::I8,
            5121 => ComponentType::U8,
            5122 => ComponentType::I16,
            5123 => ComponentType::U16,
            5125 => ComponentType::U32,
            5126 => ComponentType::F32,
            other => return Err(item.error(format!("`componentType` {other} is unknown"))),
        })
    }

    fn bytes(self) -> usize {
        match self {
            ComponentType::I8 | ComponentType::U8 => 1,
            ComponentType::I16 | ComponentType::U16 => 2,
            ComponentType::U32 | ComponentType::F32 => 4,
        }
    }

    /// The number at the start of `bytes`, which are long enough.
    fn number(self, bytes: &[u8]) -> f64 {
        let two = || bytes.first_chunk().copied().unwrap_or_default();
        let four = || bytes.first_chunk().copied().unwrap_or_default();
        match self {
            ComponentType::I8 => f64::from(i8::from_le_bytes([bytes[0]])),
            ComponentType::U8 => f64::from(bytes[0]),
            ComponentType::I16 => f64::from(i16::from_le_bytes(two())),
            ComponentType::U16 => f64::from(u16::from_le_bytes(two())),
            ComponentType::U32 => f64::from(u32::from_le_bytes(four())),
            ComponentType::F32 => f64::from(f32::from_le_bytes(four())),
        }
    }

    /// The number that stands for 1 in a normalised accessor.
    fn one(self) -> f64 {
        match self {
            ComponentType::I8 => f64::from(i8::MAX),
            ComponentType::U8 => f64::from(u8::MAX),
            ComponentType::I16 => f64::from(i16::MAX),
            ComponentType::U16 => f64::from(u16::MAX),
            ComponentType::U32 => f64::from(u32::MAX),
            ComponentType::F32 => 1.0,
        }
    }
}

/// The name of a list of elements with `width` numbers.
fn kind(width: usize) -> &'static str {
    ["SCALAR", "VEC2", "VEC3", "VEC4"][width - 1]
}

/// An accessor.
struct Accessor<'a> {
    item: Item<'a>,
    /// How many numbers an element has.
    width: usize,
    component: ComponentType,
    count: usize,
}

impl<'a> Accessor<'a> {
    fn new(document: &'a Document<'_>, index: usize, width: usize) -> Result<Self, GltfError> {
        let item = item(&document.json, "accessors", index)?;
        if item.text("type")? != Some(kind(width)) {
            return Err(item.error(format!("its `type` must be `{}` here", kind(width))));
        }
        Ok(Accessor { item, width, component: ComponentType::of(&item)?, count: item.required("count")? })
    }

    /// The numbers of all elements, as in the file.
    fn numbers(&self, document: &Document<'_>) -> Result<Vec<f64>, GltfError> {
        let mut all = match self.item.whole("bufferView")? {
            Some(view) => {
                let start = self.item.whole("byteOffset")?.unwrap_or(0);
                numbers(&self.item, document.view(view)?, start, self.component, [self.count, self.width])?
            }
            None if MOST_ABSENT < self.count => return Err(self.item.error("it has too many elements")),
            None => vec![0.0; self.count * self.width],
        };
        if let Some(sparse) = self.item.object("sparse")? {
            self.replace(&sparse, document, &mut all)?;
        }
        Ok(all)
    }

    /// Replaces the elements that a sparse accessor lists.
    fn replace(&self, sparse: &Item<'_>, document: &Document<'_>, all: &mut [f64]) -> Result<(), GltfError> {
        let count = sparse.required("count")?;
        let part = |member| sparse.object(member)?.ok_or_else(|| sparse.error(format!("`{member}` is missing")));
        let (indices, values) = (part("indices")?, part("values")?);
        let start = |part: &Item<'_>| Ok(part.whole("byteOffset")?.unwrap_or(0));
        let view = document.view(indices.required("bufferView")?)?;
        let places = numbers(&indices, view, start(&indices)?, ComponentType::of(&indices)?, [count, 1])?;
        let view = document.view(values.required("bufferView")?)?;
        let values = numbers(&values, view, start(&values)?, self.component, [count, self.width])?;
        for (place, value) in places.into_iter().zip(values.chunks_exact(self.width)) {
            let element = all.chunks_exact_mut(self.width).nth(place as usize);
            element.ok_or_else(|| sparse.error("a sparse index is out of range"))?.copy_from_slice(value);
        }
        Ok(())
    }
}

/// The numbers of `count` elements of `width` numbers each, from a byte of a view on.
fn numbers(
    item: &Item<'_>,
    view: BufferView<'_>,
    start: usize,
    component: ComponentType,
    [count, width]: [usize; 2],
) -> Result<Vec<f64>, GltfError> {
    let size = width * component.bytes();
    let stride = view.stride.unwrap_or(size);
    if stride < size {
        return Err(item.error("the elements of its view overlap"));
    }
    if count == 0 {
        return Ok(Vec::new());
    }
    let length = (count - 1).checked_mul(stride).and_then(|length| length.checked_add(size));
    let bytes = length.and_then(|length| view.bytes.get(start..start.checked_add(length)?));
    let bytes = bytes.ok_or_else(|| item.error("its view ends early"))?;
    let mut all = Vec::with_capacity(count * width);
    for element in bytes.chunks(stride) {
        all.extend((0..width).map(|at| component.number(&element[at * component.bytes()..])));
    }
    Ok(all)
}

/// The number of elements that an accessor claims to have.
pub(super) fn count(document: &Document<'_>, index: usize) -> Result<usize, GltfError> {
    item(&document.json, "accessors", index)?.required("count")
}

/// The elements of an accessor with `N` numbers each. Normalised numbers are divided by their greatest value.
///
/// # Errors
/// The accessor is of another type, ends early, or has numbers that are not finite.
pub(super) fn vectors<const N: usize>(document: &Document<'_>, index: usize) -> Result<Vec<[f64; N]>, GltfError> {
    Ok(finite_numbers(document, index, N)?.as_chunks().0.to_vec())
}

fn finite_numbers(document: &Document<'_>, index: usize, width: usize) -> Result<Vec<f64>, GltfError> {
    let accessor = Accessor::new(document, index, width)?;
    let mut all = accessor.numbers(document)?;
    if accessor.item.flag("normalized")? {
        let one = accessor.component.one();
        all.iter_mut().for_each(|number| *number = (*number / one).max(-1.0));
    }
    if all.iter().all(|number| number.is_finite()) {
        Ok(all)
    } else {
        Err(accessor.item.error("a number is not finite"))
    }
}

/// The elements of an accessor of indices.
///
/// # Errors
/// The accessor is of another type or ends early.
pub(super) fn indices(document: &Document<'_>, index: usize) -> Result<Vec<u32>, GltfError> {
    let accessor = Accessor::new(document, index, 1)?;
    if matches!(accessor.component, ComponentType::F32 | ComponentType::I8 | ComponentType::I16) {
        return Err(accessor.item.error("indices must be unsigned integers"));
    }
    Ok(accessor.numbers(document)?.into_iter().map(|index| index as u32).collect())
}
