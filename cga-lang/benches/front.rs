//! The front half of the macro: text to tokens, tree, checked program and IR, for 1,000 rules as people write them.
//!
//! `cargo bench -p cga-lang --bench front`

use cga_lang::compile::{CompiledText, Dialect, compile, compile_text};
use cga_lang::diag::Diags;
use cga_lang::link::{NoFiles, Unit};
use cga_lang::syntax::lex::lex;
use cga_lang::syntax::parse::parse;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The limit on the time for 1,000 rules, too short to be noticed in a build.
const MOST: Duration = Duration::from_millis(100);

/// A building: ten rules with the attributes and functions they need, numbered so that many make one grammar.
const BUILDING: &str = r##"
/// How tall it is.
@Group("Building _", 1) @Range(min = 3, max = 60) attr height_ = case p(0.3) : rand(9, 18) else : 24
@Enum("brick", "plaster", "glass") attr facade_ = 40% : "brick" 30% : "plaster" else : "glass"
attr tile_ = 2.5
const floors_ = floor(height_ / 3.2)
const ground_ = 4.2
colour_(what) = case what == "brick" : "#8a4b32" case what == "plaster" : "#e0d8c8" else : "#a0b8c8"
width_(n, of) = tile_ * (1 + n / (of + 1)) * case n % 2 == 0 : 1.1 else : 0.9

@StartRule
Lot_ --> offset_(0.6) Mass_(height_ * 0.9, floors_)
offset_(by) --> s('0.9, '1, '0.9) center(xz) report("by_", by)
Mass_(tall, levels) -->
	case levels > 12 && scope.sx > 10 : extrude(tall) split(y) { '0.6 : Sides_(levels - 4) | ~1 : s('0.8, '1, '0.8) center(xz) Sides_(4) }
	case levels > 2 : extrude(tall) Sides_(levels)
	else : extrude(3.5) color(0.8, 0.2, 0.1) Hut_.
Sides_(levels) --> comp(f) { front : Facade_(levels, true) | side : Facade_(levels, false) | top : Roof_ }
Facade_(levels, shop) --> # the ground floor differs
	split(y) { ground_ : Ground_(shop) | { ~3.2 : Floor_(split.index, levels) | 0.2 : color(colour_(facade_)) Ledge. }* | 0.5 : Cornice. }
Ground_(shop) --> case shop : split(x) { 1 : Wall_ | { ~4 : ShopWindow. | 0.4 : Wall_ }* | 1.2 : Dialect. | 1 : Wall_ } else : Wall_
Floor_(i, n) -->
	split(x) { 0.5 : Wall_ | { ~width_(i, n) : Tile_(i, split.index) }* | 0.5 : Wall_ }
Tile_(row, column) -->
	30% : split(x) { ~1 : Wall_ | 1.2 : split(y) { 0.9 : Wall_ | 1.4 : Window_(row + column) | ~1 : Wall_ } | ~1 : Wall_ }
	20% : [ t(0, 0, '0.1) s('1, '1, 0.4) Balcony. ] Wall_
	else : Wall_
Window_(n) --> t(0, 0, -0.15) color(case n % 3 == 0 : "#203040" else : "#405060") primitiveQuad() Glass.
Roof_ --> case height_ > 30 && !(facade_ == "glass") : extrude(0.4) color("#555555") Flat. else : s('1, 0, '1) print("roof " + str(height_)) Roof.
Wall_ --> color(colour_(facade_)) set(material.opacity, 1) Wall.
"##;
const RULES: usize = 11;

fn city(rules: usize) -> String {
    (0..rules.div_ceil(RULES)).map(|number| BUILDING.replace('_', &format!("_{number}"))).collect()
}

/// Best times of lexing alone, lexing and parsing, and everything, in turn.
fn times(text: &str) -> [Duration; 3] {
    let mut best = [Duration::MAX; 3];
    let begin = Instant::now();
    let mut rounds = 0;
    while rounds < 5 || begin.elapsed() < Duration::from_secs(1) {
        let ways: [&dyn Fn(); 3] = [
            &|| _ = black_box(lex(black_box(text))),
            &|| {
                let lexed = lex(black_box(text));
                let mut diags = Diags::new();
                black_box(parse(&lexed.tokens, &mut diags));
                diags.finish();
            },
            &|| {
                let lexed = lex(black_box(text));
                black_box(compile(
                    Unit { found: lexed.diags, ..Unit::new(lexed.tokens, Dialect::Text) },
                    &mut NoFiles,
                    &[],
                ));
            },
        ];
        for (way, best) in ways.into_iter().zip(&mut best) {
            let start = Instant::now();
            way();
            *best = (*best).min(start.elapsed());
        }
        rounds += 1;
    }
    best
}

fn main() {
    let mut each = 0.0;
    for rules in [100, 1000, 4000] {
        let text = city(rules);
        let CompiledText { tokens, compiled, .. } = compile_text(&text);
        assert_eq!(compiled.diags, []);
        assert!(rules <= compiled.grammar.expect("no findings").rules.len());
        let best = times(&text);
        let ms = best.map(|time| time.as_secs_f64() * 1e3);
        let one = ms[2] / rules as f64;
        println!(
            "{rules:>5} rules {:>7} tokens   lex {:>6.2} ms   and parse {:>6.2} ms   all {:>6.2} ms   ratio to lexing {:>5.1}   \
             time a rule, ratio to fewer {:>5.2}",
            tokens.len(),
            ms[0],
            ms[1],
            ms[2],
            ms[2] / ms[0],
            if each == 0.0 { 1.0 } else { one / each },
        );
        each = one;
        assert!(rules != 1000 || best[2] < MOST, "1,000 rules took {:?}", best[2]);
    }
}
