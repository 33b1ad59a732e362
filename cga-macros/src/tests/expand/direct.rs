#[derive(::core::default::Default)]
pub struct CgaValues {}
type CgaCall = cga_rt::NoCall;
/// The rules and functions, one function each.
enum CgaRules {}
