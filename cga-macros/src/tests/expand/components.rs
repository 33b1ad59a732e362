#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> print(names(2))
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        {
            let a0 = {
                let slim = (&mut { shape });
                let mut whole = cx.env.whole(slim);
                let value = {
                    let shape = &mut whole;
                    CgaRules::names(g, cx.env, shape, 2f64)
                };
                slim.drawn(&whole);
                value
            };
            let shape = &mut { shape };
            cga_rt::op::print(cx.env, shape, a0)
        }
        cx.leaf(shape, 0u32)?;
        cx.leave()
    }
    fn tall(
        g: &CgaValues,
        env: &mut cga_rt::Env,
        shape: &mut impl cga_rt::View,
        h: ::core::primitive::f64,
    ) -> ::core::primitive::bool {
        { (cga_rt::get::scope_sy(shape) > h) }
    }
    fn names(
        g: &CgaValues,
        env: &mut cga_rt::Env,
        shape: &mut cga_rt::Shape,
        h: ::core::primitive::f64,
    ) -> cga_rt::Array<cga_rt::Text> {
        {
            {
                let arms = [
                    cga_rt::Arm {
                        select: cga_rt::Select::When,
                        mode: cga_rt::Mode::Each,
                        text: cga_rt::Text::fixed("tall(h) || border"),
                    },
                    cga_rt::Arm {
                        select: cga_rt::Select::Index(0f64),
                        mode: cga_rt::Mode::Together,
                        text: cga_rt::Text::fixed("0"),
                    },
                ];
                cga_rt::comp_values(
                    env,
                    shape,
                    cga_rt::Components::FaceEdges,
                    cga_rt::Align::ZUp,
                    &arms,
                    |env, arm, candidate| match arm {
                        0 => {
                            (CgaRules::tall(g, env, candidate.shape(), h)
                                | candidate.is(cga_rt::Word::Border))
                        }
                        _ => false,
                    },
                    |env, arm, part| match arm {
                        0 => cga_rt::get::comp_sel(part),
                        1 => {
                            cga_rt::func::float_to_text({
                                let a0 = {
                                    let arms = [
                                        cga_rt::Arm {
                                            select: cga_rt::Select::Word(cga_rt::Word::StreetFront),
                                            mode: cga_rt::Mode::Each,
                                            text: cga_rt::Text::fixed("street.front"),
                                        },
                                    ];
                                    cga_rt::comp_values(
                                        env,
                                        part,
                                        cga_rt::Components::Vertices,
                                        cga_rt::Align::ZUp,
                                        &arms,
                                        cga_rt::never,
                                        |env, arm, part| match arm {
                                            0 => h,
                                            _ => ::core::default::Default::default(),
                                        },
                                    )
                                };
                                cga_rt::func::sum(a0)
                            })
                        }
                        _ => ::core::default::Default::default(),
                    },
                )
            }
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
