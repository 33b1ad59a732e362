#[allow(non_snake_case, dead_code, clippy::all)]
impl CgaRules {
    ///Lot --> split(x) { 0.5 : Wall. | { ~2 : Tile(split.index) | '0.1 : NIL }* | 1 : s(1, 2, 3) Post. }
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32)?;
        let mut childless = true;
        {
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
            let mut lengths = [0.0; 4usize];
            let extent = cga_rt::extent(cx.env, shape, cga_rt::Axis::X);
            let pieces = &cga_rt::solve_any(PATTERN, &SIZES, &mut lengths, extent);
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
            let mut row = pieces.cursor();
            division.any_leaf(cx, &mut row, cga_rt::Axis::X, 0, 1u32)?;
            let mut group0 = row.any_open(pieces, 0);
            while row.any_turn(&mut group0) {
                division.turn(cx.env)?;
                let slot = cga_rt::Slot {
                    number: 1,
                    in_group: true,
                    draws: false,
                    counts: true,
                };
                if let ::core::option::Option::Some(part) = division
                    .any_part(&mut row, cga_rt::Axis::X, slot)
                {
                    let flow: cga_rt::Flow = {
                        let a0 = cga_rt::get::split_index((&mut { part }));
                        CgaRules::Tile(g, cx, part, a0)
                    };
                    flow?;
                }
                division.any_skip(&mut row, 2);
            }
            let slot = cga_rt::Slot {
                number: 3,
                in_group: false,
                draws: false,
                counts: false,
            };
            if let ::core::option::Option::Some(part) = division
                .any_part(&mut row, cga_rt::Axis::X, slot)
            {
                let flow: cga_rt::Flow = { CgaRules::Lot_1(g, cx, part) };
                flow?;
            }
            division.any_end(cga_rt::Axis::X);
            childless &= !division.has_parts();
        }
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
        p0: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32)?;
        cx.symbol(shape, 1u32)?;
        cx.leave()
    }
    #[inline(never)]
    fn Lot_1(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        let mut own;
        let changed = {
            let a0 = cga_rt::Length::Absolute(1f64);
            let a1 = cga_rt::Length::Absolute(2f64);
            let a2 = cga_rt::Length::Absolute(3f64);
            own = ::core::clone::Clone::clone(shape);
            let shape = &mut own;
            cga_rt::slim::size(cx.env, shape, a0, a1, a2)
        };
        let shape = &cga_rt::slim::after(own, &changed);
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
