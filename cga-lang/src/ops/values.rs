//! The functions of values: numbers, text, lists in text, arrays, colours, paths, chance. The row for single numbers
//! comes first among rows with one name.

use super::base::function;
use super::{
    B, BS, Default, F, FS, Function, HEX, Meaning, Needs, Param, Params, Str, T, TS, Uses, boolean, channel, float, of,
    or, text,
};
use crate::types::Type;

/// A function of its arguments only.
const fn plain(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    Function { pure: true, ..function(name, call, params, ty, about) }
}

/// A function that can leave a fault or end the run.
const fn run(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    Function { needs: Needs::Env, ..plain(name, call, params, ty, about) }
}

/// A function that draws random numbers of the shape.
const fn draw(name: Str, call: Str, params: Params, ty: Type, needs: Needs, about: Str) -> Function {
    Function { needs, uses: Uses::DRAWS, pure: false, ..plain(name, call, params, ty, about) }
}

/// The row of a function with a meaning at compile time.
const fn means(meaning: Meaning, row: Function) -> Function {
    Function { meaning, ..row }
}

/// The row of an old spelling.
const fn old(row: Function, instead: Str) -> Function {
    Function { old: Some(instead), ..row }
}

/// `index`, deprecated by *CGA changelog 2020.0*. Its page of 2019.1 gives floats an epsilon of 0 by default.
const INDEX: &str = "write `findFirst(…)`, which needs an epsilon for floats";

const INPUT: Param = text("inputString");
const MATCH: Param = text("matchString");
const OLD: Param = text("oldString");
const LIST: Param = text("stringList");
const SEARCH: Param = text("searchString");
const PATH: Param = text("filePath");

/// Random numbers.
pub(super) static CHANCE: &[Function] = &[
    means(Meaning::Random, draw("rand", "rand", &[], F, Needs::Shape, "a random number between 0 and 1")),
    means(
        Meaning::Random,
        draw("rand", "rand_to", &[float("max")], F, Needs::Both, "a random number between 0 and a number"),
    ),
    means(
        Meaning::Random,
        draw(
            "rand",
            "rand_between",
            &[float("min"), float("max")],
            F,
            Needs::Both,
            "a random number between two numbers",
        ),
    ),
    means(
        Meaning::Chance,
        draw("p", "chance", &[float("probability")], B, Needs::Both, "true with a probability from 0 to 1"),
    ),
];

