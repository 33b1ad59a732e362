//! Single values: conversions, what is no number, colours.

use crate::each_is;

#[test]
fn conversions() {
    each_is! { ""
        "bool(\"f\")" => "false",
        "bool(\"false\")" => "false",
        "bool(\"0\")" => "false",
        "bool(\"0.0\")" => "false",
        "bool(\"x\")" => "true",
        "bool(\"true\")" => "true",
        "bool(6.66)" => "true",
        "bool(zero)" => "false",
        "bool(11.5 == zero)" => "false",
        r#"floatArray(["1.5","-2","0","nixda","5+6"])"# => "[1.5,-2,0,nan,5]",
        "floatArray([true,false])" => "[1,0]",
        "boolArray([one,0,20])" => "[true,false,true]",
        r#"boolArray(["true","1","0","f","false","x"])"# => "[true,true,false,false,false,true]",
        "floatArray([1,0;one,20])" => "[1,0;1,20]",
        "boolArray([true,one == 2])" => "[true,false]",
        r#"stringArray(["true","CityEngine",""])"# => r#"["true","CityEngine",""]"#,
        "stringArray([1,1.777])" => r#"["1","1.777"]"#,
        "stringArray([true;false])" => r#"["true";"false"]"#,
        "str(001)" => "\"1\"",
        "str(1.69)" => "\"1.69\"",
        "str(1.69 - 69/100)" => "\"1\"",
        "str(true)" => "\"true\"",
        "str([1,2])" => "\"(2)[1,2]\"",
        "float(\"001.5\")" => "1.5",
        "float(true)" => "1",
        "float(one/zero)" => "inf",
        "isnan(float(\"a\"))" => "true",
    }
}

#[test]
fn what_is_no_number_and_what_is_infinite() {
    each_is! { ""
        "isinf(ln(zero))" => "true",
        "isnan(ln(-one))" => "true",
        "isinf(ln(-one))" => "false",
        "isNull(ln(-one))" => "true",
        "isinf(1/zero)" => "true",
        "isinf(one)" => "false",
        "isNull(\"CityEngine\")" => "false",
        r#"isNull("\ue000")"# => "true",
        r#"isNull(["CityEngine","\ue000"])"# => "[false,true]",
        "isinf([1,one/zero])" => "[false,true]",
        "isnan([1;ln(-one)])" => "[false;true]",
    }
}

#[test]
fn colours() {
    each_is! { ""
        "colorHSVToHex(90,0.5,0.5)" => "\"#608040\"",
        "colorRGBToHex(zero,0.5,1)" => "\"#0080FF\"",
        "colorRGBOToHex(0,0.5,1,0.5)" => "\"#0080FF80\"",
        "rint(100000 * colorHexToR(\"#4080BF\"))" => "25098",
        "colorHexToO(\"#4080BF\")" => "0",
    }
}

#[test]
fn ramps_have_36_steps() {
    each_is! { "step(v) = colorRamp(\"whiteToBlack\", v)"
        "step(-one) == step(0)" => "true",
        "step(one) == step(0.99)" => "true",
        "step(2) == step(1)" => "true",
        "step(3.1/36) == step(3.9/36)" => "true",
        "step(3.9/36) == step(4.1/36)" => "false",
        "step(zero)" => "\"#FFFFFF\"",
    }
}
