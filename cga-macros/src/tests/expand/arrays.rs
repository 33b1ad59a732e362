#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> set(a, [ a, 3 ]) t(total(a .* 2), case a [ [ 0, 1 ] ] == [ 1, 2 ] : 1 else : geometry.du(0, uvSpace), 0) roofHip(30)
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
                    let a0 = {
                        let a0 = cga_rt::get::floats_attribute(shape, 0u32, &g.attr_0);
                        let a1 = 3f64;
                        cga_rt::func::array(
                            cx.env,
                            &[
                                &[
                                    cga_rt::func::ArrayPart::from(a0),
                                    cga_rt::func::ArrayPart::from(a1),
                                ],
                            ],
                        )
                    };
                    cga_rt::set::attribute(shape, 0u32, cga_rt::Value::Floats(a0));
                }
                {
                    let a0 = cga_rt::Length::Absolute({
                        let a0 = {
                            let a0 = cga_rt::get::floats_attribute(
                                shape,
                                0u32,
                                &g.attr_0,
                            );
                            let a1 = 2f64;
                            cga_rt::func::each_multiply(cx.env, a0, a1)
                        };
                        CgaRules::total(g, cx.env, shape, a0)
                    });
                    let a1 = cga_rt::Length::Absolute(
                        (if {
                            let a0 = {
                                let a0 = cga_rt::get::floats_attribute(
                                    shape,
                                    0u32,
                                    &g.attr_0,
                                );
                                let a1 = cga_rt::array(2usize, [0f64, 1f64]);
                                cga_rt::func::elements(cx.env, a0, a1)
                            };
                            let a1 = cga_rt::array(2usize, [1f64, 2f64]);
                            cga_rt::func::equal(a0, a1)
                        } {
                            1f64
                        } else {
                            cga_rt::func::geometry_du(
                                cx.env,
                                shape,
                                0f64,
                                cga_rt::func::TextureSpace::Uv,
                            )
                        }),
                    );
                    let a2 = cga_rt::Length::Absolute(0f64);
                    cga_rt::op::translate(cx.env, shape, a0, a1, a2);
                }
                {
                    let a0 = 30f64;
                    let a1 = 0f64;
                    let a2 = false;
                    cx.env.ask()?;
                    cga_rt::bake(shape);
                    cga_rt::op::roof_hip(cx.env, shape, a0, a1, a2);
                }
            }
            cx.env.base(whole)
        };
        let shape = &changed.shape();
        cx.leaf(shape, 0u32)?;
        cx.leave()
    }
    fn total(
        g: &CgaValues,
        env: &mut cga_rt::Env,
        shape: &mut impl cga_rt::View,
        list: cga_rt::Array<::core::primitive::f64>,
    ) -> ::core::primitive::f64 {
        {
            let s = cga_rt::func::sum(::core::clone::Clone::clone(&list));
            (s + cga_rt::func::element(env, ::core::clone::Clone::clone(&list), 0f64))
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
