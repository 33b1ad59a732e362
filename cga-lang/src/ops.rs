//! The tables of the language's words: operations, functions, shape attributes, component selectors.
//!
//! To add an operation that only changes the current shape: one row here and one function in the runtime's `op`
//! module. The parser, the checks and the code generator read the row.

use crate::ir::Type;

/// An operation that changes the current shape.
#[derive(Debug, PartialEq)]
pub struct Operation {
    /// As written in rules. Several rows may share a name; argument count and kinds tell them apart.
    pub name: &'static str,
    /// The function in the runtime's `op` module.
    pub call: &'static str,
    /// Its parameters.
    pub params: &'static [Param],
    /// Whether it looks at the state at the start of the rule, bracket or part (`center`).
    pub uses_base: bool,
    /// What it does, in a line.
    pub about: &'static str,
}

/// A parameter of an operation.
#[derive(Debug, PartialEq)]
pub struct Param {
    /// For messages.
    pub name: &'static str,
    /// What may stand there.
    pub kind: ParamKind,
}

/// What may stand in an operation's argument.
#[derive(Debug, PartialEq)]
pub enum ParamKind {
    /// A value of that type.
    Value(Type),
    /// A length in metres, or relative with `'`.
    Length,
    /// A word. The runtime has an enum of that name with a variant for each second entry.
    Word {
        /// The runtime's enum.
        rust: &'static str,
        /// As written, and the enum's variant.
        words: &'static [(&'static str, &'static str)],
    },
}

/// A function of the language.
#[derive(Debug, PartialEq)]
pub struct Builtin {
    /// As written.
    pub name: &'static str,
    /// The function in the runtime's `func` module.
    pub call: &'static str,
    /// Types of its parameters.
    pub params: &'static [Type],
    /// Type of its result.
    pub ty: Type,
    /// Whether it needs the current shape, mutably, before its arguments (`rand`, `p`).
    pub uses_shape: bool,
    /// Whether equal arguments always give equal results, so that it may be folded.
    pub pure: bool,
}

/// An attribute of the current shape.
#[derive(Debug, PartialEq)]
pub struct ShapeAttr {
    /// As written: `scope.sx`.
    pub name: &'static str,
    /// The function in the runtime's `get` module.
    pub get: &'static str,
    /// Its type.
    pub ty: Type,
    /// The function in the runtime's `set` module, if it can be set.
    pub set: Option<&'static str>,
}

const fn float(name: &'static str) -> Param {
    Param { name, kind: ParamKind::Value(Type::Float) }
}

const fn text(name: &'static str) -> Param {
    Param { name, kind: ParamKind::Value(Type::Text) }
}

const fn length(name: &'static str) -> Param {
    Param { name, kind: ParamKind::Length }
}

const fn op(name: &'static str, call: &'static str, params: &'static [Param], about: &'static str) -> Operation {
    Operation { name, call, params, uses_base: false, about }
}

const CENTER_AXES: ParamKind = ParamKind::Word {
    rust: "CenterAxes",
    words: &[("x", "X"), ("y", "Y"), ("z", "Z"), ("xy", "Xy"), ("xz", "Xz"), ("yz", "Yz"), ("xyz", "Xyz")],
};

const ROTATE_ABOUT: ParamKind =
    ParamKind::Word { rust: "RotateAbout", words: &[("scopeOrigin", "ScopeOrigin"), ("scopeCenter", "ScopeCenter")] };

const EXTRUDE_ALONG: ParamKind = ParamKind::Word {
    rust: "ExtrudeAlong",
    words: &[("face.normal", "FaceNormal"), ("world.up", "WorldUp"), ("world.y", "WorldUp")],
};

/// The operations that change the current shape.
pub static OPERATIONS: &[Operation] = &[
    op("s", "size", &[length("x"), length("y"), length("z")], "sets the size of the scope"),
    op("t", "translate", &[length("x"), length("y"), length("z")], "moves along the axes of the scope"),
    op("r", "rotate", &[float("x"), float("y"), float("z")], "rotates about the origin of the scope, in degrees"),
    op(
        "r",
        "rotate_about",
        &[Param { name: "about", kind: ROTATE_ABOUT }, float("x"), float("y"), float("z")],
        "rotates about the origin or the centre of the scope, in degrees",
    ),
    Operation {
        name: "center",
        call: "center",
        params: &[Param { name: "axes", kind: CENTER_AXES }],
        uses_base: true,
        about: "moves the centre of the scope to the centre it had before",
    },
    op("color", "color_hex", &[text("rrggbb")], "sets the colour, as in \"#ff8000\""),
    op("color", "color_rgb", &[float("red"), float("green"), float("blue")], "sets the colour, each from 0 to 1"),
    op(
        "color",
        "color_rgba",
        &[float("red"), float("green"), float("blue"), float("opacity")],
        "sets colour and opacity, each from 0 to 1",
    ),
    op("extrude", "extrude", &[length("distance")], "extrudes each face along its normal"),
    op(
        "extrude",
        "extrude_along",
        &[Param { name: "along", kind: EXTRUDE_ALONG }, length("distance")],
        "extrudes each face along its normal or upwards",
    ),
    op("primitiveCube", "cube", &[], "replaces the geometry by a box that fills the scope"),
    op(
        "primitiveCube",
        "cube_sized",
        &[float("width"), float("height"), float("depth")],
        "replaces the geometry by a box of that size",
    ),
    op("primitiveCylinder", "cylinder", &[], "replaces the geometry by a cylinder that fills the scope"),
    op("primitiveCylinder", "cylinder_sides", &[float("sides")], "as many sides instead of 16"),
    op(
        "primitiveCylinder",
        "cylinder_sized",
        &[float("sides"), float("radius"), float("height")],
        "replaces the geometry by a cylinder of that size",
    ),
    op("primitiveQuad", "quad", &[], "replaces the geometry by a rectangle that fills the scope"),
    op("primitiveQuad", "quad_sized", &[float("width"), float("length")], "replaces the geometry by a rectangle"),
    op("i", "insert", &[text("file")], "replaces the geometry by an asset that fills the scope"),
    op("texture", "texture", &[text("file")], "sets the colour map"),
];

