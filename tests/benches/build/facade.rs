//! A façade file with styles, similar to published ones: elements with attributes, constants, functions and rules.
//! Each style changes a quarter of the attributes and has two rules of its own.
//!
//! The elements can be a library, too, that several files import.

use std::fmt::Write;

/// The elements of a façade.
const ELEMENTS: [&str; 12] =
    ["Window", "Door", "Balcony", "Cornice", "Pillar", "Arcade", "Loggia", "Dormer", "Shop", "Frieze", "Plinth", "Bay"];

/// The rules, with `styles` styles beside `Default`.
pub(crate) fn rules(styles: usize) -> String {
    let mut text = String::from(HEAD) + &elements(&ELEMENTS);
    for style in 0..styles {
        let _ = writeln!(text, "\nstyle Style{style}");
        for at in 0..15 {
            let element = ELEMENTS[(style + at * 5 + at / 12) % ELEMENTS.len()].to_lowercase();
            let _ = match at % 4 {
                0 => writeln!(text, "attr {element}_width = {}.{}", 1 + at % 2, 2 + style % 7),
                1 => writeln!(text, "attr {element}_height = {}.{}", 1 + style % 3, at % 9),
                2 => writeln!(text, "attr {element}_depth = 0.{}", 1 + (style + at) % 4),
                _ => writeln!(text, "attr {element}_color = \"#{:02x}{:02x}40\"", 16 * style, 9 * at),
            };
        }
        let (one, two) = (ELEMENTS[style % 12], ELEMENTS[(style + 7) % 12]);
        text += &STYLE.replace("One", one).replace("one", &one.to_lowercase()).replace("Two", two);
    }
    text
}

/// The files of a building with a library of five elements, which each wing imports twice. The first file is the main one.
pub(crate) fn imports(wings: usize) -> Vec<(String, String)> {
    let mut main = String::from(MAIN);
    let mut files = vec![(
        "library.cga".to_owned(),
        String::from(LIBRARY) + &elements(&["Window", "Door", "Balcony", "Cornice", "Pillar"]),
    )];
    for wing in 0..wings {
        let text = WING.replace("NUMBER", &wing.to_string());
        files.push((format!("wing{wing}.cga"), text));
        let _ = writeln!(main, "import wing{wing} : \"wing{wing}.cga\"");
    }
    main += "Lot --> split(x) { ~1 : extrude(height) comp(f) { side : library.WindowFloor(1) }";
    for wing in 0..wings {
        let _ = write!(main, " | ~1 : wing{wing}.Wing");
    }
    main += " }\n";
    files.insert(0, ("main.cga".to_owned(), main));
    files
}

/// Elements that refer to each other in a circle.
fn elements(names: &[&str]) -> String {
    let element = |(number, name): (usize, &&str)| {
        ELEMENT
            .replace("Element", name)
            .replace("element", &name.to_lowercase())
            .replace("NEXT", names[(number + 1) % names.len()])
            .replace("NUMBER", &number.to_string())
    };
    names.iter().enumerate().map(element).collect()
}

const MAIN: &str = r##"import library : "library.cga"
attr height = 20
"##;

const LIBRARY: &str = r##"attr wall_color = "#c8b8a0"
kind(n) = case n % 3 == 0 : "plain" case n % 3 == 1 : "arched" else : "framed"
"##;

const WING: &str = r##"import front : "library.cga" (window_width = NUMBER.5, door_depth = own)
import back : "library.cga"
attr own = 0.3
attr floor_height = 3.NUMBER
Wing -->
    extrude(own * 30)
    comp(f) { front : Front | back : Back | side : Side | top : Roof. }
Front -->
    split(y) { 4 : front.DoorFloor(1) | { ~floor_height : front.WindowFloor(split.index) }* }
Back -->
    split(y) { 4 : back.DoorFloor(2) | { ~floor_height : back.BalconyFloor(split.index) }* }
Side -->
    split(x) { ~1 : front.WindowTrim | ~1 : back.PillarTrim }
"##;

const HEAD: &str = r##"/** A façade of elements. */
@Group("Building", 0) @Range(min=6, max=60)
attr height = 24
@Group("Building", 0) @Range(min=3, max=6)
attr floor_height = 3.4
@Group("Building", 0)
attr ground_height = 4.5
@Group("Building", 0)
attr wall_color = "#c8b8a0"
const floors = floor((height - ground_height) / floor_height)
const rest = height - ground_height - floors * floor_height
kind(n) = case n % 3 == 0 : "plain" case n % 3 == 1 : "arched" else : "framed"

@StartRule
Lot --> extrude(height) comp(f) { front : Front | side : Side | top : Roof }
Front -->
    split(y) {
        ground_height : Ground
      | { ~floor_height : WindowFloor(split.index) | ~floor_height : BalconyFloor(split.index) }*
      | rest : CorniceTrim
    }
