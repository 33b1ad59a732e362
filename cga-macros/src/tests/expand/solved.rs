#[allow(non_snake_case, dead_code, clippy::all)]
impl CgaRules {
    ///Lot --> s(10, 1, 1) primitiveCube() split(x) { 1 : Post. | { ~2.7 : Field. | 1 : Post. }* }
    fn Lot<CgaSink: cga_rt::Sink + ?::core::marker::Sized>(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaSink, CgaCall>,
        shape: &mut cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32)?;
        let mut childless = true;
        {
            let a0 = cga_rt::Length::Absolute(10f64);
            let a1 = cga_rt::Length::Absolute(1f64);
            let a2 = cga_rt::Length::Absolute(1f64);
            cga_rt::op::size(&mut cx.env, shape, a0, a1, a2);
        }
        {
            cga_rt::op::cube(&mut cx.env, shape);
        }
        childless
            &= !{
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
                cga_rt::split_solved(
                    cx,
                    shape,
                    (cga_rt::Axis::X, cga_rt::Adjust::Adjust),
                    10.0,
                    PIECES,
                    |cx, slot, part| match slot {
                        0 => cx.symbol(part, "Post"),
                        1 => cx.symbol(part, "Field"),
                        2 => cx.symbol(part, "Post"),
                        _ => cga_rt::Flow::Continue(()),
                    },
                )?
            };
        if childless {
            cx.leaf(shape, "Lot")?;
        }
        cx.leave()
    }
}
