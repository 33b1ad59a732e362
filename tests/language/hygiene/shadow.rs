//! The user's own items have the names of the standard library's, and of what generated code is made of.
#![allow(dead_code, unused_macros, non_camel_case_types, reason = "they only stand in the way")]

mod core {}
mod std {}
mod alloc {}
mod cga_runtime {}
struct f64;
struct bool;
struct str;
struct u32;
struct String;
struct Option;
struct Some;
struct None;
struct Ok;
struct Err;
struct Result;
struct Vec;
struct Default;
struct Clone;
struct Debug;
struct Sized;
struct From;
struct Shape;
struct Sink;
struct Model;
struct Error;
struct Text;
struct CgaSink;
struct Values;

macro_rules! format {
    ($($any:tt)*) => {
        compile_error!("the user's")
    };
}
macro_rules! unreachable {
    ($($any:tt)*) => {
        compile_error!("the user's")
    };
}
macro_rules! vec {
    ($($any:tt)*) => {
        compile_error!("the user's")
    };
}
macro_rules! matches {
    ($($any:tt)*) => {
        compile_error!("the user's")
    };
}

::cga::cga! {
    grammar Shadowed;
    attr height = 3
    attr about = "text"
    attr computed = rand(1)
    attr words = about + computed
    fac(n) = case n < 2 : 1 else : n * fac(n - 1)
    Lot --> extrude(height) Floor(2, true, "text")
    Floor(n, b, t) --> case n > 0 && b : Floor(n - 1, b, t + words) else : split(x) { ~fac(3) : Wall. }
}

#[test]
fn items_of_the_user_do_not_get_in_the_way() {
    let (height, name) = (3, "#ffffff");
    let shape = ::cga::Shape::rectangle(4.0, 4.0);
    let rules = ::cga::cga! { Lot --> extrude(#height) color(#name) Wall. };
    assert!(Shadowed::default().generate(&shape).is_ok() && rules.generate(&shape).is_ok());
}
