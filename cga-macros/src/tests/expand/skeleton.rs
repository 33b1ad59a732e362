///The grammar `Tower`.
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct Tower {
    ///The attribute `height`.
    #[allow(dead_code)]
    pub height: ::core::primitive::f64,
    ///The attribute `storeys`.
    #[allow(dead_code)]
    pub storeys: ::core::option::Option<::cga::__rt::String>,
}
#[automatically_derived]
impl ::core::default::Default for Tower {
    fn default() -> Self {
        Tower {
            height: 24f64,
            storeys: ::core::option::Option::None,
        }
    }
}
