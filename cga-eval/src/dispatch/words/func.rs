//! The words of parameters and selectors.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use cga_runtime::rt::func;

/// A word of `AngleType`.
pub(crate) fn func_angle_type(word: &str) -> Option<func::AngleType> {
    Some(match word {
        "azimuth" => func::AngleType::Azimuth,
        "maxSlope" => func::AngleType::MaxSlope,
        "zenith" => func::AngleType::Zenith,
        _ => return None,
    })
}

/// A word of `AssetDimension`.
pub(crate) fn func_asset_dimension(word: &str) -> Option<func::AssetDimension> {
    Some(match word {
        "sx" => func::AssetDimension::Sx,
        "sy" => func::AssetDimension::Sy,
        "sz" => func::AssetDimension::Sz,
        "tx" => func::AssetDimension::Tx,
        "ty" => func::AssetDimension::Ty,
        "tz" => func::AssetDimension::Tz,
        _ => return None,
    })
}

/// A word of `AssetNaming`.
pub(crate) fn func_asset_naming(word: &str) -> Option<func::AssetNaming> {
    Some(match word {
        "g" => func::AssetNaming::Groups,
        "m" => func::AssetNaming::Materials,
        _ => return None,
    })
}

/// A word of `Axis`.
pub(crate) fn func_axis(word: &str) -> Option<func::Axis> {
    Some(match word {
        "x" => func::Axis::X,
        "y" => func::Axis::Y,
        "z" => func::Axis::Z,
        _ => return None,
    })
}

/// A word of `ContextComparison`.
pub(crate) fn func_context_comparison(word: &str) -> Option<func::ContextComparison> {
    Some(match word {
        "area.largest" => func::ContextComparison::AreaLargest,
        "area.smallest" => func::ContextComparison::AreaSmallest,
        "world.easternmost" => func::ContextComparison::WorldEasternmost,
        "world.highest" => func::ContextComparison::WorldHighest,
        "world.lowest" => func::ContextComparison::WorldLowest,
        "world.northernmost" => func::ContextComparison::WorldNorthernmost,
        "world.southernmost" => func::ContextComparison::WorldSouthernmost,
        "world.westernmost" => func::ContextComparison::WorldWesternmost,
        _ => return None,
    })
}

/// A word of `ConvertWhat`.
pub(crate) fn func_convert_what(word: &str) -> Option<func::ConvertWhat> {
    Some(match word {
        "orient" => func::ConvertWhat::Orient,
        "pos" => func::ConvertWhat::Pos,
        _ => return None,
    })
}

/// A word of `GeoCoordinate`.
pub(crate) fn func_geo_coordinate(word: &str) -> Option<func::GeoCoordinate> {
    Some(match word {
        "X" => func::GeoCoordinate::X,
        "Y" => func::GeoCoordinate::Y,
        "lat" => func::GeoCoordinate::Lat,
        "lon" => func::GeoCoordinate::Lon,
        _ => return None,
    })
}

/// A word of `ImageAxes`.
pub(crate) fn func_image_axes(word: &str) -> Option<func::ImageAxes> {
    Some(match word {
        "xy" => func::ImageAxes::Xy,
        "xz" => func::ImageAxes::Xz,
        "yx" => func::ImageAxes::Yx,
        "yz" => func::ImageAxes::Yz,
        "zx" => func::ImageAxes::Zx,
        "zy" => func::ImageAxes::Zy,
        _ => return None,
    })
}

/// A word of `ImageDimension`.
pub(crate) fn func_image_dimension(word: &str) -> Option<func::ImageDimension> {
    Some(match word {
        "sx" => func::ImageDimension::Sx,
        "sy" => func::ImageDimension::Sy,
        _ => return None,
    })
}

/// A word of `MaterialMode`.
pub(crate) fn func_material_mode(word: &str) -> Option<func::MaterialMode> {
    Some(match word {
        "all" => func::MaterialMode::All,
        "changed" => func::MaterialMode::Changed,
        _ => return None,
    })
}

/// A word of `MaterialSource`.
pub(crate) fn func_material_source(word: &str) -> Option<func::MaterialSource> {
    Some(match word {
        "geometry" => func::MaterialSource::Geometry,
        "shape" => func::MaterialSource::Shape,
        "used" => func::MaterialSource::Used,
        _ => return None,
    })
}

