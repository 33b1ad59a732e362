#[automatically_derived]
impl cga_rt::Grammar for Tower {
    fn name(&self) -> &::core::primitive::str {
        "Tower"
    }
    fn attributes(&self) -> &[cga_rt::Attribute] {
        static ATTRIBUTES: cga_rt::LazyLock<cga_rt::Vec<cga_rt::Attribute>> = cga_rt::LazyLock::new(||
        cga_rt::list([
            cga_rt::Attribute::new("share", cga_rt::Value::Float(0.5f64))
                .range(cga_rt::Range::new(0f64, 1f64, 0f64, false))
                .group(["Size", "Main"])
                .about("How much.")
                .order(3f64),
            cga_rt::Attribute::computed("drawn", cga_rt::ValueType::Float)
                .group(["Size", "Main"])
                .hidden(),
            cga_rt::Attribute::new(
                    "wall",
                    cga_rt::Value::Text(cga_rt::Text::fixed("brick")),
                )
                .display_name("Outer wall")
                .choices(
                    cga_rt::Choices::new(
                        cga_rt::ChoiceValues::Texts(cga_rt::texts(&["brick", "glass"])),
                        true,
                    ),
                )
                .group(["Look"])
                .group_order(2f64),
            cga_rt::Attribute::computed("image", cga_rt::ValueType::Text)
                .choices(
                    cga_rt::Choices::new(
                        cga_rt::ChoiceValues::Attribute(cga_rt::Text::fixed("wall")),
                        false,
                    ),
                )
                .kind(cga_rt::AttributeKind::File(cga_rt::texts(&["png", "jpg"])))
                .group(["Look"])
                .group_order(2f64),
        ]));
        &ATTRIBUTES
    }
    fn attribute_get(
        &self,
        index: ::core::primitive::usize,
    ) -> ::core::option::Option<cga_rt::Value> {
        match index {
            0 => cga_rt::Field::get(&self.share),
            1 => cga_rt::Field::get(&self.drawn),
            2 => cga_rt::Field::get(&self.wall),
            3 => cga_rt::Field::get(&self.image),
            _ => ::core::option::Option::None,
        }
    }
    fn attribute_set(&mut self, index: ::core::primitive::usize, value: cga_rt::Value) {
        match index {
            0 => cga_rt::Field::set(&mut self.share, value),
            1 => cga_rt::Field::set(&mut self.drawn, value),
            2 => cga_rt::Field::set(&mut self.wall, value),
            3 => cga_rt::Field::set(&mut self.image, value),
            _ => {}
        }
    }
    fn attribute_reset(&mut self, index: ::core::primitive::usize) {
        match index {
            0 => self.share = 0.5f64,
            1 => self.drawn = ::core::option::Option::None,
            2 => self.wall = cga_rt::string("brick"),
            3 => self.image = ::core::option::Option::None,
            _ => {}
        }
    }
    fn boxed(
        &self,
    ) -> cga_rt::Box<dyn cga_rt::Grammar + ::core::marker::Send + ::core::marker::Sync> {
        cga_rt::Box::new(::core::clone::Clone::clone(self))
    }
    fn used_values(
        &self,
        shape: &cga_rt::Shape,
        settings: &cga_rt::Settings,
    ) -> ::core::result::Result<
        cga_rt::Vec<(cga_rt::Text, cga_rt::Value)>,
        cga_rt::Error,
    > {
        cga_rt::used_values(self, shape, settings)
    }
    fn start_rules(&self) -> &[cga_rt::StartRule] {
        &cga_rt::Rules::tables(self).starts
    }
    fn run(
        &self,
        shape: &cga_rt::Shape,
        settings: &cga_rt::Settings,
        sink: &mut dyn cga_rt::Sink,
    ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
        cga_rt::run(self, shape, settings, sink)
    }
    fn session<'g>(
        &'g self,
        settings: &cga_rt::Settings,
    ) -> ::core::result::Result<
        cga_rt::Box<dyn cga_rt::DynSession + 'g>,
        cga_rt::Error,
    > {
        cga_rt::open(self, settings)
    }
}
