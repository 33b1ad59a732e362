//! Typed access to the JSON text: items of its lists, and their members. A member of the wrong type is an error that
//! names the item.

use serde_json::Value;

use super::GltfError;

/// An item of a list of the file, or an object inside it.
#[derive(Clone, Copy)]
pub(super) struct Item<'a> {
    list: &'static str,
    /// The index of the item in its list.
    pub(super) index: usize,
    json: &'a Value,
}

/// The items of a list. A missing list has none.
pub(super) fn items<'a>(document: &'a Value, list: &'static str) -> impl Iterator<Item = Item<'a>> {
    let values = document.get(list).and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    values.iter().enumerate().map(move |(index, json)| Item { list, index, json })
}

/// An item by its index.
pub(super) fn item<'a>(document: &'a Value, list: &'static str, index: usize) -> Result<Item<'a>, GltfError> {
    let json = document.get(list).and_then(|values| values.get(index));
    json.map(|json| Item { list, index, json }).ok_or_else(|| GltfError::item(list, index, "it does not exist"))
}

impl<'a> Item<'a> {
    /// An error that names the item.
    pub(super) fn error(&self, what: impl Into<String>) -> GltfError {
        GltfError::item(self.list, self.index, what)
    }

    /// The error for a member of the wrong type.
    fn wrong(&self, member: &str, wanted: &str) -> GltfError {
        self.error(format!("`{member}` must be {wanted}"))
    }

    /// An object inside the item.
    pub(super) fn object(&self, member: &str) -> Result<Option<Item<'a>>, GltfError> {
        match self.json.get(member) {
            None => Ok(None),
            Some(json) if json.is_object() => Ok(Some(Item { json, ..*self })),
            Some(_) => Err(self.wrong(member, "an object")),
        }
    }

    /// An extension of the item.
    pub(super) fn extension(&self, name: &str) -> Result<Option<Item<'a>>, GltfError> {
        self.object("extensions")?.map_or(Ok(None), |extensions| extensions.object(name))
    }

    /// The objects in a list inside the item.
    pub(super) fn objects(&self, member: &str) -> Result<Vec<Item<'a>>, GltfError> {
        let all = self.list(member, "a list of objects")?.iter().map(|json| match json.is_object() {
            true => Ok(Item { json, ..*self }),
            false => Err(self.wrong(member, "a list of objects")),
        });
        all.collect()
    }

    /// The indices in a list inside the item.
    pub(super) fn indices(&self, member: &str) -> Result<Vec<usize>, GltfError> {
        let all = self.list(member, "a list of indices")?.iter();
        all.map(|json| whole(json).ok_or_else(|| self.wrong(member, "a list of indices"))).collect()
    }

    fn list(&self, member: &str, wanted: &str) -> Result<&'a [Value], GltfError> {
        match self.json.get(member) {
            None => Ok(&[]),
            Some(Value::Array(values)) => Ok(values),
            Some(_) => Err(self.wrong(member, wanted)),
        }
    }

    /// A number that is an index or a size.
    pub(super) fn whole(&self, member: &str) -> Result<Option<usize>, GltfError> {
        let value = self.json.get(member);
        value.map(|value| whole(value).ok_or_else(|| self.wrong(member, "a number without fraction"))).transpose()
    }

    /// An index or a size that the format requires.
    pub(super) fn required(&self, member: &str) -> Result<usize, GltfError> {
        self.whole(member)?.ok_or_else(|| self.error(format!("`{member}` is missing")))
    }

    /// The member as a number.
    pub(super) fn number(&self, member: &str) -> Result<Option<f64>, GltfError> {
        let value = self.json.get(member);
        value.map(|value| value.as_f64().ok_or_else(|| self.wrong(member, "a number"))).transpose()
    }

    /// The member as a list of `N` numbers.
    pub(super) fn numbers<const N: usize>(&self, member: &str) -> Result<Option<[f64; N]>, GltfError> {
        let Some(value) = self.json.get(member) else { return Ok(None) };
        let numbers: Option<Vec<f64>> = value.as_array().and_then(|all| all.iter().map(Value::as_f64).collect());
        let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
        numbers.map(Some).ok_or_else(|| self.wrong(member, &format!("a list of {N} numbers")))
    }

    /// The member as text.
    pub(super) fn text(&self, member: &str) -> Result<Option<&'a str>, GltfError> {
        let value = self.json.get(member);
        value.map(|value| value.as_str().ok_or_else(|| self.wrong(member, "text"))).transpose()
    }

    /// The member as a flag; a missing one is false.
    pub(super) fn flag(&self, member: &str) -> Result<bool, GltfError> {
        let value = self.json.get(member);
        value.map_or(Ok(false), |value| value.as_bool().ok_or_else(|| self.wrong(member, "true or false")))
    }
}

/// A number without fraction. Some writers print indices as `1.0`.
fn whole(value: &Value) -> Option<usize> {
    let float = || value.as_f64().filter(|value| value.fract() == 0.0 && (0.0..9e15).contains(value));
    value.as_u64().or_else(|| float().map(|value| value as u64)).and_then(|value| usize::try_from(value).ok())
}
