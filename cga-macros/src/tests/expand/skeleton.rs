///The grammar `Tower`.
///
///[`generate`](Self::generate) runs it on a shape, [`generate_from`](Self::generate_from) from another rule, and
///[`generate_with`](Self::generate_with) with settings. [`run`](Self::run) fills a sink,
///[`generate_all`](Self::generate_all) takes many shapes, and [`session`](Self::session) runs one after another.
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