Side -->
    color(wall_color)
    split(y) { ground_height : PlinthFloor(0) | { ~floor_height : BayFloor(split.index) }* }
Ground --> split(x) { ~1 : ShopFloor(0) | '0.2 : DoorFloor(1) | ~1 : ArcadeFloor(2) }
Roof --> color("#604030") split(x) { 1 : Edge | ~1 : DormerFloor(3) | 1 : Edge }
Edge --> extrude(0.3) Edge2
Edge2 --> comp(f) { top : Gutter. | all : Slab. }
"##;

const ELEMENT: &str = r##"
@Group("Element", NUMBER) @Range(min=0.5, max=4)
attr element_width = 1.4
@Group("Element", NUMBER) @Range(min=0.5, max=4)
attr element_height = 1.8
@Group("Element", NUMBER)
attr element_depth = 0.2
@Group("Element", NUMBER) @Color
attr element_color = "#8090a0"
@Group("Element", NUMBER) @Enum("plain", "arched", "framed")
attr element_kind = kind(NUMBER)

const element_frame = element_width * 0.05
const element_step = element_height / 4
element_inset(n) = case n > 2 : element_depth / n else : element_depth * 0.5
element_size(h) = case element_kind == "framed" : h - 2 * element_frame else : h

ElementFloor(n) -->
    color(wall_color)
    split(x) {
        element_frame : ElementPier
      | { ~element_width : ElementBay(n + split.index) | element_frame : ElementPier }*
    }
ElementPier -->
    case element_depth > 0.3 : extrude(element_depth) ElementPost
    else : color(element_color) Pier.
ElementPost --> comp(f) { front : color(element_color) Pier. | side : Pier. | all : NIL }
ElementBay(n) -->
    split(y) {
        element_step : ElementSill(n)
      | element_size(element_height) : ElementOpening(n)
      | element_frame : ElementCorner
      | ~1 : ElementLintel
    }
ElementSill(n) -->
    case n % 2 == 0 : t(0, 0, element_inset(n)) color(element_color) Sill.
    case n % 5 == 3 : ElementRail(scope.sy)
    else : ElementPanel
ElementPanel -->
    split(x) { '0.1 : Wall. | { ~0.4 : ElementField }* | '0.1 : Wall. }
ElementField -->
    split(y) { 0.05 : Wall. | ~1 : t(0, 0, -0.02) color(element_color) Field. | 0.05 : Wall. }
ElementOpening(n) -->
    case element_kind == "plain" : ElementGlass
    case element_kind == "arched" && scope.sx > 0.4 : ElementArch(n)
    else : split(x) { element_frame : ElementJamb | ~1 : ElementGlass | element_frame : ElementJamb }
ElementArch(n) -->
    split(y) { ~2 : ElementGlass | ~1 : ElementHead(n) }
ElementHead(n) -->
    case n > 4 : 30% : color("#d0d0d0") Head. else : color(element_color) Head.
    else : ElementGlass
ElementJamb --> extrude(element_inset(3)) color(element_color) comp(f) { back : NIL | all : Jamb. }
ElementGlass -->
    split(x) { { ~0.5 : ElementPane }* }
ElementPane -->
    split(y) {
        0.04 : Bar.
      | ~1 : 40% : color("#f0e0a0") Glass. else : color("#6080a0") Glass.
      | 0.04 : Bar.
    }
ElementLintel -->
    case scope.sy > element_step : split(y) { ~1 : Wall. | element_step : NEXTTrim }
    else : Wall.
ElementCorner -->
    case scope.sx > scope.sy :
        split(x) {
            element_frame : ElementJamb
          | ~1 : ElementBay(0)
          | element_frame : ElementJamb
        }
    case element_kind == "arched" :
        split(y) {
            ~1 : ElementPane
          | element_step : ElementHead(6)
        }
    else :
        color(element_color)
        Corner.
ElementRail(h) -->
    split(y) {
        h - 0.1 : split(x) { { 0.05 : Post. | ~element_step : NIL }* | 0.05 : Post. }
      | 0.1 : color(element_color) s('1, '1, 0.1) Rail.
    }
ElementTrim -->
    [ t(0, 0, element_inset(1)) s('1, 0.1, element_depth) Shadow. ]
    s('1, '1, element_depth)
    color(element_color)
    Trim.
"##;

const STYLE: &str = r##"OnePanel -->
    split(x) { { ~0.3 : OneField | 0.1 : Wall. }* }
OneTrim -->
    case scope.sx > 2 : split(x) { 0.2 : Cap. | ~1 : color(one_color) Trim. | 0.2 : Cap. }
    else : extrude(one_depth) Block.
TwoLintel --> color(wall_color) Plain.
"##;
