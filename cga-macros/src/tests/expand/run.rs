#[automatically_derived]
impl cga_rt::Rules for Tower {
    type Values = CgaValues;
    type Call = CgaCall;
    fn tables(&self) -> &cga_rt::RuleTables {
        static TABLES: cga_rt::LazyLock<cga_rt::RuleTables> = cga_rt::LazyLock::new(|| cga_rt::RuleTables {
            name: cga_rt::Text::fixed("Tower"),
            rules: cga_rt::names(&["Lot", "Again"]),
            leaves: cga_rt::names(&["X"]),
            tags: false,
            starts: cga_rt::list([cga_rt::StartRule::new("Lot")]),
            entries: cga_rt::entries(&[(0, 0, 0)]),
            attributes: cga_rt::texts(&["share", "name", "drawn"]),
        });
        &TABLES
    }
    fn check(&self) -> ::core::result::Result<(), cga_rt::Error> {
        cga_rt::check(self)
    }
    fn values(
        &self,
        env: &mut cga_rt::Env,
        initial: &cga_rt::Shape,
        style: ::core::primitive::u32,
    ) -> CgaValues {
        let mut g = <CgaValues as ::core::default::Default>::default();
        g.attr_0 = self.share;
        g.attr_1 = cga_rt::text(&self.name);
        g.attr_2 = match self.drawn {
            ::core::option::Option::Some(value) => value,
            ::core::option::Option::None => {
                let shape = &mut cga_rt::global(initial, 3511804103u32);
                let g = &g;
                cga_rt::func::rand(shape)
            }
        };
        g.const_0 = {
            let shape = &mut cga_rt::global(initial, 80777981u32);
            let g = &g;
            (g.attr_0 + g.attr_2)
        };
        g
    }
    fn used(
        g: &CgaValues,
        style: ::core::primitive::u32,
        each: &mut dyn ::core::ops::FnMut(::core::option::Option<cga_rt::Value>),
    ) {
        each(cga_rt::Evaluated::value(&g.attr_0));
        each(cga_rt::Evaluated::value(&g.attr_1));
        each(cga_rt::Evaluated::value(&g.attr_2));
    }
    fn start(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        rule: ::core::primitive::u32,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        match rule {
            0u32 => CgaRules::Lot(g, cx, shape),
            _ => cga_rt::Flow::Continue(()),
        }
    }
    fn resume(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        shape: &cga_rt::ShapeRef<'_>,
        call: CgaCall,
    ) -> cga_rt::Flow {
        CgaRules::cga_resume(g, cx, shape, call)
    }
}