/// A word of `QueryTarget`.
pub(crate) fn func_query_target(word: &str) -> Option<func::QueryTarget> {
    Some(match word {
        "all" => func::QueryTarget::All,
        "inter" => func::QueryTarget::Inter,
        "intra" => func::QueryTarget::Intra,
        _ => return None,
    })
}

/// A word of `RatioAxes`.
pub(crate) fn func_ratio_axes(word: &str) -> Option<func::RatioAxes> {
    Some(match word {
        "xy" => func::RatioAxes::Xy,
        "xyz" => func::RatioAxes::Xyz,
        "xz" => func::RatioAxes::Xz,
        "yz" => func::RatioAxes::Yz,
        _ => return None,
    })
}

/// A word of `SizeAxes`.
pub(crate) fn func_size_axes(word: &str) -> Option<func::SizeAxes> {
    Some(match word {
        "x" => func::SizeAxes::X,
        "xy" => func::SizeAxes::Xy,
        "xyz" => func::SizeAxes::Xyz,
        "xz" => func::SizeAxes::Xz,
        "y" => func::SizeAxes::Y,
        "yz" => func::SizeAxes::Yz,
        "z" => func::SizeAxes::Z,
        _ => return None,
    })
}

/// A word of `Subcomponent`.
pub(crate) fn func_subcomponent(word: &str) -> Option<func::Subcomponent> {
    Some(match word {
        "e" => func::Subcomponent::Edges,
        "v" => func::Subcomponent::Vertices,
        _ => return None,
    })
}

/// A word of `System`.
pub(crate) fn func_system(word: &str) -> Option<func::System> {
    Some(match word {
        "object" => func::System::Object,
        "pivot" => func::System::Pivot,
        "scope" => func::System::Scope,
        "world" => func::System::World,
        _ => return None,
    })
}

/// A word of `TaggedComponents`.
pub(crate) fn func_tagged_components(word: &str) -> Option<func::TaggedComponents> {
    Some(match word {
        "all" => func::TaggedComponents::All,
        "edges" => func::TaggedComponents::Edges,
        "faces" => func::TaggedComponents::Faces,
        "vertices" => func::TaggedComponents::Vertices,
        _ => return None,
    })
}

/// A word of `TextureSpace`.
pub(crate) fn func_texture_space(word: &str) -> Option<func::TextureSpace> {
    Some(match word {
        "unitSpace" => func::TextureSpace::Unit,
        "uvSpace" => func::TextureSpace::Uv,
        _ => return None,
    })
}

/// A word of `Word`.
pub(crate) fn func_word(word: &str) -> Option<func::Word> {
    Some(match word {
        "all" => func::Word::All,
        "back" => func::Word::Back,
        "bottom" => func::Word::Bottom,
        "front" => func::Word::Front,
        "left" => func::Word::Left,
        "noStreetSide" => func::Word::NotStreetFront,
        "object.back" => func::Word::ObjectBack,
        "object.bottom" => func::Word::ObjectBottom,
        "object.front" => func::Word::ObjectFront,
        "object.left" => func::Word::ObjectLeft,
        "object.right" => func::Word::ObjectRight,
        "object.side" => func::Word::ObjectSide,
        "object.top" => func::Word::ObjectTop,
        "right" => func::Word::Right,
        "side" => func::Word::Side,
        "street.back" => func::Word::StreetBack,
        "street.front" => func::Word::StreetFront,
        "street.left" => func::Word::StreetLeft,
        "street.right" => func::Word::StreetRight,
        "street.side" => func::Word::StreetSide,
        "streetSide" => func::Word::StreetFront,
        "surface" => func::Word::All,
        "top" => func::Word::Top,
        "world.down" => func::Word::WorldDown,
        "world.east" => func::Word::WorldEast,
        "world.north" => func::Word::WorldNorth,
        "world.side" => func::Word::WorldSide,
        "world.south" => func::Word::WorldSouth,
        "world.up" => func::Word::WorldUp,
        "world.west" => func::Word::WorldWest,
        _ => return None,
    })
}
