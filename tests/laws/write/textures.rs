//! Texture coordinates: operations, conditions and splits. Sets 0 to 2 are enough for sets to meet.

use super::{Here, Writer};

/// Operations that make coordinates; `?` is the number of a set.
const PROJECTIONS: &[&str] = &[
    "projectUV(?)",
    "projectUV(?)",
    "setupProjection(?, $J, $M, $M) projectUV(?)",
    "setupProjection(?, scope.xy, $M, $M) projectUV(?)",
    "setupProjection(?, scope.xy, '1, '1) projectUV(?)",
    "setupProjection(?, scope.xy, 1.5, 1, 0, 0, 1) projectUV(?)",
    "setupProjection(?, $J, $M, $M, 0.217, '0.3, 1) projectUV(?)",
    "setupProjection(?, $J, $M, $M, -1.3, 2.1)",
    "setupProjection(?, $J, $M, $M)",
    "setupProjection(?, scope.xy, $M, $M)",
    "setupProjection(?, scope.xy, 1.5, 1, 1) bakeUV(?)",
    "setupUV(?, 1.713, 1.3, 1) projectUV(?)",
];

/// Operations that change coordinates.
const CHANGES: &[&str] = &[
    "translateUV(?, 0.317, -0.21)",
    "translateUV(?, c, a)",
    "scaleUV(?, 2, -0.5)",
    "scaleUV(?, 0.7, b)",
    "rotateUV(?, $A)",
    "copyUV(?, $Z)",
    "copyUV(0, 1)",
    "deleteUV(?)",
    "normalizeUV(?, $H, separatePerFace)",
    "normalizeUV(?, $H, collectiveAllFaces)",
    "tileUV(?, $M, $M)",
    "primitiveCube()",
    "primitiveQuad()",
    "primitiveCylinder(5)",
    "texture(\"wall.png\")",
    "offsetUV(?, 0.317, -0.21)",
    "insertAlongUV(?, \"tree\", 0.317)",
    "insertAlongUV(?, \"rough\", a, vertex.normal, keepPosition)",
];

/// Copies of an asset along coordinates. The ranges end at whole numbers up to rounding, or well between them.
const ALONG: &[&str] = &[
    "setupProjection(?, scope.xy, ~1.3, '1) projectUV(?) insertAlongUV(?, \"tree\", 0.317)",
    "setupProjection(?, scope.xy, ~2, ~1.7) projectUV(?) insertAlongUV(?, \"rough\", 0.217, vertex.normal, $K)",
    "setupProjection(?, $J, '0.371, '0.713) projectUV(?) insertAlongUV(?, \"rough\", a, scope.y, $K)",
    "projectUV(?) normalizeUV(?, $H, collectiveAllFaces) insertAlongUV(?, \"rough\", 0.417, scope.y, $K)",
    "projectUV(?) normalizeUV(?, uv, separatePerFace) insertAlongUV(?, \"tree\", 0.171, vertex.normal, $K)",
    "projectUV(?) tileUV(?, ~1.7, ~1.3) insertAlongUV(?, \"builtin:cube\", 0.317, vertex.normal, $K)",
    "scaleUV(?, 2.3, 1.7) insertAlongUV(?, \"tree\", 0.5)",
];

/// Conditions on coordinates, away from the values that are common.
const CONDITIONS: &[&str] = &[
    "geometry.hasUVs(?)",
    "geometry.hasUVs()",
    "geometry.uMax(?) > 1.3717",
    "geometry.vMin(?) < -0.1331",
    "geometry.du(?, uvSpace) > 1.7313",
    "geometry.dv(?, unitSpace) > 2.1773",
];

/// Heads of splits.
const SPLITS: &[&str] =
    &["split(u, uvSpace, ?)", "split(v, uvSpace, ?)", "split(u, unitSpace, ?)", "split(v, unitSpace, ?)"];

impl Writer {
    fn of_set(&mut self, templates: &[&str]) -> String {
        let set = *self.random.pick(&["0", "0", "0", "1", "1", "2"]);
        let templates: Vec<String> = templates.iter().map(|text| text.replace('$', "@")).collect();
        let template = self.random.pick(&templates).replace('?', set);
        let mut parts = template.split('@');
        let mut text = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            text += self.texture_value(&part[..1]);
            text += &part[1..];
        }
        text
    }

    fn texture_value(&mut self, kind: &str) -> &'static str {
        let list: &[&'static str] = match kind {
            "J" => &[
                "scope.xy", "scope.xz", "scope.yx", "scope.yz", "scope.zx", "scope.zy", "world.xy", "world.xz",
                "world.yx", "world.yz", "world.zx", "world.zy",
            ],
            "M" => &["1", "1.713", "-0.917", "~1.3", "~2", "'1", "'0.371", "'(-0.7)", "0", "a", "~b"],
            "A" => &["90", "180", "17.31", "a * 7", "-90"],
            "H" => &["uv", "uvUniform", "u", "v"],
            "K" => &["alignPosition", "keepPosition"],
            "Z" => &["0", "1", "2", "9"],
            other => unreachable!("no values of kind {other}"),
        };
        self.random.pick::<&'static str>(list)
    }

    /// An operation on coordinates.
    pub(super) fn texture(&mut self, here: Here) {
        // Templates keep what follows from a projection that is set up above them.
        let step = match self.random.below(10) {
            0..3 if 2 < here.rule => self.of_set(&["projectUV(?)"]),
            0..6 => self.of_set(PROJECTIONS),
            6 | 7 if 2 < here.rule => self.of_set(&CHANGES[..8]),
            8 if self.chance(50) => self.of_set(ALONG),
            _ => self.of_set(CHANGES),
        };
        self.line(here, &step);
    }

    /// A condition on coordinates.
    pub(super) fn texture_condition(&mut self) -> String {
        self.of_set(CONDITIONS)
    }

    /// The beginning of a split in texture space.
    pub(super) fn texture_split(&mut self) -> String {
        self.of_set(SPLITS)
    }
}
