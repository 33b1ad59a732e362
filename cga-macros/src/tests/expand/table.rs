#[automatically_derived]
impl cga_rt::Grammar for Tower {
    fn name(&self) -> &'static ::core::primitive::str {
        "Tower"
    }
    fn attributes(&self) -> &'static [cga_rt::Attribute] {
        const {
            &[
                cga_rt::Attribute::new(
                        "share",
                        cga_rt::Default::Float(::core::option::Option::Some(0.5f64)),
                    )
                    .range(cga_rt::Range::new(0f64, 1f64, 0f64, false))
                    .group(&["Size", "Main"])
                    .about("How much.")
                    .order(3f64),
                cga_rt::Attribute::new(
                        "drawn",
                        cga_rt::Default::Float(::core::option::Option::None),
                    )
                    .group(&["Size", "Main"])
                    .hidden(),
            ]
        }
    }
    fn attribute_get(
        &self,
        index: ::core::primitive::usize,
    ) -> ::core::option::Option<cga_rt::Value> {
        match index {
            0 => cga_rt::Field::get(&self.share),
            1 => cga_rt::Field::get(&self.drawn),
            _ => ::core::option::Option::None,
        }
    }
    fn attribute_set(&mut self, index: ::core::primitive::usize, value: cga_rt::Value) {
        match index {
            0 => cga_rt::Field::set(&mut self.share, value),
            1 => cga_rt::Field::set(&mut self.drawn, value),
            _ => {}
        }
    }
    fn start_rules(&self) -> &'static [&'static ::core::primitive::str] {
        <Self as cga_rt::Rules>::STARTS
    }
    fn derive(
        &self,
        shape: &cga_rt::Shape,
        settings: &cga_rt::Settings,
        sink: &mut dyn cga_rt::Sink,
    ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
        cga_rt::run(self, shape, settings, sink)
    }
}
