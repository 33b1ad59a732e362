#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> scatter(surface, count, uniform) { Tree. } inline Volume(3) House.
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        {
            let a0 = cga_rt::op::ScatterDomain::Surface;
            let a1 = g.attr_0;
            let a2 = cga_rt::op::Distribution::Uniform;
            cga_rt::each(
                cx,
                shape,
                0,
                |env, shape| cga_rt::op::scatter(env, shape, a0, a1, a2),
                &mut |cx, part| cx.symbol(part, 0u32),
            )?;
        }
        let changed = {
            let a0 = cga_rt::op::MergeStrategy::Append;
            let operands = [
                cga_rt::operand(
                    cx,
                    g,
                    &mut |cx| {
                        {
                            let a0 = 3f64;
                            let part = &cga_rt::successor(shape, 1);
                            let flow: cga_rt::Flow = CgaRules::Volume(g, cx, part, a0);
                            flow?;
                        }
                        cga_rt::Flow::Continue(())
                    },
                    CgaRules::cga_resume,
                )?,
            ];
            cx.env.ask()?;
            let mut whole = cx.env.whole(shape);
            cga_rt::op::inline(cx.env, &mut whole, operands, a0);
            cx.env.base(whole)
        };
        let shape = &changed.shape();
        cx.symbol(shape, 1u32)?;
        cx.leave()
    }
    ///Volume(n) --> extrude(n)
    #[inline(never)]
    fn Volume(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        n: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32, shape)?;
        let bases = cga_rt::Bases::new();
        let mut own = ::core::option::Option::None;
        let shape = {
            let a0 = cga_rt::Length::Absolute(n);
            cga_rt::slim::extrude(cx.env, shape, &bases, &mut own, a0)
        };
        cx.leaf(shape, 2u32)?;
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
