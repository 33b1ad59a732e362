#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> case height > 2 && p(0.5) : [ s('1, '2, 3) center(xz) NIL ] A.case height == 1 : 30 % : A. else : NIL else : set(height, 2) set(material.opacity, 0.5)
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        let mut childless = true;
        if ((cga_rt::get::float_attribute((&mut { shape }), 0u32, g.attr_0) > 2f64)
            & cga_rt::func::chance(cx.env, (&mut { shape }), 0.5f64))
        {
            {
                let shape = &cga_rt::push(shape, 0);
                let base = shape.scope();
                let changed = {
                    let mut whole = cx.env.whole(shape);
                    {
                        let shape = &mut whole;
                        {
                            let a0 = cga_rt::Length::Relative(1f64);
                            let a1 = cga_rt::Length::Relative(2f64);
                            let a2 = cga_rt::Length::Absolute(3f64);
                            cga_rt::op::size(cx.env, shape, a0, a1, a2);
                        }
                        {
                            let a0 = cga_rt::op::CenterAxes::Xz;
                            cx.env.ask()?;
                            cga_rt::op::center(cx.env, shape, &base, a0);
                        }
                    }
                    cx.env.base(whole)
                };
                let shape = &changed.shape();
                childless = false;
            }
            cx.symbol(shape, 1u32)?;
            childless = false;
            if childless {
                cx.any_leaf(shape, 0u32)?;
            }
        } else if (cga_rt::get::float_attribute((&mut { shape }), 0u32, g.attr_0)
            == 1f64)
        {
            if cga_rt::branch((&mut { shape }), 30f64, 0f64) {
                cx.symbol(shape, 1u32)?;
                childless = false;
                if childless {
                    cx.any_leaf(shape, 0u32)?;
                }
            } else {
                childless = false;
                if childless {
                    cx.any_leaf(shape, 0u32)?;
                }
            }
        } else {
            let changed = {
                let mut whole = cx.env.whole(shape);
                {
                    let shape = &mut whole;
                    {
                        let a0 = 2f64;
                        cga_rt::set::attribute(shape, 0u32, cga_rt::Value::Float(a0));
                    }
                    {
                        let a0 = 0.5f64;
                        cga_rt::set::material_opacity(cx.env, shape, a0);
                    }
                }
                cx.env.base(whole)
            };
            let shape = &changed.shape();
            cx.leaf(shape, 0u32)?;
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
