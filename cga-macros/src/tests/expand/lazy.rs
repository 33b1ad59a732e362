#[allow(dead_code, clippy::all, clippy::pedantic, clippy::nursery)]
impl CgaValues {
    ///`a`, which may need itself: computed when it is first read.
    fn attr_1(g: &CgaValues, env: &mut cga_rt::Env) -> ::core::primitive::f64 {
        g.attr_1
            .get(
                env,
                cga_rt::Text::fixed("a"),
                2064,
                |env| {
                    let shape = &mut g.origin.global(3826002220u32);
                    (if (g.attr_0 == 1f64) {
                        5f64
                    } else {
                        (CgaValues::attr_2(g, env) * 2f64)
                    })
                },
            )
    }
    ///`b`, which may need itself: computed when it is first read.
    fn attr_2(g: &CgaValues, env: &mut cga_rt::Env) -> ::core::primitive::f64 {
        g.attr_2
            .get(
                env,
                cga_rt::Text::fixed("b"),
                2064,
                |env| {
                    let shape = &mut g.origin.global(3876335077u32);
                    (if (g.attr_0 == 1f64) {
                        (CgaValues::attr_1(g, env) / 2f64)
                    } else {
                        3f64
                    })
                },
            )
    }
}
#[automatically_derived]
impl cga_rt::Rules for CgaGrammar {
    type Values = CgaValues;
    type Call = CgaCall;
    fn tables(&self) -> &cga_rt::RuleTables {
        static TABLES: cga_rt::LazyLock<cga_rt::RuleTables> = cga_rt::LazyLock::new(|| cga_rt::RuleTables {
            name: cga_rt::Text::fixed(""),
            rules: cga_rt::names(&["Lot"]),
            leaves: cga_rt::names(&["X"]),
            tags: false,
            starts: cga_rt::list([cga_rt::StartRule::new("Lot")]),
            entries: cga_rt::entries(&[(0, 0, 0)]),
            attributes: cga_rt::texts(&["mode", "a", "b"]),
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
        g.origin = cga_rt::Origin::initial(initial);
        g.attr_1 = cga_rt::Lazy::given(self.a);
        g.attr_2 = cga_rt::Lazy::given(self.b);
        g.attr_0 = self.mode;
        cga_rt::computed(CgaValues::attr_1(&g, env));
        cga_rt::computed(CgaValues::attr_2(&g, env));
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
