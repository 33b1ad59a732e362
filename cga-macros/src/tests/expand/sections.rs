#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> splitAndSetbackPerimeter(6) { ~10 : depth + split.index : Wing(depth) | 3 : 0 : NIL }* { remainder = Court. }
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        {
            let a0 = cga_rt::Length::Absolute(6f64);
            let sizes = &mut [
                cga_rt::Size::floating(10f64),
                cga_rt::Size::absolute(3f64),
            ];
            let rest = [
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::Remainder),
                    mode: cga_rt::Mode::Together,
                    text: cga_rt::Text::fixed("remainder"),
                },
            ];
            cga_rt::sections(
                cx,
                shape,
                0,
                (
                    &[cga_rt::Item::Repeat(2), cga_rt::Item::Slot, cga_rt::Item::Slot],
                    sizes,
                ),
                &rest,
                &mut |env, slot, part| match slot {
                    0 => (g.attr_0 + cga_rt::get::split_index(part)),
                    1 => 0f64,
                    _ => 0.0,
                },
                |env, sections| cga_rt::op::perimeter(env, sections, a0),
                &mut |cx, slot, part| match slot {
                    0 => {
                        let a0 = g.attr_0;
                        CgaRules::Wing(g, cx, part, a0)
                    }
                    1 => cga_rt::Flow::Continue(()),
                    2 => cx.symbol(part, 0u32),
                    _ => cga_rt::Flow::Continue(()),
                },
            )?;
        }
        cx.leave()
    }
    ///Wing(height) --> setbackPerEdge(scope.sx / height) { all : Wing. }
    #[inline(never)]
    fn Wing(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        height: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32, shape)?;
        {
            let a0 = {
                let slim = (&mut { shape });
                let mut whole = cx.env.whole(slim);
                let value = {
                    let shape = &mut whole;
                    {
                        let arms = [
                            cga_rt::Arm {
                                select: cga_rt::Select::Word(cga_rt::Word::All),
                                mode: cga_rt::Mode::Each,
                                text: cga_rt::Text::fixed("all"),
                            },
                        ];
                        cga_rt::comp_values(
                            cx.env,
                            shape,
                            cga_rt::Components::FaceEdges,
                            cga_rt::Align::ZUp,
                            &arms,
                            cga_rt::never,
                            |env, arm, part| match arm {
                                0 => (cga_rt::get::scope_sx(part) / height),
                                _ => ::core::default::Default::default(),
                            },
                        )
                    }
                };
                slim.drawn(&whole);
                value
            };
            let a1 = 0f64;
            let arms = [
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::All),
                    mode: cga_rt::Mode::Each,
                    text: cga_rt::Text::fixed("all"),
                },
            ];
            cga_rt::divide(
                cx,
                shape,
                0,
                &arms,
                &mut cga_rt::never,
                |env, arms| cga_rt::op::setback_per_edge(env, arms, a0, a1),
                &mut |cx, arm, part| match arm {
                    0 => cx.symbol(part, 1u32),
                    _ => cga_rt::Flow::Continue(()),
                },
            )?;
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
