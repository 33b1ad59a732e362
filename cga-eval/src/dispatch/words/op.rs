//! The words of parameters and selectors.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use cga_runtime::rt::op;

/// A word of `Align`.
pub(crate) fn op_align(word: &str) -> Option<op::Align> {
    Some(match word {
        "noAlign" => op::Align::Keep,
        "zUp" => op::Align::ZUp,
        _ => return None,
    })
}

/// A word of `AlignAuto`.
pub(crate) fn op_align_auto(word: &str) -> Option<op::AlignAuto> {
    Some(match word {
        "auto" => op::AlignAuto::Auto,
        _ => return None,
    })
}

/// A word of `AlignAxes`.
pub(crate) fn op_align_axes(word: &str) -> Option<op::AlignAxes> {
    Some(match word {
        "object.x" => op::AlignAxes::ObjectX,
        "object.xyz" => op::AlignAxes::ObjectXyz,
        "object.y" => op::AlignAxes::ObjectY,
        "object.z" => op::AlignAxes::ObjectZ,
        "world.x" => op::AlignAxes::WorldX,
        "world.xyz" => op::AlignAxes::WorldXyz,
        "world.y" => op::AlignAxes::WorldY,
        "world.z" => op::AlignAxes::WorldZ,
        "x" => op::AlignAxes::WorldX,
        "y" => op::AlignAxes::WorldY,
        "z" => op::AlignAxes::WorldZ,
        _ => return None,
    })
}

/// A word of `AlignEdge`.
pub(crate) fn op_align_edge(word: &str) -> Option<op::AlignEdge> {
    Some(match word {
        "longest" => op::AlignEdge::Longest,
        "world.lowest" => op::AlignEdge::WorldLowest,
        _ => return None,
    })
}

/// A word of `AlignFace`.
pub(crate) fn op_align_face(word: &str) -> Option<op::AlignFace> {
    Some(match word {
        "any" => op::AlignFace::Any,
        "largest" => op::AlignFace::Largest,
        "world.lowest" => op::AlignFace::WorldLowest,
        _ => return None,
    })
}

/// A word of `AxisMap`.
pub(crate) fn op_axis_map(word: &str) -> Option<op::AxisMap> {
    Some(match word {
        "xyz" => op::AxisMap::Xyz,
        "yzx" => op::AxisMap::Yzx,
        "zxy" => op::AxisMap::Zxy,
        _ => return None,
    })
}

/// A word of `BoxAxes`.
pub(crate) fn op_box_axes(word: &str) -> Option<op::BoxAxes> {
    Some(match word {
        "xy" => op::BoxAxes::Xy,
        "xz" => op::BoxAxes::Xz,
        "yx" => op::BoxAxes::Yx,
        "yz" => op::BoxAxes::Yz,
        "zx" => op::BoxAxes::Zx,
        "zy" => op::BoxAxes::Zy,
        _ => return None,
    })
}

/// A word of `CenterAxes`.
pub(crate) fn op_center_axes(word: &str) -> Option<op::CenterAxes> {
    Some(match word {
        "x" => op::CenterAxes::X,
        "xy" => op::CenterAxes::Xy,
        "xyz" => op::CenterAxes::Xyz,
        "xz" => op::CenterAxes::Xz,
        "y" => op::CenterAxes::Y,
        "yz" => op::CenterAxes::Yz,
        "z" => op::CenterAxes::Z,
        _ => return None,
    })
}

/// A word of `CleanupComponents`.
pub(crate) fn op_cleanup_components(word: &str) -> Option<op::CleanupComponents> {
    Some(match word {
        "all" => op::CleanupComponents::All,
        "edges" => op::CleanupComponents::Edges,
        "faces" => op::CleanupComponents::Faces,
        "vertices" => op::CleanupComponents::Vertices,
        _ => return None,
    })
}

/// A word of `CleanupMode`.
pub(crate) fn op_cleanup_mode(word: &str) -> Option<op::CleanupMode> {
    Some(match word {
        "noCleanup" => op::CleanupMode::NoCleanup,
        "numericalCleanup" => op::CleanupMode::NumericalCleanup,
        _ => return None,
    })
}

/// A word of `Components`.
pub(crate) fn op_components(word: &str) -> Option<op::Components> {
    Some(match word {
        "e" => op::Components::Edges,
        "f" => op::Components::Faces,
        "fe" => op::Components::FaceEdges,
        "fv" => op::Components::FaceVertices,
        "g" => op::Components::Groups,
        "h" => op::Components::Holes,
        "m" => op::Components::Materials,
        "v" => op::Components::Vertices,
        _ => return None,
    })
}