/// Arithmetic.
pub(super) static MATH: &[Function] = &[
    means(Meaning::Floor, run("floor", "floor", &[float("x")], F, "the largest whole number that is not above")),
    run("floor", "floor_each", &[of("x", FS)], FS, "the largest whole number that is not above, for each element"),
    means(Meaning::Ceil, run("ceil", "ceil", &[float("x")], F, "the smallest whole number that is not below")),
    run("ceil", "ceil_each", &[of("x", FS)], FS, "the smallest whole number that is not below, for each element"),
    means(Meaning::Round, run("rint", "rint", &[float("x")], F, "the nearest whole number")),
    run("rint", "rint_each", &[of("x", FS)], FS, "the nearest whole number, for each element"),
    means(Meaning::Abs, run("abs", "abs", &[float("x")], F, "the number without its sign")),
    run("abs", "abs_each", &[of("x", FS)], FS, "the number without its sign, for each element"),
    means(Meaning::Sqrt, run("sqrt", "sqrt", &[float("x")], F, "the square root")),
    means(Meaning::Wave, run("sin", "sin", &[float("degrees")], F, "the sine of an angle in degrees")),
    means(Meaning::Wave, run("cos", "cos", &[float("degrees")], F, "the cosine of an angle in degrees")),
    run("tan", "tan", &[float("degrees")], F, "the tangent of an angle in degrees"),
    run("asin", "asin", &[float("x")], F, "the angle of a sine, from -90 to 90 degrees"),
    run("acos", "acos", &[float("x")], F, "the angle of a cosine, from 0 to 180 degrees"),
    run("atan", "atan", &[float("x")], F, "the angle of a tangent, from -90 to 90 degrees"),
    run("atan2", "atan2", &[float("y"), float("x")], F, "the angle of the point (x, y), from -180 to 180 degrees"),
    run("pow", "pow", &[float("base"), float("exponent")], F, "a power"),
    run("exp", "exp", &[float("x")], F, "e to the power of a number"),
    run("ln", "ln", &[float("x")], F, "the natural logarithm"),
    run("log10", "log10", &[float("x")], F, "the logarithm to base 10"),
    means(Meaning::Min, plain("min", "min", &[float("a"), float("b")], F, "the smaller one")),
    plain("min", "min", &[text("a"), text("b")], T, "the text that comes first"),
    run("min", "min_each", &[of("a", FS), of("b", FS)], FS, "the smaller one, element by element"),
    run("min", "min_each", &[of("a", TS), of("b", TS)], TS, "the smaller one, element by element"),
    means(Meaning::Max, plain("max", "max", &[float("a"), float("b")], F, "the larger one")),
    plain("max", "max", &[text("a"), text("b")], T, "the text that comes last"),
    run("max", "max_each", &[of("a", FS), of("b", FS)], FS, "the larger one, element by element"),
    run("max", "max_each", &[of("a", TS), of("b", TS)], TS, "the larger one, element by element"),
    plain("clamp", "clamp", &[float("x"), float("min"), float("max")], F, "the number, limited to a range"),
    plain("clamp", "clamp", &[text("x"), text("min"), text("max")], T, "the text, or the nearer of two limits"),
    run(
        "clamp",
        "clamp_each",
        &[of("x", FS), of("min", FS), of("max", FS)],
        FS,
        "each element, limited to a range of its own",
    ),
    run(
        "clamp",
        "clamp_each",
        &[of("x", TS), of("min", TS), of("max", TS)],
        TS,
        "each element, limited to a range of its own",
    ),
    plain("isnan", "isnan", &[float("x")], B, "whether it is NaN"),
    run("isnan", "isnan_each", &[of("x", FS)], BS, "whether it is NaN, for each element"),
    plain("isinf", "isinf", &[float("x")], B, "whether it is infinite"),
    run("isinf", "isinf_each", &[of("x", FS)], BS, "whether it is infinite, for each element"),
    plain("isNull", "isnull_float", &[float("value")], B, "whether it is a missing value"),
    plain("isNull", "isnull_text", &[text("value")], B, "whether it is a missing value"),
    run("isNull", "isnull_float_each", &[of("values", FS)], BS, "whether it is a missing value, for each element"),
    run("isNull", "isnull_text_each", &[of("values", TS)], BS, "whether it is a missing value, for each element"),
];

/// Conversions between types.
pub(super) static CONVERSIONS: &[Function] = &[
    means(Meaning::BoolToFloat, plain("float", "bool_to_float", &[boolean("value")], F, "1 or 0")),
    plain("float", "text_to_float", &[text("value")], F, "the number that a text begins with"),
    means(Meaning::FloatToBool, plain("bool", "float_to_bool", &[float("value")], B, "whether it is not 0")),
    plain("bool", "text_to_bool", &[text("value")], B, "whether it is neither `f` nor `false` nor a zero"),
    plain("floatArray", "no_floats", &[], FS, "an array without elements"),
    run("floatArray", "floats_from_bools", &[of("values", BS)], FS, "1 or 0 for each element"),
    run("floatArray", "floats_from_texts", &[of("values", TS)], FS, "the number that each element begins with"),
    plain("boolArray", "no_bools", &[], BS, "an array without elements"),
    run("boolArray", "bools_from_floats", &[of("values", FS)], BS, "whether each element is not 0"),
    run(
        "boolArray",
        "bools_from_texts",
        &[of("values", TS)],
        BS,
        "whether each element is neither `f` nor `false` nor a zero",
    ),
    plain("stringArray", "no_texts", &[], TS, "an array without elements"),
    run("stringArray", "texts_from_floats", &[of("values", FS)], TS, "each element as text"),
    run("stringArray", "texts_from_bools", &[of("values", BS)], TS, "each element as text"),
];

