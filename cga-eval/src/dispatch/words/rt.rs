//! The words of parameters and selectors.
//!
//! Generated from the tables of `cga-lang`; write it again with `CGA_BLESS=1 cargo test -p cga-lang --test dispatch`.

use cga_runtime::rt;

/// A word of `Adjust`.
pub(crate) fn rt_adjust(word: &str) -> Option<rt::Adjust> {
    Some(match word {
        "adjust" => rt::Adjust::Adjust,
        "noAdjust" => rt::Adjust::NoAdjust,
        _ => return None,
    })
}

/// A word of `Align`.
pub(crate) fn rt_align(word: &str) -> Option<rt::Align> {
    Some(match word {
        "noAlign" => rt::Align::Keep,
        "zUp" => rt::Align::ZUp,
        _ => return None,
    })
}

/// A word of `Axis`.
pub(crate) fn rt_axis(word: &str) -> Option<rt::Axis> {
    Some(match word {
        "x" => rt::Axis::X,
        "y" => rt::Axis::Y,
        "z" => rt::Axis::Z,
        _ => return None,
    })
}

/// A word of `Components`.
pub(crate) fn rt_components(word: &str) -> Option<rt::Components> {
    Some(match word {
        "e" => rt::Components::Edges,
        "f" => rt::Components::Faces,
        "fe" => rt::Components::FaceEdges,
        "fv" => rt::Components::FaceVertices,
        "g" => rt::Components::Groups,
        "h" => rt::Components::Holes,
        "m" => rt::Components::Materials,
        "v" => rt::Components::Vertices,
        _ => return None,
    })
}

/// A word of `TextureSpace`.
pub(crate) fn rt_texture_space(word: &str) -> Option<rt::TextureSpace> {
    Some(match word {
        "unitSpace" => rt::TextureSpace::Unit,
        "uvSpace" => rt::TextureSpace::Uv,
        _ => return None,
    })
}

/// A word of `UvAxis`.
pub(crate) fn rt_uv_axis(word: &str) -> Option<rt::UvAxis> {
    Some(match word {
        "u" => rt::UvAxis::U,
        "v" => rt::UvAxis::V,
        _ => return None,
    })
}

/// A word that selects components.
pub(crate) fn rt_word(word: &str) -> Option<rt::Word> {
    Some(match word {
        "all" => rt::Word::All,
        "aslant" => rt::Word::Aslant,
        "back" => rt::Word::Back,
        "border" => rt::Word::Border,
        "bottom" => rt::Word::Bottom,
        "eave" => rt::Word::Eave,
        "front" => rt::Word::Front,
        "hip" => rt::Word::Hip,
        "horizontal" => rt::Word::Horizontal,
        "inside" => rt::Word::Inside,
        "left" => rt::Word::Left,
        "nutant" => rt::Word::Nutant,
        "object.back" => rt::Word::ObjectBack,
        "object.bottom" => rt::Word::ObjectBottom,
        "object.front" => rt::Word::ObjectFront,
        "object.left" => rt::Word::ObjectLeft,
        "object.right" => rt::Word::ObjectRight,
        "object.side" => rt::Word::ObjectSide,
        "object.top" => rt::Word::ObjectTop,
        "remainder" => rt::Word::Remainder,
        "ridge" => rt::Word::Ridge,
        "right" => rt::Word::Right,
        "shape" => rt::Word::Shape,
        "side" => rt::Word::Side,
        "street.back" => rt::Word::StreetBack,
        "street.front" => rt::Word::StreetFront,
        "street.left" => rt::Word::StreetLeft,
        "street.right" => rt::Word::StreetRight,
        "street.side" => rt::Word::StreetSide,
        "top" => rt::Word::Top,
        "uv.bottom" => rt::Word::UvBottom,
        "uv.left" => rt::Word::UvLeft,
        "uv.right" => rt::Word::UvRight,
        "uv.top" => rt::Word::UvTop,
        "uv.uMax" => rt::Word::UvUMax,
        "uv.uMin" => rt::Word::UvUMin,
        "uv.vMax" => rt::Word::UvVMax,
        "uv.vMin" => rt::Word::UvVMin,
        "valley" => rt::Word::Valley,
        "vertical" => rt::Word::Vertical,
        "world.down" => rt::Word::WorldDown,
        "world.east" => rt::Word::WorldEast,
        "world.north" => rt::Word::WorldNorth,
        "world.side" => rt::Word::WorldSide,
        "world.south" => rt::Word::WorldSouth,
        "world.up" => rt::Word::WorldUp,
        "world.west" => rt::Word::WorldWest,
        _ => return None,
    })
}