/// A word of `Distribution`.
pub(crate) fn op_distribution(word: &str) -> Option<op::Distribution> {
    Some(match word {
        "gaussian" => op::Distribution::Gaussian,
        "uniform" => op::Distribution::Uniform,
        _ => return None,
    })
}

/// A word of `EnvelopeAlong`.
pub(crate) fn op_envelope_along(word: &str) -> Option<op::EnvelopeAlong> {
    Some(match word {
        "normal" => op::EnvelopeAlong::Normal,
        "world.up" => op::EnvelopeAlong::WorldUp,
        _ => return None,
    })
}

/// A word of `ExtrudeAlong`.
pub(crate) fn op_extrude_along(word: &str) -> Option<op::ExtrudeAlong> {
    Some(match word {
        "face.normal" => op::ExtrudeAlong::FaceNormal,
        "vertex.normal" => op::ExtrudeAlong::VertexNormal,
        "world.up" => op::ExtrudeAlong::WorldUp,
        "world.up.flatTop" => op::ExtrudeAlong::WorldUpFlatTop,
        "world.y" => op::ExtrudeAlong::WorldUp,
        _ => return None,
    })
}

/// A word of `ExtrudeAxis`.
pub(crate) fn op_extrude_axis(word: &str) -> Option<op::ExtrudeAxis> {
    Some(match word {
        "world.x" => op::ExtrudeAxis::WorldX,
        "world.z" => op::ExtrudeAxis::WorldZ,
        "x" => op::ExtrudeAxis::X,
        "y" => op::ExtrudeAxis::Y,
        "z" => op::ExtrudeAxis::Z,
        _ => return None,
    })
}

/// A word of `HeightAlignment`.
pub(crate) fn op_height_alignment(word: &str) -> Option<op::HeightAlignment> {
    Some(match word {
        "alignPosition" => op::HeightAlignment::AlignPosition,
        "keepPosition" => op::HeightAlignment::KeepPosition,
        _ => return None,
    })
}

/// A word of `HeightDirection`.
pub(crate) fn op_height_direction(word: &str) -> Option<op::HeightDirection> {
    Some(match word {
        "scope.y" => op::HeightDirection::ScopeY,
        "vertex.normal" => op::HeightDirection::VertexNormal,
        _ => return None,
    })
}

/// A word of `InsertMode`.
pub(crate) fn op_insert_mode(word: &str) -> Option<op::InsertMode> {
    Some(match word {
        "alignSizeAndPosition" => op::InsertMode::AlignSizeAndPosition,
        "keepSizeAlignPosition" => op::InsertMode::KeepSizeAlignPosition,
        "keepSizeAndPosition" => op::InsertMode::KeepSizeAndPosition,
        _ => return None,
    })
}

/// A word of `MaterialTarget`.
pub(crate) fn op_material_target(word: &str) -> Option<op::MaterialTarget> {
    Some(match word {
        "all" => op::MaterialTarget::All,
        "geometry" => op::MaterialTarget::Geometry,
        "shape" => op::MaterialTarget::Shape,
        _ => return None,
    })
}

/// A word of `MergeStrategy`.
pub(crate) fn op_merge_strategy(word: &str) -> Option<op::MergeStrategy> {
    Some(match word {
        "append" => op::MergeStrategy::Append,
        "recompose" => op::MergeStrategy::Recompose,
        "unify" => op::MergeStrategy::Unify,
        _ => return None,
    })
}

/// A word of `NormalizeMode`.
pub(crate) fn op_normalize_mode(word: &str) -> Option<op::NormalizeMode> {
    Some(match word {
        "u" => op::NormalizeMode::U,
        "uv" => op::NormalizeMode::Uv,
        "uvUniform" => op::NormalizeMode::UvUniform,
        "v" => op::NormalizeMode::V,
        _ => return None,
    })
}

/// A word of `NormalizeType`.
pub(crate) fn op_normalize_type(word: &str) -> Option<op::NormalizeType> {
    Some(match word {
        "collectiveAllFaces" => op::NormalizeType::CollectiveAllFaces,
        "separatePerFace" => op::NormalizeType::SeparatePerFace,
        _ => return None,
    })
}

/// A word of `NormalsMode`.
pub(crate) fn op_normals_mode(word: &str) -> Option<op::NormalsMode> {
    Some(match word {
        "auto" => op::NormalsMode::Auto,
        "conform" => op::NormalsMode::Conform,
        "hard" => op::NormalsMode::Hard,
        "soft" => op::NormalsMode::Soft,
        _ => return None,
    })
}

/// A word of `OffsetFaces`.
pub(crate) fn op_offset_faces(word: &str) -> Option<op::OffsetFaces> {
    Some(match word {
        "all" => op::OffsetFaces::All,
        "border" => op::OffsetFaces::Border,
        "inside" => op::OffsetFaces::Inside,
        _ => return None,
    })
}

