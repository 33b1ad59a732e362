const _: () = {
    mod cga {
        #[deprecated(note = "unknown annotation `@Foo`")]
        macro_rules! unknown_annotation {
            () => {};
        }
        #[allow(deprecated)]
        pub(super) use unknown_annotation;
    }
    cga::unknown_annotation!();
};
::core::compile_error! {
    "there is no rule `extrud`\nnote: this is `undefined_rule`, whose level can be changed\nhelp: did you mean `extrude`?"
}
::core::compile_error! {
    "there is no rule `splot`\nnote: this is `undefined_rule`, whose level can be changed\nhelp: did you mean `split`?\nhelp: write `splot.` for a leaf, or declare it: `splot --> …`"
}
const _: () = {
    use ::cga::__rt as cga_rt;
    #[automatically_derived]
    impl ::core::default::Default for Tower {
        fn default() -> Self {
            Tower {}
        }
    }
    impl Tower {
        /// Runs the start rule on a shape, with default settings.
        ///
        /// # Errors
        /// A limit that was reached, an attribute out of its range, attributes that need each other, no such start rule, an initial shape that is refused.
        pub fn generate(
            &self,
            shape: &cga_rt::Shape,
        ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            ::core::unreachable!("the rules have errors")
        }
        /// Runs the rule of that name on a shape, with default settings.
        ///
        /// # Errors
        /// A limit that was reached, an attribute out of its range, attributes that need each other, no such start rule, an initial shape that is refused.
        pub fn generate_from(
            &self,
            rule: &::core::primitive::str,
            shape: &cga_rt::Shape,
        ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            ::core::unreachable!("the rules have errors")
        }
        /// Runs on a shape with settings: start rule, limits, assets.
        ///
        /// # Errors
        /// A limit that was reached, an attribute out of its range, attributes that need each other, no such start rule, an initial shape that is refused.
        pub fn generate_with(
            &self,
            shape: &cga_rt::Shape,
            settings: &cga_rt::Settings,
        ) -> ::core::result::Result<cga_rt::Model, cga_rt::Error> {
            ::core::unreachable!("the rules have errors")
        }
        /// Runs on a shape and hands the leaves to a sink. This is the fast path: no model in between.
        ///
        /// # Errors
        /// A limit that was reached, an attribute out of its range, attributes that need each other, no such start rule, an initial shape that is refused.
        pub fn generate_into<Sink: cga_rt::Sink + ?::core::marker::Sized>(
            &self,
            shape: &cga_rt::Shape,
            settings: &cga_rt::Settings,
            sink: &mut Sink,
        ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
            ::core::unreachable!("the rules have errors")
        }
    }
    #[automatically_derived]
    impl cga_rt::Grammar for Tower {
        fn name(&self) -> &'static ::core::primitive::str {
            "Tower"
        }
        fn attributes(&self) -> &'static [cga_rt::Attribute] {
            &[]
        }
        fn attribute_get(
            &self,
            _: ::core::primitive::usize,
        ) -> ::core::option::Option<cga_rt::Value> {
            ::core::option::Option::None
        }
        fn attribute_set(&mut self, _: ::core::primitive::usize, _: cga_rt::Value) {}
        fn start_rules(&self) -> &'static [cga_rt::StartRule] {
            &[]
        }
        fn derive(
            &self,
            _: &cga_rt::Shape,
            _: &cga_rt::Settings,
            _: &mut dyn cga_rt::Sink,
        ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
            ::core::unreachable!("the rules have errors")
        }
    }
};
