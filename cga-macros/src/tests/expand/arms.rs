#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> shapeL(depth, 3) { shape : Wing(depth) | remainder = Court. }
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        {
            let a0 = g.attr_0;
            let a1 = 3f64;
            let arms = [
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::Shape),
                    mode: cga_rt::Mode::Each,
                    text: cga_rt::Text::fixed("shape"),
                },
                cga_rt::Arm {
                    select: cga_rt::Select::Word(cga_rt::Word::Remainder),
                    mode: cga_rt::Mode::Together,
                    text: cga_rt::Text::fixed("remainder"),
                },
            ];
            cga_rt::divide(
                cx,
                shape,
                0,
                &arms,
                &mut cga_rt::never,
                |env, arms| cga_rt::op::shape_l(env, arms, a0, a1),
                &mut |cx, arm, part| match arm {
                    0 => {
                        let a0 = g.attr_0;
                        CgaRules::Wing(g, cx, part, a0)
                    }
                    1 => cx.symbol(part, 0u32),
                    _ => cga_rt::Flow::Continue(()),
                },
            )?;
        }
        cx.leave()
    }
    ///Wing(height) --> taper(height)
    #[inline(never)]
    fn Wing(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        height: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32, shape)?;
        let changed = {
            let mut whole = cx.env.whole(shape);
            {
                let shape = &mut whole;
                {
                    let a0 = height;
                    cx.env.ask()?;
                    cga_rt::bake(shape);
                    cga_rt::op::taper(cx.env, shape, a0);
                }
            }
            cx.env.base(whole)
        };
        let shape = &changed.shape();
        cx.leaf(shape, 1u32)?;
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
