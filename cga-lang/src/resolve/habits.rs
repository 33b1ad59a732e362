//! Names from other languages, other programs and everyday speech, with their CGA forms.

/// Operations with names that CGA does not have.
const STEPS: &[(&[&str], &str)] = &[
    (&["scale", "resize"], "`s(sx, sy, sz)` sets the size of the scope"),
    (&["translate", "move"], "`t(tx, ty, tz)` moves the scope along its own axes"),
    (&["rotate", "turn"], "`r(xAngle, yAngle, zAngle)` turns the scope"),
    (&["insert", "load"], "`i(\"file.obj\")` inserts a model"),
    (&["cube", "box", "primitiveBox"], "`primitiveCube()` makes a box"),
    (&["sphere"], "`primitiveSphere()` makes a sphere"),
    (&["cylinder"], "`primitiveCylinder()` makes a cylinder"),
    (&["cone"], "`primitiveCone()` makes a cone"),
    (&["hipRoof", "roofHipped"], "`roofHip(angle)` builds a hip roof"),
    (&["gableRoof", "roofGabled"], "`roofGable(angle)` builds a gable roof"),
    (&["shedRoof"], "`roofShed(angle)` builds a shed roof"),
    (&["roofFlat", "flatRoof"], "`extrude(height)` makes a level roof"),
    (&["subdiv", "subdivide", "divide"], "`split(x) { size : … | size : … }` divides the shape"),
    (&["repeat", "for", "while", "loop"], "`split(x) { { ~size : … }* }` repeats a slot"),
    (&["if", "If", "IF"], "write `case condition : … else : …`"),
    (&["match", "switch", "select"], "write `case value == 1 : … case value == 2 : … else : …`"),
];

/// The CGA form of an operation with another name in other languages.
pub(crate) fn step(name: &str) -> Option<&'static str> {
    STEPS.iter().find(|(names, _)| names.contains(&name)).map(|(_, help)| *help)
}

/// Attributes of the scope with names that CGA does not have.
const VALUES: &[(&str, &str)] = &[
    ("scope.width", "scope.sx"),
    ("scope.height", "scope.sy"),
    ("scope.depth", "scope.sz"),
    ("scope.length", "scope.sx"),
    ("pi", "3.14159265"),
    ("PI", "3.14159265"),
];

/// The CGA form of a value with another name in other languages.
pub(crate) fn value(name: &str) -> Option<&'static str> {
    let own = name.strip_prefix("this.").unwrap_or(name);
    VALUES.iter().find(|(name, _)| *name == own).map(|(_, meant)| *meant)
}

/// The sizes and positions of the scope that an attribute of another language may mean.
const SIZES_OR_PLACES: &[(&str, [&str; 2])] = &[
    ("scope.x", ["scope.sx", "scope.tx"]),
    ("scope.y", ["scope.sy", "scope.ty"]),
    ("scope.z", ["scope.sz", "scope.tz"]),
];

/// The size and the position that a value with another name may mean.
pub(crate) fn size_or_place(name: &str) -> Option<[&'static str; 2]> {
    SIZES_OR_PLACES.iter().find(|(own, _)| *own == name).map(|(_, meant)| *meant)
}

/// Colours by their English names.
const COLOURS: &[(&str, &str)] = &[
    ("black", "#000000"),
    ("white", "#ffffff"),
    ("red", "#ff0000"),
    ("green", "#008000"),
    ("blue", "#0000ff"),
    ("yellow", "#ffff00"),
    ("orange", "#ffa500"),
    ("brown", "#a52a2a"),
    ("gray", "#808080"),
    ("grey", "#808080"),
    ("pink", "#ffc0cb"),
    ("purple", "#800080"),
    ("cyan", "#00ffff"),
    ("magenta", "#ff00ff"),
    ("beige", "#f5f5dc"),
];

/// The colour with that name, as text.
pub(crate) fn colour(name: &str) -> Option<&'static str> {
    COLOURS.iter().find(|(own, _)| name.eq_ignore_ascii_case(own)).map(|(_, hex)| *hex)
}

#[cfg(test)]
mod tests {
    use super::{SIZES_OR_PLACES, STEPS, VALUES};
    use crate::ops;

    /// A row with a name of CGA would never be found, or would mislead.
    #[test]
    fn names_are_not_those_of_cga_and_what_they_lead_to_is() {
        // These two names exist in CGA with more arguments.
        let longer = ["translate", "rotate"];
        for name in STEPS.iter().flat_map(|(names, _)| *names).filter(|name| !longer.contains(name)) {
            assert!(ops::operations(name).next().is_none(), "{name}");
        }
        for (name, meant) in VALUES {
            assert!(ops::shape_attr(name).is_none(), "{name}");
            assert!(ops::shape_attr(meant).is_some() || meant.parse::<f64>().is_ok(), "{meant}");
        }
        for (name, meant) in SIZES_OR_PLACES {
            assert!(ops::shape_attr(name).is_none(), "{name}");
            assert!(meant.iter().all(|meant| ops::shape_attr(meant).is_some()), "{meant:?}");
        }
    }
}
