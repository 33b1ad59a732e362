#[derive(::core::default::Default)]
pub struct CgaValues {
    attr_0: ::core::primitive::f64,
    attr_1: cga_rt::Text,
    const_0: ::core::primitive::f64,
    const_1: ::core::primitive::f64,
    captured_0: ::core::primitive::f64,
    captured_1: cga_rt::Text,
}
#[derive(::core::clone::Clone)]
pub enum CgaCall {
    Rule1(::core::primitive::f64, cga_rt::Text),
}
/// The rules and functions, one function each.
enum CgaRules {}