/// Text.
pub(super) static TEXTS: &[Function] = &[
    plain("len", "len", &[INPUT], F, "how many characters"),
    run("find", "find", &[INPUT, MATCH, float("n")], F, "where an occurrence begins, or -1"),
    plain("count", "count", &[INPUT, MATCH], F, "how many occurrences"),
    run(
        "substring",
        "substring",
        &[INPUT, float("startPos"), float("endPos")],
        T,
        "the characters from one place up to another",
    ),
    run("splitString", "split_string", &[INPUT, text("delimiter")], TS, "the parts between delimiters"),
    run("replace", "replace", &[INPUT, OLD, text("newString")], T, "the text with every occurrence replaced"),
    run("replace", "replace", &[INPUT, OLD, float("newString")], T, "the text with every occurrence replaced"),
    run("replace", "replace", &[INPUT, OLD, boolean("newString")], T, "the text with every occurrence replaced"),
    plain("findFirst", "find_first", &[INPUT, MATCH], F, "the position of the first occurrence, or -1"),
    plain("findLast", "find_last", &[INPUT, MATCH], F, "where the last occurrence begins, or -1"),
    run("getPrefix", "get_prefix", &[INPUT, MATCH], T, "the text before the first occurrence"),
    run("getSuffix", "get_suffix", &[INPUT, MATCH], T, "the text after the last occurrence"),
    run(
        "getRange",
        "get_range",
        &[INPUT, text("leftMatchString"), text("rightMatchString")],
        T,
        "the text between two occurrences",
    ),
    run("fileBasename", "file_basename", &[PATH], T, "the name of a file without directory and extension"),
    run("fileDirectory", "file_directory", &[PATH], T, "the directory of a file"),
    run("fileExtension", "file_extension", &[PATH], T, "the extension of a file"),
    run("fileName", "file_name", &[PATH], T, "the name of a file with its extension"),
];

/// Lists in text.
pub(super) static LISTS: &[Function] = &[
    run("listAdd", "list_add", &[LIST, text("item")], T, "the list with one more item"),
    run("listClean", "list_clean", &[LIST], T, "the list without empty items"),
    plain("listCount", "list_count", &[LIST, SEARCH], F, "how many items match"),
    run("listFirst", "list_first", &[LIST], T, "the first item"),
    run("listFromArray", "list_from_array", &[of("array", FS)], T, "the elements as a list"),
    run("listFromArray", "list_from_array", &[of("array", BS)], T, "the elements as a list"),
    run("listFromArray", "list_from_array", &[of("array", TS)], T, "the elements as a list"),
    plain("listIndex", "list_index", &[LIST, SEARCH], F, "the number of the first item that matches, or -1"),
    run("listItem", "list_item", &[LIST, float("index")], T, "an item by its number"),
    run("listLast", "list_last", &[LIST], T, "the last item"),
    draw("listRandom", "list_random", &[LIST], T, Needs::Both, "an item by chance"),
    run(
        "listRange",
        "list_range",
        &[LIST, float("leftIndex"), float("rightIndex")],
        T,
        "the items from one number up to another",
    ),
    run("listRemove", "list_remove", &[LIST, SEARCH], T, "the list without the first item that matches"),
    run("listRemoveAll", "list_remove_all", &[LIST, SEARCH], T, "the list without the items that match"),
    run("listRetainAll", "list_retain_all", &[LIST, SEARCH], T, "the items that match"),
    plain("listSize", "list_size", &[LIST], F, "how many items"),
    run("listTerminate", "list_terminate", &[LIST], T, "the list with a `;` at its end"),
    run("listToArray", "list_to_array", &[LIST], TS, "the items as an array"),
];

