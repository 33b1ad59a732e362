//! The functions.

use super::base::function;
use super::{
    Allowed, B, Default, F, Function, Needs, Param, ParamBounds, Params, Str, T, TAG_QUERY, TS, Uses, bounds, choice,
    or, queries, renamed, set_elements, text, values, within, word,
};
use crate::types::Type;

/// All functions. `str`, `floatArray` and similar conversions of a value that already has the type are the value
/// itself, and `str` of a float or bool is [`ToText`](crate::ir::ExprKind::ToText). These need no row.
pub static FUNCTIONS: &[&[Function]] = &[
    values::CHANCE,
    values::MATH,
    values::CONVERSIONS,
    values::TEXTS,
    values::LISTS,
    values::ARRAYS,
    values::COLOURS,
    set_elements::FLOAT,
    set_elements::FLOATS,
    set_elements::BOOL,
    set_elements::BOOLS,
    set_elements::TEXT,
    set_elements::TEXTS,
    queries::GEOMETRY,
    queries::TEXTURE,
    queries::SHAPES,
    queries::FILES,
    TAGS,
    CONTEXT,
    GEOMETRY,
    choice::SORTED,
    choice::CHOSEN,
    choice::CONTENTS,
    REST,
];

/// A query of the tags of a component.
const fn asked(name: Str, call: Str, params: Params, about: Str) -> Function {
    let uses = Uses::WHOLE.and(Uses::TAGS);
    Function { needs: Needs::Component, uses, ..function(name, call, params, B, about) }
}

/// *contextCompare*, *contextCount* and *minimumDistance function*.
static LABELS: ParamBounds =
    ParamBounds { result: Some("no shape has an empty label"), ..bounds(Allowed::NotEmpty, "a label is not empty") };

const LABEL: Param = within(text("label"), &LABELS);

const TARGET: Param = word("target", "QueryTarget", &["intra", "inter", "all"]);

/// Without a target, `all` is used (*occlusion queries*).
const OPTIONAL_TARGET: Param = or(TARGET, Default::Word("all"));

/// An empty label means no label.
const OPTIONAL_LABEL: Param = or(text("label"), Default::Text(""));

const COMPARISON: Param = word(
    "comparisonType",
    "ContextComparison",
    &[
        "world.northernmost",
        "world.southernmost",
        "world.easternmost",
        "world.westernmost",
        "world.highest",
        "world.lowest",
        "area.largest",
        "area.smallest",
    ],
);

const GEO_COORDINATE: Param = word("geoCoordinate", "GeoCoordinate", &["X", "Y", "lon", "lat"]);

const EDGE_ATTRIBUTE: Params = &[text("attributeName")];

/// An attribute of the initial shape's edges.
const fn edge_attr(name: Str, call: Str, ty: Type) -> Function {
    let about = "an attribute of the initial shape's edge that the shape faces";
    let uses = Uses::WHOLE.and(Uses::PLACE).and(Uses::SAYS);
    Function { needs: Needs::Both, uses, ..function(name, call, EDGE_ATTRIBUTE, ty, about) }
}

/// A query of other shapes.
const fn asks(name: Str, call: Str, uses: Uses, params: Params, ty: Type, about: Str) -> Function {
    Function { needs: Needs::Both, uses, ..function(name, call, params, ty, about) }
}

/// A query of other closed shapes.
const fn occlusion(name: Str, about: Str) -> Function {
    asks(name, name, Uses::OCCLUSION, &[OPTIONAL_TARGET, OPTIONAL_LABEL], B, about)
}

/// Other shapes, the edges of the initial shape, and the place of a shape on Earth.
static CONTEXT: &[Function] = &[
    occlusion("inside", "whether the shape is inside another closed shape"),
    occlusion("overlaps", "whether the shape is partly inside another closed shape"),
    occlusion("touches", "whether the shape touches another closed shape"),
    asks(
        "minimumDistance",
        "minimum_distance",
        Uses::CONTEXT,
        &[TARGET, LABEL],
        F,
        "the distance to the nearest shape of a label",
    ),
    asks(
        "contextCompare",
        "context_compare",
        Uses::CONTEXT,
        &[TARGET, LABEL, COMPARISON],
        F,
        "the rank among the shapes of a label",
    ),
    asks("contextCount", "context_count", Uses::CONTEXT, &[TARGET, LABEL], F, "how many shapes have a label"),
    edge_attr("edgeAttr.getFloat", "edge_attr_float", F),
    edge_attr("edgeAttr.getString", "edge_attr_string", T),
    edge_attr("edgeAttr.getBool", "edge_attr_bool", B),
    asks(
        "getGeoCoord",
        "get_geo_coord",
        Uses::PLACE.and(Uses::SAYS),
        &[GEO_COORDINATE],
        F,
        "a coordinate of the scope's origin on the map",
    ),
    Function {
        needs: Needs::Env,
        ..asks(
            "getTreeKey",
            "get_tree_key",
            Uses::TREE_KEY,
            &[],
            T,
            "the way from the initial shape to this one, as a list of numbers",
        )
    },
];

const TAGGED: Param =
    or(word("components", "TaggedComponents", &["all", "faces", "edges", "vertices"]), Default::Word("all"));

/// The subcomponents that `isTagged` tests instead of the component itself.
const SUBCOMPONENT: Param =
    renamed(&[("e", "Edges"), ("v", "Vertices")], word("subcomponent", "Subcomponent", &["e", "v"]));

/// A query of the tags of the geometry.
const fn tags(name: Str, call: Str, params: Params, ty: Type, about: Str) -> Function {
    let uses = Uses::WHOLE.and(Uses::TAGS);
    Function { needs: Needs::Shape, uses, ..function(name, call, params, ty, about) }
}

/// The row of a query whose result counts for the limits of the run.
const fn counted(row: Function) -> Function {
    Function { needs: Needs::Both, ..row }
}

/// Tags of geometry.
static GEOMETRY: &[Function] = &[
    counted(tags("geometry.tags", "geometry_tags", &[], TS, "the tags of the components, in order")),
    counted(tags("geometry.tags", "geometry_tags_of", &[TAG_QUERY, TAGGED], TS, "the tags that match, in order")),
    tags("geometry.hasTags", "geometry_has_tags", &[], B, "whether components have tags"),
    tags(
        "geometry.hasTags",
        "geometry_has_tags_of",
        &[TAG_QUERY, TAGGED],
        B,
        "whether components have tags that match",
    ),
];

/// Tags in selectors (*comp operation*).
static TAGS: &[Function] = &[
    asked("isTagged", "is_tagged", &[TAG_QUERY], "whether a component has a tag that matches"),
    asked(
        "isTagged",
        "is_tagged_at",
        &[TAG_QUERY, SUBCOMPONENT],
        "whether an edge or vertex of a component has a tag that matches",
    ),
];

/// Words from text.
static REST: &[Function] = &[Function {
    pure: true,
    ..function("sel", "text_to_text", &[text("selString")], T, "a word from text, where a word is required")
}];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn rows_of_one_name_differ_in_their_kinds() {
        let mut seen = HashSet::new();
        for row in FUNCTIONS.iter().copied().flatten() {
            let kinds: Vec<String> = row.params.iter().map(|param| format!("{:?}", param.kind)).collect();
            assert!(seen.insert((row.name, kinds)), "{row:?}");
            assert!(!row.about.is_empty(), "{row:?}");
        }
    }
}
