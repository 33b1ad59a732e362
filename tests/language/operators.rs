//! Operators, on single values and over the elements of arrays.

use crate::{each_is, lines, model};
use cga::cga;

#[test]
fn operators_over_elements() {
    each_is! { ""
        "[8;-5;0] .% 3" => "[2;-2;0]",
        "7 .% [2.7,-3]" => "[1.6,1]",
        "[1,2;3,4] .- 1" => "[0,1;2,3]",
        "[1,2] .+ one" => "[2,3]",
        "one .+ [1;2]" => "[2;3]",
        "[1,2] .+ [2,1]" => "[3,3]",
        ".+[1,2]" => "[1,2]",
        ".-[1;2]" => "[-1;-2]",
        "3 .- [1,2]" => "[2,1]",
        "[4,2] .* 2.5" => "[10,5]",
        "-4 .* [0.25;-0.75;-1]" => "[-1;3;4]",
        "[1,2;3,4] .* [4,3;2,1]" => "[4,6;6,4]",
        "12 ./ [2,3,4]" => "[6,4,3]",
        "[1,2] ./ zero" => "[inf,inf]",
        ".![true,false]" => "[false,true]",
        "[true,false] .|| true" => "[true,true]",
        "false .|| [false;true]" => "[false;true]",
        "[true,false] .&& [false,true]" => "[false,false]",
        "1 .== [one,2]" => "[true,false]",
        r#"["a","b"] .== "b""# => "[false,true]",
        "[1,1;2,2] .!= [1,2;1,2]" => "[false,true;true,false]",
        "false .!= [true]" => "[true]",
        "[1,2;3,4] .> [1,1;3,3]" => "[false,true;false,true]",
        "2 .>= [1,2,3]" => "[true,true,false]",
        "1 .< [1,2]" => "[false,true]",
        "[1,2] .<= one" => "[true,false]",
        r#"["a";"b"] .> "a""# => "[false;true]",
        r#"["a","b"] .+ "c""# => r#"["ac","bc"]"#,
        r#"["a","b"] .+ ["c","d"]"# => r#"["ac","bd"]"#,
        r#""a" .+ [1,2;3,4]"# => r#"["a1","a2";"a3","a4"]"#,
        r#"[1;2] .+ ["a";"b"]"# => r#"["1a";"2b"]"#,
        r#"[true;false] .+ "a""# => r#"["truea";"falsea"]"#,
        // Multiplication before addition, comparison before the logical ones, as without the dots.
        "[1,2] .+ [3,4] .* 2" => "[7,10]",
        "[1,2] .> 1 .&& [1,2] .< 3" => "[false,true]",
        "sum([1,2,3] .== 2 .|| [1,2,3] .> 2)" => "2",
    }
}

#[test]
fn operators_on_single_values() {
    each_is! { ""
        "one + 2 * 3" => "7",
        "-5 % 3" => "-2",
        "5 % -3" => "2",
        "7 - 4 - 2" => "1",
        "-one - -one" => "0",
        "+one" => "1",
        "!(one == 1) || zero < 1 && true" => "true",
        "one % 2 == 0" => "false",
        "\"a\" < \"b\"" => "true",
        "\"B\" < \"a\"" => "true",
        "\"abc\" >= \"abcd\"" => "false",
        "\"a\" != \"a\"" => "false",
        "\"Rule: \" + one" => "\"Rule: 1\"",
        "one + \"th\"" => "\"1th\"",
        "true + \" is it\"" => "\"true is it\"",
        "one + one + \"a\" + one + one" => "\"2a11\"",
        "\"is: \" + [1,2]" => "\"is: (2)[1,2]\"",
        "[true] + \" it is\"" => "\"(1)[true] it is\"",
        "case one > 2 : \"big\" else : \"small\"" => "\"small\"",
    }
}

#[test]
fn what_is_no_number_is_less_than_anything() {
    each_is! { "nan = zero / zero"
        "nan == nan" => "false",
        "nan != nan" => "true",
        "nan < 1" => "true",
        "1 <= nan" => "true",
        "nan > 1" => "false",
        "nan >= nan" => "false",
        "[nan] .< [1]" => "[true]",
    }
}

#[test]
fn both_sides_are_evaluated() {
    cga! {
        grammar Sides = r#"
            said(text, truth) = print(text) != "" && truth
            Lot --> case said("f", false) && said("g", true) : A.
                    else : case said("h", true) || said("i", false) : B. else : C.
        "#;
    }
    assert_eq!(lines(&model(&Sides::default())), ["f", "g", "h", "i"]);
    // A draw is used up on the right, whatever the left is.
    cga! {
        grammar Draws = r#"
            left(yes) = case yes && p(0.5) : 1 else : 0
            Lot --> Used Unused Both
            Used --> set(seedian, 7) print(left(false)) print(rand())
            Unused --> set(seedian, 7) print(0) print(rand())
            Both --> set(seedian, 7) print(case p(0.5) : 0 else : 0) print(rand())
        "#;
    }
    let printed = lines(&model(&Draws::default()));
    let [_, used, _, unused, _, both] = printed.as_slice() else { panic!("{printed:?}") };
    assert_eq!(used, both);
    assert_ne!(used, unused);
}