/// A word of `ProjectionAxes`.
pub(crate) fn op_projection_axes(word: &str) -> Option<op::ProjectionAxes> {
    Some(match word {
        "scope.xy" => op::ProjectionAxes::ScopeXy,
        "scope.xz" => op::ProjectionAxes::ScopeXz,
        "scope.yx" => op::ProjectionAxes::ScopeYx,
        "scope.yz" => op::ProjectionAxes::ScopeYz,
        "scope.zx" => op::ProjectionAxes::ScopeZx,
        "scope.zy" => op::ProjectionAxes::ScopeZy,
        "world.xy" => op::ProjectionAxes::WorldXy,
        "world.xz" => op::ProjectionAxes::WorldXz,
        "world.yx" => op::ProjectionAxes::WorldYx,
        "world.yz" => op::ProjectionAxes::WorldYz,
        "world.zx" => op::ProjectionAxes::WorldZx,
        "world.zy" => op::ProjectionAxes::WorldZy,
        _ => return None,
    })
}

/// A word of `RectangleAlignment`.
pub(crate) fn op_rectangle_alignment(word: &str) -> Option<op::RectangleAlignment> {
    Some(match word {
        "edge" => op::RectangleAlignment::Edge,
        "scope" => op::RectangleAlignment::Scope,
        _ => return None,
    })
}

/// A word of `RoofValue`.
pub(crate) fn op_roof_value(word: &str) -> Option<op::RoofValue> {
    Some(match word {
        "byAngle" => op::RoofValue::ByAngle,
        "byHeight" => op::RoofValue::ByHeight,
        _ => return None,
    })
}

/// A word of `RotateAbout`.
pub(crate) fn op_rotate_about(word: &str) -> Option<op::RotateAbout> {
    Some(match word {
        "scopeCenter" => op::RotateAbout::ScopeCenter,
        "scopeOrigin" => op::RotateAbout::ScopeOrigin,
        _ => return None,
    })
}

/// A word of `ScatterDomain`.
pub(crate) fn op_scatter_domain(word: &str) -> Option<op::ScatterDomain> {
    Some(match word {
        "scope" => op::ScatterDomain::Scope,
        "surface" => op::ScatterDomain::Surface,
        "volume" => op::ScatterDomain::Volume,
        _ => return None,
    })
}

/// A word of `ScatterMean`.
pub(crate) fn op_scatter_mean(word: &str) -> Option<op::ScatterMean> {
    Some(match word {
        "back" => op::ScatterMean::Back,
        "bottom" => op::ScatterMean::Bottom,
        "center" => op::ScatterMean::Center,
        "front" => op::ScatterMean::Front,
        "left" => op::ScatterMean::Left,
        "right" => op::ScatterMean::Right,
        "top" => op::ScatterMean::Top,
        _ => return None,
    })
}

/// A word of `SwapMode`.
pub(crate) fn op_swap_mode(word: &str) -> Option<op::SwapMode> {
    Some(match word {
        "noSwap" => op::SwapMode::NoSwap,
        "swap" => op::SwapMode::Swap,
        _ => return None,
    })
}

/// A word of `System`.
pub(crate) fn op_system(word: &str) -> Option<op::System> {
    Some(match word {
        "object" => op::System::Object,
        "pivot" => op::System::Pivot,
        "scope" => op::System::Scope,
        "world" => op::System::World,
        _ => return None,
    })
}

/// A word of `TagTarget`.
pub(crate) fn op_tag_target(word: &str) -> Option<op::TagTarget> {
    Some(match word {
        "auto" => op::TagTarget::Auto,
        "edges" => op::TagTarget::Edges,
        "faces" => op::TagTarget::Faces,
        "vertices" => op::TagTarget::Vertices,
        _ => return None,
    })
}

/// A word of `TaggedComponents`.
pub(crate) fn op_tagged_components(word: &str) -> Option<op::TaggedComponents> {
    Some(match word {
        "all" => op::TaggedComponents::All,
        "edges" => op::TaggedComponents::Edges,
        "faces" => op::TaggedComponents::Faces,
        "vertices" => op::TaggedComponents::Vertices,
        _ => return None,
    })
}

/// A word of `TransformMode`.
pub(crate) fn op_transform_mode(word: &str) -> Option<op::TransformMode> {
    Some(match word {
        "abs" => op::TransformMode::Abs,
        "rel" => op::TransformMode::Rel,
        _ => return None,
    })
}

/// A word of `UpAxis`.
pub(crate) fn op_up_axis(word: &str) -> Option<op::UpAxis> {
    Some(match word {
        "yUp" => op::UpAxis::YUp,
        "zUp" => op::UpAxis::ZUp,
        _ => return None,
    })
}
