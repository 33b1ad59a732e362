/// An office tower.
///
///[`generate`](Self::generate) runs it on a shape, [`generate_from`](Self::generate_from) from another rule, and
///[`generate_with`](Self::generate_with) with settings. [`run`](Self::run) fills a sink,
///[`generate_all`](Self::generate_all) takes many shapes, and [`session`](Self::session) runs one after another.
#[derive(::core::clone::Clone, ::core::fmt::Debug)]
pub struct Tower {
    /**The attribute `height`, default `24`, range 3 to 60.

Height in metres.*/
    pub height: ::core::primitive::f64,
    ///The attribute `colour`, default `"#ffffff"`.
    pub colour: ::cga::__rt::String,
    ///The attribute `type`, default `true`.
    pub r#type: ::core::primitive::bool,
    ///The attribute `storeys`, `None` computes the default for each initial shape.
    pub storeys: ::core::option::Option<::core::primitive::f64>,
}
#[automatically_derived]
impl ::core::default::Default for Tower {
    fn default() -> Self {
        Tower {
            height: 24f64,
            colour: ::cga::__rt::string("#ffffff"),
            r#type: true,
            storeys: ::core::option::Option::None,
        }
    }
}
