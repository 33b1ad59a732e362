//! Many rules: styles of a building with ten rules each and typical operations. No two styles have the same numbers,
//! so no two rules are the same function.

use std::fmt::Write;

/// CGA text with `count` rules or a few more.
pub(crate) fn rules(count: usize) -> String {
    let mut text = String::from(
        "version \"2025.1\"\n\
         @Range(min=6, max=90)\n\
         attr height = 24\n\
         @Range(min=0, max=1)\n\
         attr wear = 0.2\n\
         const bay = 2.6\n\
         floorHeight = case height > 30 : 3.4 else : 3.1\n\n",
    );
    for style in 0..count.div_ceil(10) {
        let name = format!("_{style}");
        let colors = [0x50_4030, 0x70_8090, 0xa0_9060].map(|first: usize| format!("#{:06x}", first + 7 * style));
        let [wall, trim, roof] = colors;
        let share = 20 + style % 60;
        let size = |base: f64, step: f64| format!("{:.4}", base + step * style as f64 / 100.0);
        let (door, frame, depth, sill) = (size(1.1, 0.1), size(0.06, 0.01), size(0.12, 0.02), size(0.8, 0.1));
        let result = write!(
            text,
            r#"@StartRule
Lot{name} -->
    color("{wall}")
    extrude(height + {sill})
    comp(f) {{ front : Facade{name}(true) | side : Facade{name}(false) | top : Roof{name} }}
Facade{name}(entrance) -->
    case scope.sx < {door} : Wall{name}
    else : split(y) {{ 4 : Ground{name}(entrance) | {{ ~floorHeight : Floor{name}(split.index) }}* | {frame} : Trim{name} }}
Ground{name}(entrance) -->
    case entrance : split(x) {{ ~1 : Wall{name} | {door} : t(0, 0, -{depth}) Door. | ~1 : Wall{name} }}
    else : split(x) {{ {{ ~{sill} * 3 : Wall{name} | ~2 : Window{name}(2) }}* | ~{sill} : Wall{name} }}
Floor{name}(level) -->
    case level % 4 == 3 && wear < 0.9 : split(x) {{ {frame} : Trim{name} | ~1 : Wall{name} | {frame} : Trim{name} }}
    else : split(x) {{ {sill} : Wall{name} | {{ ~bay : Tile{name}(level) }}* | {sill} : Wall{name} }}
Tile{name}(level) -->
    split(x) {{ ~1 : Wall{name}
             | {door} : split(y) {{ {sill} : Wall{name} | ~1.5 : Window{name}(1 + level % 2) | '0.2 : Wall{name} }}
             | ~1 : Wall{name} }}
Window{name}(panes) -->
    [ t(0, 0, -{depth}) Glass{name} ]
    split(x) {{ {frame} : Trim{name} | {{ ~scope.sx / panes : NIL | {frame} : Trim{name} }}* }}
Glass{name} -->
    {share}% : color("{roof}") set(material.opacity, 0.6) Lit.
    else : color("{trim}") Dark.
Trim{name} -->
    color("{trim}") extrude({depth}) Trim.
Wall{name} -->
    case wear > rand(1) : color("{roof}") Worn.
    else : set(material.roughness, {frame}) Wall.
Roof{name} -->
    case geometry.area > 200 + {sill} : color("{roof}") Flat.
    else : extrude(0.3 + {share} / 100) comp(f) {{ bottom : NIL | all : color("{roof}") Slope. }}

"#
        );
        result.expect("a string takes text");
    }
    text
}
