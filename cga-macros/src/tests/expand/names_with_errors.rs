const _: () = {
    #[allow(non_upper_case_globals, non_snake_case, dead_code)]
    mod names {
        macro_rules! computed {
            () => {
                ::core::unreachable!()
            };
        }
        fn unknown() {
            ((
                operations::Rof,
                operations::the_last_name_of_the_list_is_longer_than_names_in_rules,
            ));
            ((annotations::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((selectors::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((values::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((values_1::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((extrude_0::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((split_0::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((split_1::the_last_name_of_the_list_is_longer_than_names_in_rules));
        }
        mod operations {
            pub use ::cga::__rt::words::operations::*;
            pub use ::cga::__rt::words::syntax::*;
            /**```text
Lot --> extrude(height) Facade(height) Rof
```*/
            pub fn Lot() {}
            /**```text
Facade(width) --> split(y) { ~width : Roof }
```*/
            pub fn Facade(width: f64) {
                width;
            }
            /**```text
Roof --> A.
```*/
            pub fn Roof() {}
            ///A leaf.
            pub const A: () = ();
            fn names() {
                (extrude, Facade, split, Roof);
            }
        }
        mod annotations {
            pub use ::cga::__rt::words::annotations::*;
        }
        mod selectors {
            pub use ::cga::__rt::words::selectors::*;
        }
        mod values {
            pub use ::cga::__rt::words::attributes::*;
            pub use ::cga::__rt::words::functions::*;
            pub use ::cga::__rt::words::syntax::*;
            ///The attribute `height`.
            pub const height: f64 = 0.0;
        }
        mod values_1 {
            pub use super::values::*;
            pub const width: f64 = 0.0;
        }
        mod extrude_0 {
            pub use ::cga::__rt::words::arguments::extrude_0::*;
        }
        mod split_0 {
            pub use ::cga::__rt::words::arguments::split_0::*;
            fn names() {
                (y,);
            }
        }
        mod split_1 {
            pub use ::cga::__rt::words::arguments::split_1::*;
        }
    }
    fn outside(grammar: &Tower) {
        grammar.height;
        grammar.height;
    }
};
