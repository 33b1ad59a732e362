#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///A(n) --> case n > 1 : B(n) B(n - 1) else : NIL
    #[inline(never)]
    fn A(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        n: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        if (n > 1f64) {
            {
                let a0 = n;
                let part = &cga_rt::successor(shape, 0);
                let flow: cga_rt::Flow = if cx.descend(1, 2) {
                    let flow = CgaRules::B(g, cx, part, a0);
                    cx.ascend(1, 2);
                    flow
                } else {
                    cx.defer(part, 1, 2, CgaCall::Rule1(a0))
                };
                flow?;
            }
            {
                let a0 = (n - 1f64);
                let part = shape;
                let flow: cga_rt::Flow = if cx.descend(1, 2) {
                    let flow = CgaRules::B(g, cx, part, a0);
                    cx.ascend(1, 2);
                    flow
                } else {
                    cx.defer(part, 1, 2, CgaCall::Rule1(a0))
                };
                flow?;
            }
        } else {}
        cx.leave()
    }
    ///B(n) --> A(n)
    #[inline(never)]
    fn B(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        n: ::core::primitive::f64,
    ) -> cga_rt::Flow {
        cx.enter(1u32, shape)?;
        {
            let a0 = n;
            let part = shape;
            let flow: cga_rt::Flow = if cx.descend(1, 3) {
                let flow = CgaRules::A(g, cx, part, a0);
                cx.ascend(1, 3);
                flow
            } else {
                cx.defer(part, 1, 3, CgaCall::Rule0(a0))
            };
            flow?;
        }
        cx.leave()
    }
    fn cga_resume(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        call: CgaCall,
    ) -> cga_rt::Flow {
        match call {
            CgaCall::Rule0(a0) => CgaRules::A(g, cx, shape, a0),
            CgaCall::Rule1(a0) => CgaRules::B(g, cx, shape, a0),
        }
    }
}
