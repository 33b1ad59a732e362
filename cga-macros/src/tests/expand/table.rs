#[automatically_derived]
impl cga_rt::Grammar for Tower {
    fn name(&self) -> &'static ::core::primitive::str {
        "Tower"
    }
    fn attributes(&self) -> &'static [cga_rt::Attribute] {
        &[
            cga_rt::Attribute {
                name: "share",
                default: cga_rt::Default::Float(::core::option::Option::Some(0.5f64)),
                range: ::core::option::Option::Some(cga_rt::Range {
                    min: 0f64,
                    max: 1f64,
                    step: 0f64,
                    restricted: false,
                }),
                group: &["Size", "Main"],
                about: "How much.",
                order: ::core::option::Option::Some(3f64),
                hidden: false,
            },
            cga_rt::Attribute {
                name: "drawn",
                default: cga_rt::Default::Float(::core::option::Option::None),
                range: ::core::option::Option::None,
                group: &["Size", "Main"],
                about: "",
                order: ::core::option::Option::None,
                hidden: true,
            },
        ]
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
