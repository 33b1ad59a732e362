#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> s(10, 1, 1) primitiveCube() split(x) { 1 : Post. | { ~2.7 : Field. | 1 : Post. }* }
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
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
                    cx.env.ask()?;
                    cga_rt::bake(shape);
                    cga_rt::op::cube(cx.env, shape);
                }
            }
            cx.env.base(whole)
        };
        let shape = &changed.shape();
        let has_parts = {
            const SPLIT: &cga_rt::Split<'_> = &cga_rt::Split {
                axis: cga_rt::Axis::X,
                adjust: cga_rt::Adjust::Adjust,
                number: 0,
                pattern: &[
                    cga_rt::Item::Slot,
                    cga_rt::Item::Repeat(2),
                    cga_rt::Item::Slot,
                    cga_rt::Item::Slot,
                ],
                successors: &[
                    cga_rt::Successor::Leaf(1u32),
                    cga_rt::Successor::Leaf(2u32),
                    cga_rt::Successor::Leaf(1u32),
                ],
                has_total: false,
            };
            cga_rt::split_solved(
                cx,
                shape,
                SPLIT,
                10.0,
                &[
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
                ],
                &mut |_, _, _| cga_rt::Flow::Continue(()),
            )?
        };
        childless &= !has_parts;
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
