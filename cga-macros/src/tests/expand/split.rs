#[allow(non_snake_case, dead_code, clippy::all)]
impl CgaRules {
    ///Lot --> split(x) { 0.5 : Wall. | { ~2 : Tile(split.index) | '0.1 : NIL }* | 1 : s(1, 2, 3) Post. }
    fn Lot<CgaSink: cga_rt::Sink + ?::core::marker::Sized>(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaSink, CgaCall>,
        shape: &mut cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32)?;
        let mut childless = true;
        childless
            &= !{
                const PATTERN: &[cga_rt::Item] = &[
                    cga_rt::Item::Slot,
                    cga_rt::Item::Repeat(2),
                    cga_rt::Item::Slot,
                    cga_rt::Item::Slot,
                    cga_rt::Item::Slot,
                ];
                const SIZES: [cga_rt::Size; 4usize] = [
                    cga_rt::Size::absolute(0.5f64),
                    cga_rt::Size::floating(2f64),
                    cga_rt::Size::relative(0.1f64),
                    cga_rt::Size::absolute(1f64),
                ];
                cga_rt::split(
                    cx,
                    shape,
                    (cga_rt::Axis::X, cga_rt::Adjust::Adjust),
                    PATTERN,
                    SIZES,
                    |cx, slot, part| match slot {
                        0 => cx.symbol(part, "Wall"),
                        1 => {
                            let a0 = cga_rt::get::split_index(part);
                            cga_rt::hand_on(part);
                            CgaRules::Tile(g, cx, part, a0)
                        }
                        2 => cga_rt::Flow::Continue(()),
                        3 => CgaRules::Lot_1(g, cx, part),
                        _ => cga_rt::Flow::Continue(()),
                    },
                )?
            };
        if childless {
            cx.leaf(shape, "Lot")?;
        }
        cx.leave()
    }
    ///Tile(i) --> Wall.
    fn Tile<CgaSink: cga_rt::Sink + ?::core::marker::Sized>(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaSink, CgaCall>,
        shape: &mut cga_rt::ShapeRef<'_>,
        p0: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32)?;
        cx.symbol(shape, "Wall")?;
        cx.leave()
    }
    fn Lot_1<CgaSink: cga_rt::Sink + ?::core::marker::Sized>(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaSink, CgaCall>,
        shape: &mut cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        {
            let a0 = cga_rt::Length::Absolute(1f64);
            let a1 = cga_rt::Length::Absolute(2f64);
            let a2 = cga_rt::Length::Absolute(3f64);
            cga_rt::op::size(&mut cx.env, shape, a0, a1, a2);
        }
        cx.symbol(shape, "Post")?;
        cga_rt::Flow::Continue(())
    }
}
