#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> comp(f) { side : Wall. | 4 = Roof(comp.index) | all : NIL }
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        {
            let arms = [
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::Side),
                    mode: cga_rt::Mode::Each,
                    text: cga_rt::Text::fixed("side"),
                },
                cga_rt::Arm {
                    select: cga_rt::Select::Index(4f64),
                    mode: cga_rt::Mode::Together,
                    text: cga_rt::Text::fixed("4"),
                },
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::All),
                    mode: cga_rt::Mode::Each,
                    text: cga_rt::Text::fixed("all"),
                },
            ];
            cga_rt::comp(
                cx,
                shape,
                0,
                cga_rt::Components::Faces,
                cga_rt::Align::ZUp,
                &arms,
                &mut cga_rt::never,
                &mut |cx, arm, part| match arm {
                    0 => cx.symbol(part, 0u32),
                    1 => {
                        let a0 = {
                            let slim = (&mut { part });
                            let mut whole = cx.env.whole(slim);
                            let value = {
                                let shape = &mut whole;
                                cga_rt::get::comp_index(shape)
                            };
                            slim.drawn(&whole);
                            value
                        };
                        CgaRules::Roof(g, cx, part, a0)
                    }
                    2 => cga_rt::Flow::Continue(()),
                    _ => cga_rt::Flow::Continue(()),
                },
            )?;
        }
        cx.leave()
    }
    ///Roof(n) --> comp(e, noAlign) { border && scope.sx > n = : X. | object.top : Y. }
    #[inline(never)]
    fn Roof(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        n: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32, shape)?;
        {
            let arms = [
                cga_rt::Arm {
                    select: cga_rt::Select::When,
                    mode: cga_rt::Mode::Connected,
                    text: cga_rt::Text::fixed("border && scope.sx > n"),
                },
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::ObjectTop),
                    mode: cga_rt::Mode::Each,
                    text: cga_rt::Text::fixed("object.top"),
                },
            ];
            cga_rt::comp(
                cx,
                shape,
                0,
                cga_rt::Components::Edges,
                cga_rt::Align::Keep,
                &arms,
                &mut |env, arm, candidate| match arm {
                    0 => {
                        (candidate.is(cga_rt::Word::Border)
                            & (cga_rt::get::scope_sx(candidate.shape()) > n))
                    }
                    _ => false,
                },
                &mut |cx, arm, part| match arm {
                    0 => cx.symbol(part, 1u32),
                    1 => cx.symbol(part, 2u32),
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
