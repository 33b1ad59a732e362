const _: () = {
    #[allow(non_upper_case_globals, non_snake_case, dead_code)]
    mod names {
        macro_rules! computed {
            () => {
                ::core::unreachable!()
            };
        }
        fn unknown() {
            ((operations::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((annotations::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((selectors::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((values::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((values_1::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((values_2::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((comp_0::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((comp_1::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((extrude_0::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((split_0::the_last_name_of_the_list_is_longer_than_names_in_rules));
            ((split_1::the_last_name_of_the_list_is_longer_than_names_in_rules));
        }
        mod operations {
            pub use ::cga::__rt::words::operations::*;
            pub use ::cga::__rt::words::syntax::*;
            /**```text
Lot --> set(height, half(3)) extrude(height) comp(f) { side : Facade(height, type) | top : Roof }
```*/
            pub fn Lot() {}
            /**```text
Facade(width, kind) with(wide : = width > 3) --> split(y) { ~floor : [ case wide : Roof else : A. ] | 1 : print(kind) Roof }
```*/
            pub fn Facade(width: f64, kind: &'static str) {
                let wide: bool;
                width;
                wide;
                kind;
            }
            /**```text
Roof --> A.
```*/
            pub fn Roof() {}
            ///A leaf.
            pub const A: () = ();
            fn names() {
                (set, extrude, comp, Facade, Roof, split, case, Roof, print, Roof, A);
            }
        }
        mod annotations {
            pub use ::cga::__rt::words::annotations::*;
        }
        mod selectors {
            pub use ::cga::__rt::words::selectors::*;
            fn names() {
                (side, top);
            }
        }
        mod values {
            pub use ::cga::__rt::words::attributes::*;
            pub use ::cga::__rt::words::functions::*;
            pub use ::cga::__rt::words::syntax::*;
            /**```text
const floor = height / 8
```*/
            pub const floor: f64 = computed!();
            /**```text
half(n) = n / 2
```*/
            pub fn half(n: f64) -> f64 {
                n;
                loop {}
            }
            ///The attribute `height`, default `24`.
            pub const height: f64 = 0.0;
            fn names() {
                (half, floor);
            }
        }
        mod values_1 {
            pub use super::values::*;
            pub const n: f64 = 0.0;
        }
        mod values_2 {
            pub use super::values::*;
            pub const width: f64 = 0.0;
            pub const kind: &'static str = "";
            pub const wide: bool = false;
        }
        mod comp_0 {
            pub use ::cga::__rt::words::arguments::comp_0::*;
            fn names() {
                (f,);
            }
        }
        mod comp_1 {
            pub use ::cga::__rt::words::arguments::comp_1::*;
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
        grammar.height;
        grammar.height;
    }
};
