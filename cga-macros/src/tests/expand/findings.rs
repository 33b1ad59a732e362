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
    #[automatically_derived]
    impl cga_rt::Unrunnable for Tower {}
    #[automatically_derived]
    impl cga_rt::Grammar for Tower {
        fn name(&self) -> &::core::primitive::str {
            "Tower"
        }
        fn attributes(&self) -> &[cga_rt::Attribute] {
            &[]
        }
        fn attribute_get(
            &self,
            _: ::core::primitive::usize,
        ) -> ::core::option::Option<cga_rt::Value> {
            ::core::option::Option::None
        }
        fn attribute_set(&mut self, _: ::core::primitive::usize, _: cga_rt::Value) {}
        fn attribute_reset(&mut self, _: ::core::primitive::usize) {}
        fn boxed(
            &self,
        ) -> cga_rt::Box<
            dyn cga_rt::Grammar + ::core::marker::Send + ::core::marker::Sync,
        > {
            cga_rt::Box::new(::core::clone::Clone::clone(self))
        }
        fn used_values(
            &self,
            _: &cga_rt::Shape,
            _: &cga_rt::Settings,
        ) -> ::core::result::Result<
            cga_rt::Vec<(cga_rt::Text, cga_rt::Value)>,
            cga_rt::Error,
        > {
            ::core::unreachable!("the rules have errors")
        }
        fn start_rules(&self) -> &[cga_rt::StartRule] {
            &[]
        }
        fn run(
            &self,
            _: &cga_rt::Shape,
            _: &cga_rt::Settings,
            _: &mut dyn cga_rt::Sink,
        ) -> ::core::result::Result<cga_rt::Report, cga_rt::Error> {
            ::core::unreachable!("the rules have errors")
        }
    }
};
