#[allow(non_snake_case, dead_code, clippy::all)]
impl CgaRules {
    ///Lot --> s(10, 1, 1) primitiveCube() split(x) { 1 : Post. | { ~2.7 : Field. | 1 : Post. }* }
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32)?;
        let mut childless = true;
        let changed = {
            let mut whole = cx.env.whole(shape);
            {
                let shape = &mut whole;
                {
                    let a0 = cga_rt::Length::Absolute(10f64);
                    let a1 = cga_rt::Length::Absolute(1f64);
                    let a2 = cga_rt::Length::Absolute(1f64);
                    cga_rt::op::size(cx.env, shape, a0, a1, a2);
                }
                {
                    cga_rt::bake(shape);
                    cga_rt::op::cube(cx.env, shape);
                }
            }
            cx.env.base(whole)
        };
        let shape = &changed.shape();
        {
            const PIECES: &[cga_rt::Piece] = &[
                cga_rt::Piece {
                    slot: 0,
                    start: 0.0,
                    end: 1.0,
                    length: 1.0,
                },
                cga_rt::Piece {
                    slot: 1,
                    start: 1.0,
                    end: 3.0,
                    length: 1.9999999999999998,
                },
                cga_rt::Piece {
                    slot: 2,
                    start: 3.0,
                    end: 4.0,
                    length: 1.0,
                },
                cga_rt::Piece {
                    slot: 1,
                    start: 4.0,
                    end: 6.0,
                    length: 1.9999999999999998,
                },
                cga_rt::Piece {
                    slot: 2,
                    start: 6.0,
                    end: 7.0,
                    length: 1.0,
                },
                cga_rt::Piece {
                    slot: 1,
                    start: 7.0,
                    end: 9.0,
                    length: 1.9999999999999998,
                },
                cga_rt::Piece {
                    slot: 2,
                    start: 9.0,
                    end: 10.0,
                    length: 1.0,
                },
            ];
            let pieces = cga_rt::solved(cx.env, shape, cga_rt::Axis::X, 10.0, PIECES);
            let made = cga_rt::Made::any(
                cx.env,
                shape,
                cga_rt::Axis::X,
                cga_rt::Adjust::Adjust,
                pieces,
            )?;
            let mut division = cga_rt::Division::any(
                shape,
                &made,
                cga_rt::Axis::X,
                cga_rt::Adjust::Adjust,
                0,
                0,
            );
            let mut row = cga_rt::List::new(pieces);
            division.any_leaf(cx, &mut row, cga_rt::Axis::X, 0, 1u32)?;
            let mut group0 = row.any_open(1..3);
            while row.any_turn(&mut group0) {
                division.turn(cx.env)?;
                division.any_leaf(cx, &mut row, cga_rt::Axis::X, 1, 2u32)?;
                division.any_leaf(cx, &mut row, cga_rt::Axis::X, 2, 1u32)?;
            }
            division.any_end(cga_rt::Axis::X);
            childless &= !division.has_parts();
        }
        if childless {
            cx.any_leaf(shape, 0u32)?;
        }
        cx.leave()
    }
    fn cga_resume(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        call: CgaCall,
    ) -> cga_rt::Flow {
        match call {}
    }
}
