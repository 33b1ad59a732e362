//! The operations, by topic. Parameters have the names of the reference. A parameter with several types has a row for
//! each type.

mod creation;
mod flow;
mod manipulation;
mod roofs;
mod scope;
mod subdivision;
mod texturing;
mod transform;

use super::{Braces, Changes, Effect, Operation, Params, Str, Uses, UvEffect};

/// All operations.
pub static OPERATIONS: &[&[Operation]] = &[
    creation::ROWS,
    roofs::ROWS,
    subdivision::ROWS,
    manipulation::ROWS,
    texturing::ROWS,
    transform::ROWS,
    scope::ROWS,
    flow::ROWS,
];

/// `set` of an attribute of shapes whose name is computed (*sel function*). `set` is a word of the syntax, so the row is not in the table.
pub static SET_BY_NAME: Operation = op(
    "set",
    "set_by_name",
    &[super::text("selString"), super::param("value", super::ParamKind::Any)],
    "sets an attribute of the shape whose name is computed",
);

/// A row that the runtime function `call` implements.
const fn op(name: Str, call: Str, params: Params, about: Str) -> Operation {
    Operation {
        name,
        run: call,
        params,
        braces: Braces::None,
        scope: Effect::Any,
        uvs: UvEffect::Any,
        uses_base: false,
        uses: Uses::WHOLE,
        changes: Changes::Whole,
        tags: &[],
        recomposes: false,
        overloads: true,
        old: None,
        about,
    }
}

/// The row with another effect. Sets of texture coordinates stay with their geometry.
const fn with(scope: Effect, row: Operation) -> Operation {
    let uvs = if scope.keeps_geometry() { UvEffect::Keeps } else { row.uvs };
    Operation { scope, uvs, ..row }
}

/// The row with another effect on the sets of texture coordinates.
const fn uvs(uvs: UvEffect, row: Operation) -> Operation {
    Operation { uvs, ..row }
}

/// The row of an operation that keeps the size of the scope and its contents.
const fn keeps(row: Operation) -> Operation {
    with(Effect::Keeps, row)
}

/// The row with other uses.
const fn using(uses: Uses, row: Operation) -> Operation {
    Operation { uses, ..row }
}

/// The row of an operation that has the same effect in every place, in the coordinates of the scope.
const fn rigid(row: Operation) -> Operation {
    using(Uses::BODY, row)
}

/// The row of an operation that has the same effect in every place with the same orientation.
const fn upright(row: Operation) -> Operation {
    using(Uses::BODY.and(Uses::AXES), row)
}

/// The row of an operation that tags the components that it makes.
const fn tagging(tags: &'static [&'static str], row: Operation) -> Operation {
    Operation { tags, ..row }
}

/// The row of an operation whose result depends on tags of edges or vertices.
const fn reads_tags(row: Operation) -> Operation {
    using(row.uses.and(Uses::TAGS), row)
}

/// The row of an operation that only needs the scope and the material, and has the same effect in every place.
const fn slim(row: Operation) -> Operation {
    using(Uses::NONE, row)
}

/// The row of an operation that sets the material and reads nothing else.
const fn sets_material(row: Operation) -> Operation {
    Operation { changes: Changes::Material, ..keeps(slim(row)) }
}

/// The row of an operation with a second function for slim shapes.
const fn moves(row: Operation) -> Operation {
    Operation { changes: Changes::Scope, ..slim(row) }
}

/// The row of an operation that gives information to the run.
const fn says(row: Operation) -> Operation {
    Operation { changes: Changes::Nothing, ..keeps(using(Uses::SAYS, row)) }
}

/// The row of an operation that no rule overloads (*CGA changelog 2020.0*).
const fn alone(row: Operation) -> Operation {
    Operation { overloads: false, ..row }
}

/// A row with braces. `divides` or `joins` names its function.
const fn block(name: Str, braces: Braces, params: Params, about: Str) -> Operation {
    Operation { braces, ..op(name, "", params, about) }
}

/// A row with braces that divides the shape. The shape itself stays unchanged.
const fn divides(call: Str, uses: Uses, row: Operation) -> Operation {
    Operation { run: call, ..keeps(using(uses, row)) }
}

/// A row with operands, whose results become the shape.
const fn joins(call: Str, row: Operation) -> Operation {
    Operation { run: call, ..row }
}

/// The row of an operation that reconnects the shapes of its operands.
const fn recomposes(row: Operation) -> Operation {
    Operation { recomposes: true, ..row }
}

/// The row of an operation that only old files should have.
const fn old(row: Operation, instead: Str) -> Operation {
    Operation { old: Some(instead), ..row }
}
