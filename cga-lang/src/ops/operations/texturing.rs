//! Textures and texture coordinates. A uv set is a number from 0 to 9.

use super::super::{
    Default, Operation, Param, ParamKind, Uses, UvEffect, float, length, or, param, size, uv_set, word,
};
use super::{alone, keeps, old, op, sets_material, using, uvs};

const UV_SET: Param = uv_set("uvSet");

const AXES: Param = word(
    "axes",
    "ProjectionAxes",
    &[
        "scope.xy", "scope.xz", "scope.yx", "scope.yz", "scope.zx", "scope.zy", "world.xy", "world.xz", "world.yx",
        "world.yz", "world.zx", "world.zy",
    ],
);

const NORMALIZE_MODE: Param = word("normalizeMode", "NormalizeMode", &["uv", "uvUniform", "u", "v"]);

const NORMALIZE_TYPE: Param = word("normalizeType", "NormalizeType", &["separatePerFace", "collectiveAllFaces"]);

const WIDTH: Param = size("textureWidth");
const HEIGHT: Param = size("textureHeight");
const PROJECTION: &str = "defines how a texture is placed on the shape";

/// The row of an operation that reads texture coordinates, which may depend on the place in the world.
const fn reads_place(row: Operation) -> Operation {
    keeps(using(Uses::WHOLE.and(Uses::PLACE), row))
}

/// The row of an operation that sets up a projection.
const fn sets_up(row: Operation) -> Operation {
    uvs(UvEffect::SetsUp, keeps(row))
}

/// The row of an operation that changes a set of texture coordinates.
const fn changes(row: Operation) -> Operation {
    uvs(UvEffect::Changes, row)
}

pub(super) static ROWS: &[Operation] = &[
    sets_material(op("texture", "texture", &[param("filePath", ParamKind::Image(0))], "sets the colour map")),
    sets_up(alone(op("setupProjection", "setup_projection", &[UV_SET, AXES, WIDTH, HEIGHT], PROJECTION))),
    sets_up(alone(op(
        "setupProjection",
        "setup_projection_at",
        &[
            UV_SET,
            AXES,
            WIDTH,
            HEIGHT,
            length("widthOffset"),
            length("heightOffset"),
            or(float("uwFactor"), Default::Float(0.0)),
        ],
        PROJECTION,
    ))),
    old(
        sets_up(alone(op(
            "setupProjection",
            "setup_projection_uw",
            &[UV_SET, AXES, WIDTH, HEIGHT, float("uwFactor")],
            PROJECTION,
        ))),
        "write the offsets before the factor: `setupProjection(0, scope.xy, 1, 1, 0, 0, factor)`",
    ),
    uvs(
        UvEffect::Projects,
        sets_material(op(
            "projectUV",
            "project_uv",
            &[UV_SET],
            "writes the texture coordinates of the projection that was set up",
        )),
    ),
    changes(sets_material(op(
        "translateUV",
        "translate_uv",
        &[UV_SET, float("uOffset"), float("vOffset")],
        "moves texture coordinates",
    ))),
    changes(sets_material(op(
        "scaleUV",
        "scale_uv",
        &[UV_SET, float("uFactor"), float("vFactor")],
        "multiplies texture coordinates",
    ))),
    changes(sets_material(op(
        "rotateUV",
        "rotate_uv",
        &[UV_SET, float("angle")],
        "turns texture coordinates about their origin, in degrees",
    ))),
    changes(reads_place(op(
        "normalizeUV",
        "normalize_uv",
        &[UV_SET, NORMALIZE_MODE, NORMALIZE_TYPE],
        "fits texture coordinates between 0 and 1",
    ))),
    changes(alone(reads_place(op(
        "tileUV",
        "tile_uv",
        &[UV_SET, WIDTH, HEIGHT],
        "scales texture coordinates to tiles of a size",
    )))),
    uvs(UvEffect::Deletes, sets_material(op("deleteUV", "delete_uv", &[UV_SET], "removes texture coordinates"))),
    uvs(
        UvEffect::Copies,
        sets_material(op(
            "copyUV",
            "copy_uv",
            &[uv_set("uvSetSource"), uv_set("uvSetDest")],
            "copies texture coordinates to another set",
        )),
    ),
    // No reference page has these any more; the parameters are taken from old rule files.
    old(
        sets_up(op(
            "setupUV",
            "setup_uv",
            &[UV_SET, float("textureWidth"), float("textureHeight"), float("uwFactor")],
            PROJECTION,
        )),
        "write `setupProjection(…)` and `projectUV(…)`",
    ),
    old(
        uvs(
            UvEffect::Projects,
            sets_material(op("bakeUV", "project_uv", &[UV_SET], "writes the texture coordinates that were set up")),
        ),
        "write `projectUV(…)`, and `setupProjection(…)` before it",
    ),
    old(
        changes(sets_material(op(
            "offsetUV",
            "translate_uv",
            &[UV_SET, float("uOffset"), float("vOffset")],
            "moves texture coordinates",
        ))),
        "write `translateUV(…)`",
    ),
];
