//! Attributes, and what annotations say about them (*annotations*). None of it changes what rules make.

use super::{AttrId, Expr, Type, Value};
use crate::span::Span;

/// `attr name = expr`.
#[derive(Clone, Debug)]
pub struct Attr {
    /// The name, after the names of imports: `imp.height`.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// The default.
    pub default: Expr,
    /// The default, when it is a constant: then the public field holds it. Otherwise the field is an `Option` and
    /// `None` means "compute the default for each initial shape".
    pub known: Option<Value>,
    /// Its annotations and doc comment.
    pub info: AttrInfo,
    /// True if some rule sets it or a renewal may change it: only then do reads look at the shape first.
    pub is_set: bool,
    /// True on a cycle that conditions may keep open: it is computed on its first read.
    pub lazy: bool,
    /// True if the host program may set it.
    pub public: bool,
    /// The name in its declaration.
    pub span: Span,
}

/// The annotations and doc comment of an attribute.
#[derive(Clone, Debug, Default)]
pub struct AttrInfo {
    /// `@Range(min, max)`, or what `@Angle` and `@Percent` offer without one. Only for floats; it holds for each element of
    /// an array.
    pub range: Option<Range>,
    /// `@Enum`, or a `@Range` with a list of values. Only for floats and text; it holds for each element of an array.
    pub choices: Option<Choices>,
    /// The form in which user interfaces show it.
    pub presentation: Presentation,
    /// `@DisplayName`: shown instead of the name.
    pub display_name: Option<String>,
    /// `@Group`.
    pub group: AttrGroup,
    /// `@Description`, else doc comments, joined by line ends.
    pub doc: String,
    /// `@Order(n)`: the position in which user interfaces show it.
    pub order: Option<f64>,
    /// `@Hidden`: user interfaces leave it out.
    pub hidden: bool,
}

impl AttrInfo {
    /// The range to which a run restricts the attribute.
    pub(crate) fn held_to_range(&self) -> Option<Range> {
        self.range.filter(|range| range.restricted)
    }

    /// The values to which a run restricts the attribute.
    pub(crate) fn held_to_choices(&self) -> Option<&ChoiceValues> {
        self.choices.as_ref().filter(|choices| choices.restricted).map(|choices| &choices.values)
    }
}

/// `@Group("A", "B", n)`: a group of attributes. It continues from one `@Group` to the next, across imports.
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
    Attr(AttrId),
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
