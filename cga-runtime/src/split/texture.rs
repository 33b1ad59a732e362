//! Splits in texture space: along lines of constant texture coordinates (*split operation*).

use std::ops::ControlFlow;
use std::sync::Arc;

use cga_split::{Item, Piece, Size, solve};

use super::divide::{check, listed};
use super::division::Made;
use super::parts::Borders;
use crate::fault::{FaultKind, LimitKind};
use crate::geometry::cut;
use crate::geometry::mesh::uv::spread;
use crate::geometry::mesh::{Mesh, TextureSpace, UvAxis, UvExtent};
use crate::run::env::Env;
use crate::shape::base::Base;
use crate::shape::{Geometry, Placed, Shape, ShapeRef};

/// The coordinate, the unit and the uv set of a split in texture space.
pub(crate) type TextureAxis = (UvAxis, TextureSpace, f64);

/// The pieces of a split in texture space, and their shapes. The split is from the smallest to the largest
/// coordinate. Without coordinates in the set there are no pieces, and a fault. If all coordinates are equal, there
/// are no pieces. `Break` when a limit is reached.
pub fn texture<const N: usize>(
    env: &mut Env,
    shape: &ShapeRef<'_>,
    (axis, space, set): TextureAxis,
    pattern: &[Item],
    mut sizes: [Size; N],
) -> ControlFlow<(), (Vec<Piece>, Made)> {
    let mut lengths = [0.0; N];
    check(env, &mut sizes, "a size of `split`");
    let none = ControlFlow::Continue((Vec::new(), Made::nothing()));
    let Some(set) = env.uv_set(set, "split") else { return none };
    let mut whole = env.whole(shape);
    whole.bake();
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
    let pieces = listed(env, &solve(pattern, &sizes, &mut lengths, length));
    let chart = Chart { extent, axis, space, set: usize::from(set) };
    let bands = chart.bands(env, &placed.mesh, length, &pieces)?;
    let parts: Vec<Base> = bands.into_iter().map(|mesh| env.base(part(&whole, placed, mesh))).collect();
    ControlFlow::Continue((pieces, Made::of(parts)))
}

#[cold]
fn missing(env: &mut Env, set: u8) {
    env.fault(FaultKind::Geometry, format!("the shape has no texture coordinates in set {set}: it is not split"));
}

/// The coordinate of a mesh along which it is split.
struct Chart {
    extent: UvExtent,
    axis: UvAxis,
    space: TextureSpace,
    set: usize,
}

impl Chart {
    /// The coordinate at a distance from the smallest one, in the unit of the split.
    fn line(&self, distance: f64) -> f64 {
        match self.space {
            TextureSpace::Uv => self.extent.low[self.axis.index()] + distance,
            TextureSpace::Unit => self.extent.at_metres(self.axis, distance),
        }
    }

    /// Cuts the mesh at the borders of all pieces, into one band for each piece.
    fn bands(
        &self,
        env: &mut Env,
        mesh: &Arc<Mesh>,
        length: f64,
        pieces: &[Piece],
    ) -> ControlFlow<(), Vec<Option<Arc<Mesh>>>> {
        let borders = Borders::of(pieces, length, self.extent.high[self.axis.index()], |end| self.line(end));
        let limit = env.settings.limits.vertices;
        let most = usize::try_from(limit).unwrap_or(usize::MAX);
        match cut::iso_bands(mesh, self.set, self.axis, &borders.rising, most) {
            Ok(bands) => borders.one_a_piece(env, bands),
            Err(_) => env.limit(LimitKind::Vertices, limit),
        }
    }
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
