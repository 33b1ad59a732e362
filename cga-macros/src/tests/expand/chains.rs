#[allow(non_snake_case, dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaRules {
    ///Lot --> extrude(h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h + h) A.
    #[inline(never)]
    fn Lot(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        cx.enter(0u32, shape)?;
        let bases = cga_rt::Bases::new();
        let mut own = ::core::option::Option::None;
        let shape = {
            let a0 = cga_rt::Length::Absolute({
                let mut so_far = g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far = so_far + g.attr_0;
                so_far
            });
            cga_rt::slim::extrude(cx.env, shape, &bases, &mut own, a0)
        };
        cx.symbol(shape, 0u32)?;
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
