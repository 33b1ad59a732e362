#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> modify(f) { top : NIL | side : split(y) { ~1 : t(0, 1, 0) X. } } House.
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        let changed = {
            let a0 = cga_rt::op::Components::Faces;
            let a1 = cga_rt::op::Align::ZUp;
            let operands = {
                let begun = cx.env.begin_recomposition(shape);
                let shape = &begun.shape();
                [
                    cga_rt::operand(
                        cx,
                        g,
                        &mut |cx| {
                            {
                                let part = &cga_rt::successor(shape, 0);
                                let flow: cga_rt::Flow = CgaRules::Lot_1(g, cx, part);
                                flow?;
                            }
                            cga_rt::Flow::Continue(())
                        },
                        CgaRules::cga_resume,
                    )?,
                ]
            };
            cx.env.ask()?;
            let mut whole = cx.env.whole(shape);
            cga_rt::op::modify(cx.env, &mut whole, operands, a0, a1);
            cx.env.base(whole)
        };
        let shape = &changed.shape();
        cx.symbol(shape, 0u32)?;
        cx.leave()
    }
    #[inline(never)]
    fn Lot_1(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        {
            let arms = [
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::Top),
                    mode: cga_rt::Mode::Each,
                    text: cga_rt::Text::fixed("top"),
                },
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::Side),
                    mode: cga_rt::Mode::Each,
                    text: cga_rt::Text::fixed("side"),
                },
            ];
            cga_rt::comp_and_rest(
                cx,
                shape,
                0,
                cga_rt::Components::Faces,
                cga_rt::Align::ZUp,
                &arms,
                &mut cga_rt::never,
                &mut |cx, arm, part| match arm {
                    0 => cx.vanish(part),
                    1 => CgaRules::Lot_2(g, cx, part),
                    _ => cga_rt::Flow::Continue(()),
                },
            )?;
        }
        cga_rt::Flow::Continue(())
    }
    #[inline(never)]
    fn Lot_2(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        let mut childless = true;
        let has_parts = {
            const SPLIT: &cga_rt::Split<'_> = &cga_rt::Split {
                axis: cga_rt::Axis::Y,
                adjust: cga_rt::Adjust::Adjust,
                number: 0,
                pattern: &[cga_rt::Item::Slot],
                successors: &[
                    cga_rt::Successor::Rule {
                        draws: false,
                        counts: false,
                    },
                ],
                has_total: false,
            };
            let sizes = &mut [cga_rt::Size::floating(1f64)];
            cga_rt::split(
                cx,
                shape,
                SPLIT,
                sizes,
                &mut [0.0; 1usize],
                &mut |cx, slot, part| match slot {
                    0 => CgaRules::Lot_3(g, cx, part),
                    _ => cga_rt::Flow::Continue(()),
                },
            )?
        };
        childless &= !has_parts;
        if childless {
            cx.any_symbol(shape, 1u32)?;
        }
        cga_rt::Flow::Continue(())
    }
    #[inline(never)]
    fn Lot_3(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        let bases = cga_rt::Bases::new();
        let mut own = ::core::option::Option::None;
        let shape = {
            let a0 = cga_rt::Length::Absolute(0f64);
            let a1 = cga_rt::Length::Absolute(1f64);
            let a2 = cga_rt::Length::Absolute(0f64);
            cga_rt::slim::translate(cx.env, shape, &bases, &mut own, a0, a1, a2)
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
