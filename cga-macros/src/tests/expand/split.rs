#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> split(x) { 0.5 : Wall. | { ~2 : Tile(split.index) | '0.1 : NIL }* | 1 : s(1, 2, 3) Post. }
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        let mut childless = true;
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
                    cga_rt::Item::Slot,
                ],
                successors: &[
                    cga_rt::Successor::Leaf(1u32),
                    cga_rt::Successor::Rule {
                        draws: false,
                        counts: true,
                    },
                    cga_rt::Successor::Nil,
                    cga_rt::Successor::Rule {
                        draws: false,
                        counts: false,
                    },
                ],
                has_total: false,
            };
            let sizes = &mut [
                cga_rt::Size::absolute(0.5f64),
                cga_rt::Size::floating(2f64),
                cga_rt::Size::relative(0.1f64),
                cga_rt::Size::absolute(1f64),
            ];
            cga_rt::split(
                cx,
                shape,
                SPLIT,
                sizes,
                &mut [0.0; 4usize],
                &mut |cx, slot, part| match slot {
                    1 => {
                        let a0 = cga_rt::get::split_index((&mut { part }));
                        CgaRules::Tile(g, cx, part, a0)
                    }
                    3 => CgaRules::Lot_1(g, cx, part),
                    _ => cga_rt::Flow::Continue(()),
                },
            )?
        };
        childless &= !has_parts;
        if childless {
            cx.any_leaf(shape, 0u32)?;
        }
        cx.leave()
    }
    ///Tile(i) --> Wall.
    #[inline(never)]
    fn Tile(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        i: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32, shape)?;
        cx.symbol(shape, 1u32)?;
        cx.leave()
    }
    #[inline(never)]
    fn Lot_1(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        let bases = cga_rt::Bases::new();
        let mut own = ::core::option::Option::None;
        let shape = {
            let a0 = cga_rt::Length::Absolute(1f64);
            let a1 = cga_rt::Length::Absolute(2f64);
            let a2 = cga_rt::Length::Absolute(3f64);
            cga_rt::slim::size(cx.env, shape, &bases, &mut own, a0, a1, a2)
        };
        cx.symbol(shape, 2u32)?;
        cga_rt::Flow::Continue(())
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
