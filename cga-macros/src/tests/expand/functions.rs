#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> t(fac(3, 4), #…, crate::noise("a" + scope.sx, true)) crate::ops::arch(1, "x")
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        let changed = {
            let mut whole = cx.env.whole(shape);
            {
                let shape = &mut whole;
                {
                    let a0 = cga_rt::Length::Absolute(
                        CgaRules::fac_2(g, cx.env, shape, 3f64, 4f64),
                    );
                    let a1 = cga_rt::Length::Absolute(
                        cga_rt::host::ToFloat::to_float(&OFFSET),
                    );
                    let a2 = cga_rt::Length::Absolute({
                        let a0 = {
                            let a0 = cga_rt::Text::fixed("a");
                            let a1 = cga_rt::func::float_to_text(
                                cga_rt::get::scope_sx(shape),
                            );
                            cga_rt::func::concat(cx.env, a0, a1)
                        };
                        let a1 = true;
                        cga_rt::host::ToFloat::to_float(
                            &crate::noise(cga_rt::host::as_str(&a0), a1),
                        )
                    });
                    cga_rt::op::translate(cx.env, shape, a0, a1, a2);
                }
                {
                    let a0 = 1f64;
                    let a1 = cga_rt::Text::fixed("x");
                    cga_rt::host::operate(
                        cx.env,
                        shape,
                        |shape| crate::ops::arch(shape, a0, cga_rt::host::as_str(&a1)),
                    )
                };
            }
            cx.env.base(whole)
        };
        let shape = &changed.shape();
        cx.leaf(shape, 0u32)?;
        cx.leave()
    }
    fn fac(
        g: &CgaValues,
        env: &mut cga_rt::Env,
        shape: &mut impl cga_rt::View,
        n: ::core::primitive::f64,
    ) -> ::core::primitive::f64 {
        if !env.call(240) {
            return ::core::default::Default::default();
        }
        let value = {
            (if (!(n >= 2f64)) {
                1f64
            } else {
                (n * CgaRules::fac(g, env, shape, (n - 1f64)))
            })
        };
        env.called(240);
        value
    }
    fn fac_2(
        g: &CgaValues,
        env: &mut cga_rt::Env,
        shape: &mut impl cga_rt::View,
        a: ::core::primitive::f64,
        b: ::core::primitive::f64,
    ) -> ::core::primitive::f64 {
        {
            ((CgaRules::fac(g, env, shape, a) + cga_rt::get::scope_sx(shape))
                - cga_rt::func::rand_between(env, shape, a, b))
        }
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
