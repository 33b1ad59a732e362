#[automatically_derived]
impl cga_rt::Rules for Tower {
    type Values = CgaValues;
    type Call = CgaCall;
    fn tables(&self) -> &cga_rt::RuleTables {
        static TABLES: cga_rt::LazyLock<cga_rt::RuleTables> = cga_rt::LazyLock::new(|| cga_rt::RuleTables {
            name: cga_rt::Text::fixed("Tower"),
            rules: cga_rt::names(&["Lot", "Roof", "Lot/1"]),
            leaves: cga_rt::names(&["Y", "X"]),
            tags: false,
            starts: cga_rt::list([
                cga_rt::StartRule::new("Lot"),
                cga_rt::StartRule::new("Roof"),
                cga_rt::StartRule::new("Tall$Lot"),
                cga_rt::StartRule::new("Tall$Roof"),
            ]),
            entries: cga_rt::entries(&[(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)]),
            attributes: cga_rt::texts(&["h", "label"]),
        });
        &TABLES
    }
    fn check(&self) -> ::core::result::Result<(), cga_rt::Error> {
        ::core::result::Result::Ok(())
    }
    fn values(
        &self,
        env: &mut cga_rt::Env,
        initial: &cga_rt::Shape,
        style: ::core::primitive::u32,
    ) -> CgaValues {
        let mut g = <CgaValues as ::core::default::Default>::default();
        g.style = style;
        g.attr_0 = match self.h {
            ::core::option::Option::Some(value) => value,
            ::core::option::Option::None => {
                let shape = &mut cga_rt::global(initial, 3977000791u32);
                let g = &g;
                (match g.style {
                    1u32 => 5f64,
                    _ => 1f64,
                })
            }
        };
        g.attr_1 = cga_rt::text(&self.label);
        g
    }
    fn used(
        g: &CgaValues,
        style: ::core::primitive::u32,
        each: &mut dyn ::core::ops::FnMut(::core::option::Option<cga_rt::Value>),
    ) {
        each(cga_rt::Evaluated::value(&g.attr_0));
        each(cga_rt::Evaluated::value(&g.attr_1));
    }
    fn start(
        g: &CgaValues,
        cx: &mut cga_rt::Cx<'_, CgaCall>,
        rule: ::core::primitive::u32,
        shape: &cga_rt::ShapeRef<'_>,
    ) -> cga_rt::Flow {
        match rule {
            0u32 => CgaRules::Lot(g, cx, shape),
            1u32 => CgaRules::Roof(g, cx, shape),
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
