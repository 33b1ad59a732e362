//! Operations that change the faces of a mesh and keep its form, or nearly so.
//!
//! Tolerances, shares and angles have digits that lengths and counts of the grammars do not have. At the limit itself rounding
//! decides.

/// Operations that merge, divide, straighten and shade faces.
pub(super) const MESHES: &[&str] = &[
    "cleanupGeometry(all, 0)",
    "cleanupGeometry(all, 0.0417)",
    "cleanupGeometry(all, c)",
    "cleanupGeometry(vertices, 0.8713)",
    "cleanupGeometry(edges, 0.1913)",
    "cleanupGeometry(faces, 0.5177)",
    "reduceGeometry(0.1371)",
    "reduceGeometry(0.4173)",
    "rectify(7.31)",
    "rectify(33.7)",
    "convexify()",
    "convexify()",
    "convexify($N)",
    "setNormals(soft)",
    "setNormals(auto)",
    "setNormals(hard)",
    "setNormals(conform)",
    "softenNormals(61.3)",
    "softenNormals(101.7)",
    "deleteHoles()",
];
