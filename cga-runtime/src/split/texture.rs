//! Splits in texture space: along lines of constant texture coordinates (*split operation*).

use std::borrow::Cow;
use std::ops::ControlFlow;
use std::sync::Arc;

use cga_split::{Item, Piece, Size, solve};

use super::divide::{check, listed};
use super::division::Made;
use super::parts::PieceBorders;
use crate::fault::FaultKind;
use crate::geometry::cut;
use crate::geometry::mesh::uv::spread;
use crate::geometry::mesh::{Mesh, TextureSpace, UvAxis};
use crate::geometry::unbent::without_bent_faces;
use crate::run::env::Env;
use crate::shape::{Geometry, Placed, Shape, ShapeRef};

/// The coordinate, the unit and the uv set of a split in texture space.
pub(crate) type TextureAxis = (UvAxis, TextureSpace, f64);

/// The pieces of a split in texture space, and their shapes. The split is from the smallest to the largest
/// coordinate. Without coordinates in the set there are no pieces, and a fault. If all coordinates are equal, there
/// are no pieces. `Break` when a limit is reached.
pub(super) fn texture(
    env: &mut Env,
    shape: &ShapeRef<'_>,
    (axis, space, set): TextureAxis,
    pattern: &[Item],
    sizes: &mut [Size],
    lengths: &mut [f64],
) -> ControlFlow<(), (Vec<Piece>, Made)> {
    check(env, sizes, "a size of `split`");
    let none = ControlFlow::Continue((Vec::new(), Made::nothing()));
    let Some(set) = env.uv_set(set, "split") else { return none };
    let mut whole = env.whole(shape);
    whole.bake();
    env.divide_trace(&mut whole);
    let Geometry::Mesh(placed) = &whole.geometry else {
        missing(env, set);
        return none;
    };
    let Some(extent) = placed.mesh.uv_extent(usize::from(set), placed.stretch(whole.scope.size)) else {
        missing(env, set);
        return none;
    };
    if spread([extent.low, extent.high])[axis.index()] == 0.0 {
        return none;
    }
    let length = match space {
        TextureSpace::Uv => extent.size()[axis.index()],
        TextureSpace::Unit => extent.metres[axis.index()],
    };
    if !(0.0 < length && length.is_finite()) {
        return none;
    }
    let pieces = listed(env, &solve(pattern, sizes, lengths, length));
    let line = |distance: f64| match space {
        TextureSpace::Uv => extent.low[axis.index()] + distance,
        TextureSpace::Unit => extent.at_metres(axis, distance),
    };
    let borders = PieceBorders::of(&pieces[..], length, extent.high[axis.index()], line);
    let most = env.corners_left(1);
    let flat = match without_bent_faces(&placed.mesh) {
        Cow::Borrowed(_) => placed.mesh.clone(),
        Cow::Owned(flat) => Arc::new(flat),
    };
    let Ok((mut bands, points)) = cut::traced_iso_bands(&flat, usize::from(set), axis, &borders.rising, most) else {
        return env.too_many_corners(1);
    };
    for (band, points) in bands.iter_mut().zip(&points) {
        if let Some(band) = band {
            env.with_cut_trace(&flat, band, points);
        }
    }
    let mut parts = Vec::new();
    for mesh in borders.one_a_piece(env, bands)? {
        let mut part = part(&whole, placed, mesh);
        env.begin_part(&mut part);
        parts.push(env.base(part));
    }
    ControlFlow::Continue((pieces, Made::of(parts)))
}

#[cold]
fn missing(env: &mut Env, set: u8) {
    env.fault(FaultKind::Geometry, format!("the shape has no texture coordinates in set {set}: it is not split"));
}

/// A part of the shape; its scope is the box of the mesh.
fn part(whole: &Shape, placed: &Placed, mesh: Option<Arc<Mesh>>) -> Shape {
    let mut part = Shape { geometry: Geometry::Empty, ..whole.clone() };
    let Some(mesh) = mesh else { return part };
    let own = Placed { mirrored: placed.mirrored, ..Placed::fitted(mesh) };
    let stretch = placed.stretch(whole.scope.size);
    part.scope.origin += whole.scope.axes * ((own.low - placed.low) * stretch);
    part.scope.size = own.size * stretch;
    part.geometry = Geometry::Mesh(Arc::new(own));
    part
}
