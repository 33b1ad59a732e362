//! Colours and materials, labels, reports. `set` has a syntax of its own.

use super::super::{Allowed, B, Default, F, HEX, Operation, Param, ParamBounds, ParamKind, T, TS, Uses};
use super::super::{bounds, channel, of, or, param, text, within, word};
use super::{keeps, old, op, rigid, says, sets_material, using};

const TARGET: Param = or(word("target", "MaterialTarget", &["shape", "geometry", "all"]), Default::Word("shape"));

/// *label operation*.
static LABELS: ParamBounds = bounds(Allowed::NotEmpty, "a label is not empty");

const REPORT: &str = "adds a value to a collection of the run";

pub(super) static ROWS: &[Operation] = &[
    sets_material(op("color", "color_hex", &[HEX], "sets the colour, as in \"#ff8000\"")),
    sets_material(op(
        "color",
        "color_rgb",
        &[channel("red"), channel("green"), channel("blue")],
        "sets the colour, with channels from 0 to 1",
    )),
    sets_material(op(
        "color",
        "color_rgba",
        &[channel("red"), channel("green"), channel("blue"), channel("opacity")],
        "sets the colour and the opacity, with channels from 0 to 1",
    )),
    // The reference has no page since 2020.0; it was short for `set` (*opacity operation*, 2019.1).
    old(
        sets_material(op("opacity", "opacity", &[channel("opacity")], "sets the opacity, from 0 to 1")),
        "write `set(material.opacity, …)`",
    ),
    keeps(rigid(op(
        "setMaterial",
        "set_material",
        &[of("material", TS)],
        "sets several attributes of the material, by names and values",
    ))),
    keeps(rigid(op(
        "resetMaterial",
        "reset_material",
        &[TARGET],
        "gives the attributes of the material their defaults again",
    ))),
    // Queries of other shapes find the copy.
    using(
        Uses::LABELS,
        says(op(
            "label",
            "label",
            &[within(text("label"), &LABELS)],
            "leaves a labelled copy of the shape for queries",
        )),
    ),
    using(Uses::REPORTS, says(op("report", "report", &[text("key"), of("value", F)], REPORT))),
    using(Uses::REPORTS, says(op("report", "report", &[text("key"), of("value", B)], REPORT))),
    using(Uses::REPORTS, says(op("report", "report", &[text("key"), of("value", T)], REPORT))),
    says(op("print", "print", &[param("value", ParamKind::Any)], "shows a value")),
];