/// Arrays.
pub(super) static ARRAYS: &[Function] = &[
    plain("size", "size", &[of("array", FS)], F, "the number of elements"),
    plain("size", "size", &[of("array", BS)], F, "the number of elements"),
    plain("size", "size", &[of("array", TS)], F, "the number of elements"),
    plain("nRows", "n_rows", &[of("array", FS)], F, "how many rows"),
    plain("nRows", "n_rows", &[of("array", BS)], F, "how many rows"),
    plain("nRows", "n_rows", &[of("array", TS)], F, "how many rows"),
    plain("nColumns", "n_columns", &[of("array", FS)], F, "how many columns"),
    plain("nColumns", "n_columns", &[of("array", BS)], F, "how many columns"),
    plain("nColumns", "n_columns", &[of("array", TS)], F, "how many columns"),
    plain("sum", "sum", &[of("array", FS)], F, "the sum of the elements"),
    plain("sum", "count_true", &[of("array", BS)], F, "the number of true elements"),
    run("sum", "join", &[of("array", TS)], T, "the elements joined in order"),
    plain("findFirst", "find_element", &[of("array", BS), boolean("value")], F, "the first index of a value, or -1"),
    plain("findFirst", "find_element", &[of("array", TS), text("value")], F, "the first index of a value, or -1"),
    run(
        "findFirst",
        "find_near",
        &[of("array", FS), float("value"), float("epsilon")],
        F,
        "the first index of a value, within a tolerance, or -1",
    ),
    run("sortIndices", "sort_indices", &[of("array", FS)], FS, "the places of the elements of each row, in order"),
    run("sortIndices", "sort_indices", &[of("array", TS)], FS, "the places of the elements of each row, in order"),
    run("sortRowIndices", "sort_row_indices", &[of("array", FS)], FS, "the numbers of the rows, in order"),
    run("sortRowIndices", "sort_row_indices", &[of("array", TS)], FS, "the numbers of the rows, in order"),
    run("transpose", "transpose", &[of("array", FS)], FS, "rows as columns"),
    run("transpose", "transpose", &[of("array", BS)], BS, "rows as columns"),
    run("transpose", "transpose", &[of("array", TS)], TS, "rows as columns"),
    old(
        run(
            "index",
            "find_near",
            &[of("array", FS), float("item"), or(float("epsilon"), Default::Float(0.0))],
            F,
            "the number of the first element within a tolerance of a value, or -1",
        ),
        INDEX,
    ),
    old(
        plain(
            "index",
            "find_element",
            &[of("array", BS), boolean("item")],
            F,
            "the index of the first element with a value, or -1",
        ),
        INDEX,
    ),
    old(
        plain(
            "index",
            "find_element",
            &[of("array", TS), text("item")],
            F,
            "the index of the first element with a value, or -1",
        ),
        INDEX,
    ),
];

/// Colours.
pub(super) static COLOURS: &[Function] = &[
    run("colorHexToR", "color_hex_to_r", &[HEX], F, "red of a colour such as \"#ff8000\""),
    run("colorHexToG", "color_hex_to_g", &[HEX], F, "green of a colour such as \"#ff8000\""),
    run("colorHexToB", "color_hex_to_b", &[HEX], F, "blue of a colour such as \"#ff8000\""),
    run("colorHexToH", "color_hex_to_h", &[HEX], F, "the hue in degrees of a colour such as \"#ff8000\""),
    run("colorHexToS", "color_hex_to_s", &[HEX], F, "the saturation of a colour such as \"#ff8000\""),
    run("colorHexToV", "color_hex_to_v", &[HEX], F, "the value of a colour such as \"#ff8000\""),
    run("colorHexToO", "color_hex_to_o", &[HEX], F, "the opacity of a colour such as \"#ff8000\""),
    run("colorRGBToHex", "color_rgb_to_hex", &[channel("red"), channel("green"), channel("blue")], T, RGB),
    run(
        "colorRGBOToHex",
        "color_rgbo_to_hex",
        &[channel("red"), channel("green"), channel("blue"), channel("opacity")],
        T,
        RGB,
    ),
    run("colorHSVToHex", "color_hsv_to_hex", &[float("hue"), float("saturation"), float("value")], T, HSV),
    run(
        "colorHSVOToHex",
        "color_hsvo_to_hex",
        &[float("hue"), float("saturation"), float("value"), channel("opacity")],
        T,
        HSV,
    ),
    run("colorRamp", "color_ramp", &[text("gradient"), float("value")], T, "a colour between the colours of a ramp"),
];

const RGB: &str = "the colour of red, green and blue, as in \"#FF8000\"";
const HSV: &str = "the colour of a hue, saturation and value, as in \"#FF8000\"";