/// The rows of an operation's name.
pub fn operations(name: &str) -> impl Iterator<Item = &'static Operation> + '_ {
    OPERATIONS.iter().filter(move |row| row.name == name)
}

const fn func(name: &'static str, call: &'static str, params: &'static [Type], ty: Type) -> Builtin {
    Builtin { name, call, params, ty, uses_shape: false, pure: true }
}

const fn draw(name: &'static str, call: &'static str, params: &'static [Type], ty: Type) -> Builtin {
    Builtin { name, call, params, ty, uses_shape: true, pure: false }
}

const F: Type = Type::Float;
const B: Type = Type::Bool;
const T: Type = Type::Text;

/// The functions of the language.
///
/// Rows of one name and as many parameters differ in type. `str`, `float` and `bool` of a value that has the type
/// already is the value itself, and `str` of a float or bool is [`ToText`](crate::ir::ExprKind::ToText): these need
/// no row.
pub static BUILTINS: &[Builtin] = &[
    draw("rand", "rand", &[], F),
    draw("rand", "rand_to", &[F], F),
    draw("rand", "rand_between", &[F, F], F),
    draw("p", "chance", &[F], B),
    func("floor", "floor", &[F], F),
    func("ceil", "ceil", &[F], F),
    func("rint", "rint", &[F], F),
    func("abs", "abs", &[F], F),
    func("sqrt", "sqrt", &[F], F),
    func("sin", "sin", &[F], F),
    func("cos", "cos", &[F], F),
    func("tan", "tan", &[F], F),
    func("asin", "asin", &[F], F),
    func("acos", "acos", &[F], F),
    func("atan", "atan", &[F], F),
    func("atan2", "atan2", &[F, F], F),
    func("pow", "pow", &[F, F], F),
    func("exp", "exp", &[F], F),
    func("ln", "ln", &[F], F),
    func("log10", "log10", &[F], F),
    func("min", "min", &[F, F], F),
    func("max", "max", &[F, F], F),
    func("clamp", "clamp", &[F, F, F], F),
    func("isnan", "isnan", &[F], B),
    func("isinf", "isinf", &[F], B),
    func("float", "bool_to_float", &[B], F),
    func("float", "text_to_float", &[T], F),
    func("bool", "float_to_bool", &[F], B),
    func("bool", "text_to_bool", &[T], B),
];

/// The rows of a function's name.
pub fn builtins(name: &str) -> impl Iterator<Item = &'static Builtin> + '_ {
    BUILTINS.iter().filter(move |row| row.name == name)
}

const fn get(name: &'static str, get: &'static str) -> ShapeAttr {
    ShapeAttr { name, get, ty: Type::Float, set: None }
}

const fn both(name: &'static str, call: &'static str, ty: Type) -> ShapeAttr {
    ShapeAttr { name, get: call, ty, set: Some(call) }
}

/// The attributes of shapes.
pub static SHAPE_ATTRS: &[ShapeAttr] = &[
    both("scope.sx", "scope_sx", F),
    both("scope.sy", "scope_sy", F),
    both("scope.sz", "scope_sz", F),
    both("scope.tx", "scope_tx", F),
    both("scope.ty", "scope_ty", F),
    both("scope.tz", "scope_tz", F),
    both("scope.rx", "scope_rx", F),
    both("scope.ry", "scope_ry", F),
    both("scope.rz", "scope_rz", F),
    get("scope.elevation", "scope_elevation"),
    get("split.index", "split_index"),
    get("split.total", "split_total"),
    get("comp.index", "comp_index"),
    get("comp.total", "comp_total"),
    ShapeAttr { name: "comp.sel", get: "comp_sel", ty: Type::Text, set: None },
    both("material.color.r", "material_color_r", F),
    both("material.color.g", "material_color_g", F),
    both("material.color.b", "material_color_b", F),
    both("material.opacity", "material_opacity", F),
    both("material.metallic", "material_metallic", F),
    both("material.roughness", "material_roughness", F),
    both("material.name", "material_name", T),
    both("material.colormap", "material_colormap", T),
];

/// The attribute of that name.
pub fn shape_attr(name: &str) -> Option<&'static ShapeAttr> {
    SHAPE_ATTRS.iter().find(|row| row.name == name)
}

/// The words that select components.
pub const SELECTORS: &[&str] =
    &["front", "back", "left", "right", "top", "bottom", "side", "vertical", "horizontal", "aslant", "nutant", "all"];
