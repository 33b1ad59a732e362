//! Steps that change the current shape, and the values in them.

use super::masses::MASSES;
use super::meshes::MESHES;
use super::{Here, Writer};

/// Operations. Those that make boxes and rectangles, or ask much of them, come more often.
const STEPS: &[&str] = &[
    "extrude($D)",
    "extrude($D)",
    "extrude($D)",
    "extrude(face.normal, $D)",
    "extrude(vertex.normal, $D)",
    "extrude(world.up, $D)",
    "extrude(world.up.flatTop, $D)",
    "s($S, $S, $S)",
    "s($S, $S, $S)",
    "s('1, '1, $S)",
    "s('1, $S, '1)",
    "set(scope.s$X, $L)",
    "set(scope.s$X, -scope.s$X)",
    "t($T, $T, $T)",
    "set(scope.t$X, $L)",
    "r($A, $A, $A)",
    "r(0, $A, 0)",
    "r(scopeCenter, $A, $A, $A)",
    "r(scopeCenter, 0, $A, 0)",
    "set(scope.r$X, $A)",
    "center($C)",
    "translate($R, $Y, $L, $L, $L)",
    "rotate($R, $Y, $A, $A, $A)",
    "rotate(rel, $Y, 0, $A, 0)",
    "setPivot($V, $K)",
    "setPivot($V, $K)",
    "set(pivot.p$X, $L)",
    "set(pivot.o$X, $A)",
    "rotateScope($Q, $Q, $Q)",
    "rotateScope(0, $Q, 0)",
    "rotateScope($A, $A, $A)",
    "mirrorScope($B, $B, $B)",
    "mirror($B, $B, $B)",
    "reverseNormals()",
    "alignScopeToAxes()",
    "alignScopeToAxes(world.$X)",
    "alignScopeToAxes(object.$X)",
    "alignScopeToAxes(object.xyz)",
    "alignScopeToGeometry($U, $I, $I)",
    "alignScopeToGeometry($U, $G, $I)",
    "alignScopeToGeometry($U, $I, $E)",
    "alignScopeToGeometry($U, any, $E)",
    "alignScopeToGeometryBBox($P)",
    "offset($O)",
    "offset($O, $H)",
    "primitiveCube()",
    "primitiveCube()",
    "primitiveCube($N, $N, $N)",
    "primitiveQuad()",
    "primitiveQuad($N, $N)",
    "i(\"builtin:cube\")",
    "trim()",
    "set(trim.vertical, $B)",
    "set(trim.horizontal, $B)",
    "color(\"#ff8000\")",
    "color(0.2, c, 0.7)",
    "set(material.name, \"m\" + split.index)",
    "tag(\"mark.$X\", $m)",
    "tag(\"mark.$X\", $m)",
    "deleteTags(\"$J\")",
    "deleteTags(\"$J\", $z)",
    "deleteTags()",
    "setTagsFromEdgeAttrs()",
    "extrude($X, $D)",
    "extrude(world.x, $D)",
    "i(\"rough\")",
    "i(\"rough\", zUp)",
    "i(\"rough\", yUp, keepSizeAndPosition)",
    "i(\"rough\", zUp, keepSizeAlignPosition, noCleanup)",
    "alignScopeToGeometry($U, $I)",
    "alignScopeToGeometry($U, auto)",
    "color(0.2, c, 0.7, 0.5)",
    "opacity(0.7)",
    "setMaterial([\"color.r\", \"0.5\", \"opacity\", \"0.7\"])",
    "resetMaterial()",
    "resetMaterial(all)",
    "label(\"here\")",
    "resetGeometry()",
];

/// Primitives with few sides, so that what follows takes little time.
const ROUND: &[&str] = &[
    "primitiveDisk(7)",
    "primitiveDisk(6, b)",
    "primitiveSphere(5, 4)",
    "primitiveSphere(6, 3, b)",
    "primitiveCylinder(7)",
    "primitiveCylinder(5, b, a)",
    "primitiveCone(6)",
    "primitiveCone(5, b, a)",
    "primitiveSphere()",
    "primitiveCylinder()",
];

/// Reports.
pub(super) const REPORTS: &[&str] = &[
    "report(\"area\", geometry.area)",
    "report(\"volume.\" + comp.sel, geometry.volume)",
    "report(\"faces\", geometry.nFaces)",
    "report(\"closed\", geometry.isClosedSurface)",
    "report(\"width\", scope.sx)",
    "report(\"sel\", comp.sel)",
    "report(\"edges\", sum(comp(e) { all : scope.sx }))",
    "report(\"tops\", sum(comp(f) { top : geometry.area }))",
];

