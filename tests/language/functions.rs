//! Functions of the language, from rules to numbers. That each is right is tested beside it in the runtime; here, that
//! rules reach it.

use cga::{Error, LimitKind, Shape, cga};

#[test]
fn functions_of_single_values_run() {
    cga! {
        grammar Functions;
        @StartRule
        Lot --> Text Numbers Lists Colours Files Chance
        Text -->
            case len("größe") == 5 && find("CE_Zero CE_One", "CE", 1) == 8 && count("aaa", "aa") == 1
                && substring("0123456789", 2, 5) == "234" && replace("a#b", "#", "-") == "a-b"
                && findFirst("rule your city", "r") == 0 && findLast("rule your city", "r") == 8
                && getPrefix("a.b.c", ".") == "a" && getSuffix("a.b.c", ".") == "c" && getRange("a.b.c", ".", ".") == "b"
                && "n = " + str(1.69 - 0.69) + (len("a" + "b") + 1) == "n = 13" : Ok.
            else : Bad.
        Numbers -->
            case floor(1.5) == 1 && ceil(1.5) == 2 && rint(1.5) == 2 && abs(0 - 1) == 1 && sqrt(9) == 3
                && sin(90) == 1 && cos(180) == 0 - 1 && tan(45) == 1 && asin(1) == 90 && acos(0 - 1) == 180
                && atan(1) == 45 && atan2(1, 0) == 90 && pow(2, 10) == 1024 && exp(0) == 1 && ln(1) == 0
                && log10(100) == 2 && min(1, 2) == 1 && max(1, 2) == 2 && clamp(7, 0, 5) == 5
                && isnan(ln(0 - 1)) && isinf(ln(0)) && isNull(ln(0 - 1)) && float("5+6") == 5 && float(true) == 1
                && bool("x") && !bool(0) : Ok.
            else : Bad.
        Lists -->
            case listSize(listAdd("rule;your;", "city")) == 3 && listItem("rule;your;", 1) == "your"
                && listIndex("rule;your;city;", "*y*") == 1 && listCount("rule;your;city;", "*y*") == 2
                && listClean(";;a;;b") == "a;b;" && listFirst("a;b;") == "a" && listLast("a;b;") == "b"
                && listRange("a;b;c;", 1, 3) == "b;c;" && listRemove("a;b;a;", "a") == "b;a;"
                && listRemoveAll("a;b;a;", "a") == "b;" && listRetainAll("a;b;a;", "a") == "a;a;"
                && listTerminate("a;b") == "a;b;" : Ok.
            else : Bad.
        Colours -->
            case colorHSVToHex(90, 0.5, 0.5) == "#608040" && colorRGBToHex(0, 0.5, 1) == "#0080FF"
                && colorRGBOToHex(0, 0.5, 1, 0.5) == "#0080FF80" && colorHSVOToHex(0, 0, 1, 1) == "#FFFFFFFF"
                && colorHexToR("#ff0000") == 1 && colorHexToG("#00ff00") == 1 && colorHexToB("#0000ff") == 1
                && colorHexToH("#0000ff") == 240 && colorHexToS("#0000ff") == 1 && colorHexToV("#0000ff") == 1
                && colorHexToO("#0000ff") == 0 && colorRamp("whiteToBlack", 1) == "#000000" : Ok.
            else : Bad.
        Files -->
            case fileName("a/b.c.obj") == "b.c.obj" && fileBasename("a/b.c.obj") == "b.c"
                && fileDirectory("a/b.c.obj") == "a/" && fileExtension("a/b.c.obj") == "obj" : Ok.
            else : Bad.
        Chance -->
            case p(2) && !p(0 - 1) && rand() < 1 && rand(2) <= 2 && rand(3, 4) >= 3
                && listIndex("a;b;", listRandom("a;b;")) >= 0 : Ok.
            else : Bad.
    }
    let model = Functions::default().generate(&Shape::rectangle(1.0, 1.0)).expect("a model");
    assert!(model.faults().is_empty(), "{:?}", model.faults());
    assert_eq!(model.counts(), [("Ok", 6)]);
}

#[test]
fn numbers_that_are_none_leave_a_fault() {
    cga! {
        grammar Faulty;
        attr zero = 0
        @StartRule
        Lot --> s(floor(1 / zero) + 1, 1 + sin(0 / zero), cos(zero / zero)) X.
    }
    let model = Faulty::default().generate(&Shape::rectangle(2.0, 2.0)).expect("a model");
    assert_eq!(model.faults().len(), 3);
    assert_eq!(model.leaves().next().expect("a leaf").size(), cga::glam::DVec3::ONE);
}

#[test]
fn text_that_grows_for_ever_ends_the_run() {
    cga! {
        grammar Growing;
        twice(text, n) = case n == 0 : text else : twice(text + text, n - 1)
        @StartRule
        Lot --> case len(twice("0123456789", 100)) > 0 : A. else : B.
    }
    match Growing::default().generate(&Shape::rectangle(2.0, 2.0)) {
        Err(Error::Limit { what: LimitKind::Text, .. }) => {}
        other => panic!("{other:?}"),
    }
}
