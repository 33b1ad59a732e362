//! The annotations of attributes (*annotations*). None of them changes what rules make.

use super::GlobalId;

/// The annotations and doc comment of an attribute.
#[derive(Clone, Debug, Default)]
pub struct AttrInfo {
    /// `@Range(min, max)`, or what `@Angle` and `@Percent` offer without one. Only for floats; it holds for each element of
    /// an array.
    pub range: Option<Range>,
    /// `@Enum`, or a `@Range` with a list of values. Only for floats and text; it holds for each element of an array.
    pub choices: Option<Choices>,
    /// As what user interfaces show it.
    pub presentation: Presentation,
    /// `@DisplayName`: shown instead of the name.
    pub display_name: Option<String>,
    /// `@Group("A", "B", n)`.
    pub group: AttrGroup,
    /// `@Description`, else doc comments, joined by line ends.
    pub doc: String,
    /// `@Order(n)`: where user interfaces show it.
    pub order: Option<f64>,
    /// `@Hidden`: user interfaces leave it out.
    pub hidden: bool,
}

impl AttrInfo {
    /// The range to which a run restricts the attribute.
    pub fn held_to_range(&self) -> Option<Range> {
        self.range.filter(|range| range.restricted)
    }

    /// The values to which a run restricts the attribute.
    pub fn held_to_choices(&self) -> Option<&ChoiceValues> {
        self.choices.as_ref().filter(|choices| choices.restricted).map(|choices| &choices.values)
    }
}

/// The group of attributes. It continues from one `@Group` to the next, across imports.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AttrGroup {
    /// From the outermost to the innermost name; empty without a group.
    pub names: Vec<String>,
    /// The position of the innermost group in the order of groups.
    pub order: Option<f64>,
}

/// `@Range(min=…, max=…, stepsize=…, restricted=…)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Step of a slider, 0 when free.
    pub step: f64,
    /// True if other values are refused.
    pub restricted: bool,
}

/// `@Enum(value, …, restricted=…)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Choices {
    /// The values.
    pub values: ChoiceValues,
    /// The names of the values in old files, as in `@Range(few=1, many=5)`; empty, or one for each.
    pub labels: Vec<String>,
    /// True if other values are refused.
    pub restricted: bool,
}

/// The values of an `@Enum`.
#[derive(Clone, Debug, PartialEq)]
pub enum ChoiceValues {
    /// Numbers.
    Floats(Vec<f64>),
    /// Strings.
    Texts(Vec<String>),
    /// `valuesAttr=name`: the value or the elements of that attribute.
    Attr(GlobalId),
}

/// As what user interfaces show an attribute.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Presentation {
    /// By its type alone.
    #[default]
    Plain,
    /// `@Angle`: in degrees.
    Angle,
    /// `@Percent`: 0.1 is shown as 10 %.
    Percent,
    /// `@Distance`: in metres.
    Distance,
    /// `@Color`: text like `"#ff8000"`.
    Color,
    /// `@File`: a file with one of these extensions; any file if the list is empty.
    File(Vec<String>),
    /// `@Directory`.
    Directory,
    /// `@MaterialFile`.
    MaterialFile,
}