impl Writer {
    /// Some operations.
    pub(super) fn steps(&mut self, here: Here) {
        for _ in 0..*self.random.pick(&[0, 1, 1, 2, 2, 3]) {
            if self.chance(25) {
                self.texture(here);
                continue;
            }
            let list = match self.random.below(100) {
                0..12 => MASSES,
                12..20 => MESHES,
                20..24 => ROUND,
                _ => STEPS,
            };
            let step = self.fill(list);
            self.line(here, &step);
        }
    }

    /// A length in metres with enough digits to differ from every other.
    fn length(&mut self) -> String {
        let most = *self.random.pick(&[1_0000, 4_0000, 8_0000]);
        format!("{}", (500 + self.random.below(most)) as f64 / 1e4)
    }

    /// The value of a kind.
    pub(super) fn value(&mut self, kind: &str) -> String {
        let list: &[&str] = match kind {
            // Lengths.
            "L" if self.chance(50) => return self.length(),
            "L" => &[
                "a",
                "b",
                "c + 0.217",
                "a * b",
                "rand(0.31, 3.17)",
                "split.index * 0.313 + 0.177",
                "scope.sx * 0.2371",
            ],
            // Positive numbers of primitives.
            "N" if self.chance(40) => &["a", "b"],
            "N" => return self.length(),
            // Sizes.
            "S" => match self.random.below(10) {
                0..3 => &["'1"],
                3..6 => &["'0.6317", "'1.373", "'0.4291", "'c"],
                6 => &["'(-0.8317)", "-1.713", "-b", "'(-1)", "0", "'0"],
                _ => return self.length(),
            },
            // Distances of extrusions.
            "D" if self.chance(20) => &["-0.8317", "-b", "0", "'0.37", "'(-0.2137)", "c"],
            "D" => return self.length(),
            // Translations.
            "T" => &["0", "0", "0.417", "-1.933", "'0.5", "'(-0.317)", "'1", "a"],
            // Any angles.
            "A" => &["0", "0", "90", "180", "-90", "270", "17.31", "-33.7", "a * 7", "61.3"],
            // Quarter turns.
            "Q" => &["0", "0", "90", "180", "-90", "270"],
            "B" => &["true", "false", "on"],
            "X" => &["x", "y", "z"],
            "C" => &["x", "y", "z", "xy", "xz", "yz", "xyz"],
            "R" => &["rel", "rel", "abs"],
            "Y" => &["scope", "pivot", "object", "world"],
            "V" => &["xyz", "yzx", "zxy"],
            "K" => &["0", "1", "2", "3", "4", "5", "6", "7"],
            "I" => &["0", "0", "1", "2", "3", "4", "5"],
            "U" => &["yUp", "zUp"],
            "G" => &["world.lowest", "largest"],
            "E" => &["world.lowest", "longest"],
            "P" => &["xy", "yx", "xz", "zx", "yz", "zy"],
            "H" => &["all", "inside", "border"],
            "O" => &["-0.1731", "0.2317", "-c", "-0.0417", "1.119", "0"],
            // Distances of setbacks and overhangs.
            "M" => &["0.0713", "0.2317", "0.5171", "c", "1.237"],
            // Angles of roofs and slopes.
            "Z" => &["30", "45", "17.31", "61.7", "80"],
            // Directions of components.
            "F" => &[
                "front",
                "front",
                "back",
                "left",
                "right",
                "top",
                "top",
                "bottom",
                "side",
                "side",
                "vertical",
                "horizontal",
                "aslant",
                "nutant",
                "object.front",
                "object.back",
                "object.left",
                "object.right",
                "object.top",
                "object.bottom",
                "object.side",
                "world.south",
                "world.north",
                "world.west",
                "world.east",
                "world.up",
                "world.down",
                "world.side",
                "street.front",
                "street.back",
                "street.left",
                "street.side",
                "border",
                "inside",
            ],
            // Directions that `geometry.isOriented` knows.
            "W" => &["front", "back", "left", "right", "top", "side", "object.front", "world.up", "street.front"],
            // Tags.
            "J" if self.chance(40) => &["mark", "mark.x", "mark.?", "*.z", "setback.front", "setback"],
            "J" => &[
                "extrude.*",
                "extrude.top",
                "extrude.bottom",
                "extrude.side",
                "extrude",
                "*.outer",
                "roof.top",
                "roof.side",
                "envelope.side",
                "taper.*",
            ],
            // Components with tags.
            "m" => &["auto", "faces", "edges", "vertices"],
            "z" => &["all", "faces", "edges", "vertices"],
            other => unreachable!("no values of kind {other}"),
        };
        (*self.random.pick(list)).to_owned()
    }
}
