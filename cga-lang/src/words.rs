//! Words of the full language that are not supported yet, so that a message can tell them from a misspelling.

/// Annotations whose arguments are read.
pub(crate) const READ_ANNOTATIONS: &[&str] =
    &["StartRule", "Range", "Group", "Order", "Hidden", "Description", "Allow", "Warn", "Deny"];

/// Every annotation of the language. Those that are not read only describe how an attribute is shown.
pub(crate) const ANNOTATIONS: &[&str] = &[
    "StartRule",
    "Range",
    "Group",
    "Order",
    "Hidden",
    "Description",
    "Allow",
    "Warn",
    "Deny",
    "Enum",
    "Angle",
    "Percent",
    "Distance",
    "Color",
    "File",
    "Directory",
    "MaterialFile",
    "DisplayName",
    "RuleFileDescription",
    "Handle",
    "InPolygon",
    "InMesh",
    "InLine",
    "InPoint",
    "InPointCloud",
    "Out",
];

/// Operations of the full language that have no row in the table yet.
pub(crate) const LATER_OPERATIONS: &[&str] = &[
    "alignScopeToAxes",
    "alignScopeToGeometry",
    "alignScopeToGeometryBBox",
    "bakeUV",
    "cleanupGeometry",
    "convexify",
    "copyUV",
    "deleteHoles",
    "deleteTags",
    "deleteUV",
    "envelope",
    "footprint",
    "inline",
    "innerRect",
    "innerRectangle",
    "innerCircle",
    "insertAlongUV",
    "intersect",
    "label",
    "mirror",
    "mirrorScope",
    "modify",
    "normalizeUV",
    "offset",
    "offsetUV",
    "outerRectangle",
    "polygonize",
    "primitiveCone",
    "primitiveDisk",
    "primitiveSphere",
    "print",
    "projectUV",
    "rectangle",
    "reduceGeometry",
    "report",
    "resetGeometry",
    "resetMaterial",
    "reverseNormals",
    "roofGable",
    "roofHip",
    "roofPyramid",
    "roofRidge",
    "roofShed",
    "rotate",
    "rotateScope",
    "rotateUV",
    "scaleUV",
    "scatter",
    "setback",
    "setbackPerEdge",
    "setbackToArea",
    "setMaterial",
    "setNormals",
    "setPivot",
    "setTags",
    "setTagsByAngle",
    "setupProjection",
    "setupUV",
    "shapeL",
    "shapeO",
    "shapeU",
    "softenNormals",
    "splitAndSetbackPerimeter",
    "splitArea",
    "subtract",
    "tag",
    "taper",
    "tileUV",
    "translate",
    "translateUV",
    "trim",
    "union",
];

/// Functions of the full language that have no row in the table yet.
pub(crate) const LATER_FUNCTIONS: &[&str] = &[
    "assetApproxRatio",
    "assetApproxSize",
    "assetBestRatio",
    "assetBestSize",
    "assetFitSize",
    "assetInfo",
    "assetMetadata",
    "assetNamingInfo",
    "assetNamingInfos",
    "assetsSortRatio",
    "assetsSortSize",
    "boolArray",
    "colorHSVOToHex",
    "colorHSVToHex",
    "colorHexToB",
    "colorHexToG",
    "colorHexToH",
    "colorHexToO",
    "colorHexToR",
    "colorHexToS",
    "colorHexToV",
    "colorRGBOToHex",
    "colorRGBToHex",
    "colorRamp",
    "comp",
    "contextCompare",
    "contextCount",
    "convert",
    "count",
    "fileBasename",
    "fileDirectory",
    "fileExists",
    "fileExtension",
    "fileName",
    "fileRandom",
    "fileSearch",
    "filesSearch",
    "find",
    "findFirst",
    "findLast",
    "floatArray",
    "getGeoCoord",
    "getMaterial",
    "getPrefix",
    "getRange",
    "getSuffix",
    "getTreeKey",
    "imageApproxRatio",
    "imageBestRatio",
    "imageInfo",
    "imagesSortRatio",
    "index",
    "inside",
    "isNull",
    "isTagged",
    "len",
    "listAdd",
    "listClean",
    "listCount",
    "listFirst",
    "listFromArray",
    "listIndex",
    "listItem",
    "listLast",
    "listRandom",
    "listRange",
    "listRemove",
    "listRemoveAll",
    "listRetainAll",
    "listSize",
    "listTerminate",
    "listToArray",
    "minimumDistance",
    "nColumns",
    "nRows",
    "overlaps",
    "print",
    "readFloatTable",
    "readMaterial",
    "readStringTable",
    "readTextFile",
    "replace",
    "sel",
    "setElems",
    "size",
    "sortIndices",
    "sortRowIndices",
    "splitString",
    "stringArray",
    "substring",
    "sum",
    "touches",
    "transpose",
];

/// First parts of dotted names of the full language.
const LATER_PREFIXES: &[&str] =
    &["scope", "pivot", "initialShape", "split", "comp", "trim", "material", "geometry", "edgeAttr", "street"];

/// Component selectors that are not supported yet; so are all that begin with `object.`, `world.` and `street.`.
pub(crate) const LATER_SELECTORS: &[&str] =
    &["border", "inside", "eave", "hip", "valley", "ridge", "isTagged", "streetSide", "noStreetSide"];

/// Whether it is an operation of the full language only.
pub(crate) fn is_later_operation(name: &str) -> bool {
    LATER_OPERATIONS.contains(&name)
}

/// Whether it is a function of the full language only.
pub(crate) fn is_later_function(name: &str) -> bool {
    LATER_FUNCTIONS.contains(&name) || is_later_dotted(name, &["geometry", "edgeAttr"])
}

/// Whether it is an attribute of shapes in the full language only. Those of the table are looked up before.
pub(crate) fn is_later_attribute(name: &str) -> bool {
    name == "seedian" || is_later_shape_attribute(name)
}

fn is_later_shape_attribute(name: &str) -> bool {
    // In these groups every name is in the table already, so that another one is a misspelling.
    !is_later_dotted(name, &["scope", "split", "comp"]) && is_later_dotted(name, LATER_PREFIXES)
}

/// Whether it is a selector of the full language only.
pub(crate) fn is_later_selector(name: &str) -> bool {
    LATER_SELECTORS.contains(&name) || is_later_dotted(name, &["object", "world", "street"])
}

fn is_later_dotted(name: &str, prefixes: &[&str]) -> bool {
    name.split_once('.').is_some_and(|(first, _)| prefixes.contains(&first))
}
