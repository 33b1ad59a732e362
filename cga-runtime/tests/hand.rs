//! What `cga!` writes for a small grammar, by hand: the contract between generated code and the runtime, held as a test.
//!
//! ```cga
//! attr height = 24
//! attr bays = height / 6
//! const floor_h = 3
//! tall(x) = x > 20
//! Lot    --> extrude(height) comp(f) { side : Facade | top : color("#808080") Roof. }
//! Facade --> case tall(scope.sy) : split(y) { 4 : Shop. | { ~floor_h : Floor(split.index) }* } else : Plain.
//! Floor(i) --> 30% : Wall. else : [ t(0, 0, -0.1) Glass. ] s('1, '0.5, '1) center(y)
//! S(n)   --> case n == 0 : Cube. else : split(y) { ~1 : S(n - 1) | ~1 : NIL | ~1 : S(n - 1) }
//! ```
#![allow(non_snake_case, missing_docs)]

use cga_runtime::rt;

#[derive(Clone, Debug)]
pub struct Hand {
    pub height: f64,
    /// `None`: computed for each initial shape.
    pub bays: Option<f64>,
}

impl Default for Hand {
    fn default() -> Self {
        Hand { height: 24.0, bays: None }
    }
}

const _: () = {
    #[derive(Default)]
    pub struct Values {
        height: f64,
        bays: f64,
        floor_h: f64,
    }

    pub enum Call {
        S(f64),
    }

    fn tall(_env: &mut rt::Env, _g: &Values, _shape: &mut rt::ShapeRef<'_>, p0: f64) -> bool {
        p0 > 20.0
    }

    fn Lot<S: rt::Sink + ?Sized>(g: &Values, cx: &mut rt::Cx<'_, S, Call>, mut shape: rt::ShapeRef<'_>) -> rt::Flow {
        cx.enter(0)?;
        rt::op::extrude(&mut cx.env, &mut shape, rt::Length::Absolute(g.height));
        {
            let arms = [
                rt::Arm { select: rt::Select::Side, mode: rt::Mode::Each, text: "side" },
                rt::Arm { select: rt::Select::Top, mode: rt::Mode::Each, text: "top" },
            ];
            let parts = rt::faces(&mut cx.env, &mut shape, &arms)?;
            parts.each(|arm, part| match arm {
                0 => Facade(g, cx, part),
                _ => Lot_1(g, cx, part),
            })?;
        }
        cx.leave()
    }

    fn Lot_1<S: rt::Sink + ?Sized>(_g: &Values, cx: &mut rt::Cx<'_, S, Call>, mut shape: rt::ShapeRef<'_>) -> rt::Flow {
        cx.enter(4)?;
        rt::op::color_hex(&mut cx.env, &mut shape, rt::Text::Static("#808080"));
        cx.symbol(&shape, "Roof")?;
        cx.leave()
    }

    fn Facade<S: rt::Sink + ?Sized>(g: &Values, cx: &mut rt::Cx<'_, S, Call>, mut shape: rt::ShapeRef<'_>) -> rt::Flow {
        cx.enter(1)?;
        let mut childless = true;
        if {
            let a0 = rt::get::scope_sy(&shape);
            tall(&mut cx.env, g, &mut shape, a0)
        } {
            let mut sizes = [rt::Size::absolute(4.0), rt::Size::floating(g.floor_h)];
            let pattern = const { &[rt::Item::Slot, rt::Item::Repeat(1), rt::Item::Slot] };
            let parts = rt::divide(&mut cx.env, &mut shape, rt::Axis::Y, rt::Adjust::Adjust, pattern, &mut sizes)?;
            parts.each(|slot, part| match slot {
                0 => cx.symbol(&part, "Shop"),
                _ => {
                    let a0 = rt::get::split_index(&part);
                    Floor(g, cx, part, a0)
                }
            })?;
            childless &= !parts.divided();
        } else {
            cx.symbol(&shape, "Plain")?;
            childless = false;
        }
        if childless {
            cx.leaf(&shape, "Facade")?;
        }
        cx.leave()
    }

    fn Floor<S: rt::Sink + ?Sized>(
        _g: &Values,
        cx: &mut rt::Cx<'_, S, Call>,
        mut shape: rt::ShapeRef<'_>,
        _p0: f64,
    ) -> rt::Flow {
        cx.enter(2)?;
        let base = *shape.scope();
        if rt::branch(&mut shape, 30.0, 0.0) {
            cx.symbol(&shape, "Wall")?;
            return cx.leave();
        }
        'push: {
            let mut shape = rt::push(&mut shape);
            rt::op::translate(
                &mut cx.env,
                &mut shape,
                rt::Length::Absolute(0.0),
                rt::Length::Absolute(0.0),
                rt::Length::Absolute(-0.1),
            );
            cx.symbol(&shape, "Glass")?;
            if false {
                break 'push;
            }
        }
        rt::op::size(
            &mut cx.env,
            &mut shape,
            rt::Length::Relative(1.0),
            rt::Length::Relative(0.5),
            rt::Length::Relative(1.0),
        );
        rt::op::center(&mut cx.env, &mut shape, &base, rt::op::CenterAxes::Y);
        cx.leave()
    }

    fn S<S_: rt::Sink + ?Sized>(
        g: &Values,
        cx: &mut rt::Cx<'_, S_, Call>,
        mut shape: rt::ShapeRef<'_>,
        p0: f64,
    ) -> rt::Flow {
        cx.enter(3)?;
        if p0 == 0.0 {
            cx.symbol(&shape, "Cube")?;
            return cx.leave();
        }
        let mut sizes = [rt::Size::floating(1.0), rt::Size::floating(1.0), rt::Size::floating(1.0)];
        let pattern = const { &[rt::Item::Slot, rt::Item::Slot, rt::Item::Slot] };
        let parts = rt::divide(&mut cx.env, &mut shape, rt::Axis::Y, rt::Adjust::Adjust, pattern, &mut sizes)?;
        parts.each(|slot, part| match slot {
            1 => rt::Flow::Continue(()),
            _ => {
                let a0 = p0 - 1.0;
                if cx.descend(1, 8) {
                    S(g, cx, part, a0)?;
                    cx.ascend(1, 8);
                    rt::Flow::Continue(())
                } else {
                    cx.defer(&part, 1, Call::S(a0))
                }
            }
        })?;
        if !parts.divided() {
            cx.leaf(&shape, "S")?;
        }
        cx.leave()
    }

    impl rt::Rules for Hand {
        type Values = Values;
        type Call = Call;
        const NAMES: &'static [&'static str] = &["Lot", "Facade", "Floor", "S", "Lot/1"];
        const STARTS: &'static [&'static str] = &["Lot", "Facade"];
        const START_RULES: &'static [u32] = &[0, 1];

        fn check(&self) -> Result<(), rt::Error> {
            rt::Range { min: 3.0, max: 60.0, step: 0.0, restricted: true }.check("height", self.height)
        }

        fn values(&self, _env: &mut rt::Env, shape: &rt::Shape) -> Values {
            let mut g = Values::default();
            g.height = self.height;
            g.bays = match self.bays {
                Some(value) => value,
                None => {
                    let mut shape = rt::global(shape, 1);
                    let _ = &mut shape;
                    g.height / 6.0
                }
            };
            g.floor_h = 3.0;
            let _ = g.bays;
            g
        }

        fn start<S_: rt::Sink + ?Sized>(
            g: &Values,
            cx: &mut rt::Cx<'_, S_, Call>,
            rule: u32,
            shape: rt::ShapeRef<'_>,
        ) -> rt::Flow {
            match rule {
                0 => Lot(g, cx, shape),
                _ => Facade(g, cx, shape),
            }
        }

        fn resume<S_: rt::Sink + ?Sized>(
            g: &Values,
            cx: &mut rt::Cx<'_, S_, Call>,
            shape: rt::ShapeRef<'_>,
            call: Call,
        ) -> rt::Flow {
            match call {
                Call::S(a0) => S(g, cx, shape, a0),
            }
        }
    }

    impl rt::Grammar for Hand {
        fn name(&self) -> &'static str {
            "Hand"
        }
        fn attributes(&self) -> &'static [rt::Attribute] {
            &[
                rt::Attribute {
                    name: "height",
                    default: rt::Default::Float(Some(24.0)),
                    range: Some(rt::Range { min: 3.0, max: 60.0, step: 0.0, restricted: true }),
                    group: &[],
                    about: "",
                    order: None,
                    hidden: false,
                },
                rt::Attribute {
                    name: "bays",
                    default: rt::Default::Float(None),
                    range: None,
                    group: &[],
                    about: "",
                    order: None,
                    hidden: false,
                },
            ]
        }
        fn start_rules(&self) -> &'static [&'static str] {
            <Self as rt::Rules>::STARTS
        }
        fn derive(
            &self,
            shape: &rt::Shape,
            settings: &rt::Settings,
            sink: &mut dyn rt::Sink,
        ) -> Result<rt::Report, rt::Error> {
            rt::run(self, shape, settings, sink)
        }
    }

    impl Hand {
        pub fn generate(&self, shape: &rt::Shape) -> Result<rt::Model, rt::Error> {
            rt::generate(self, shape, &rt::Settings::default())
        }
    }
};

#[test]
fn a_tall_lot_has_shops_floors_and_a_roof() {
    let model = Hand::default().generate(&rt::Shape::rectangle(20.0, 12.0)).unwrap();
    let count = |name: &str| model.leaves().filter(|leaf| leaf.rule() == name).count();
    assert_eq!(count("Shop"), 4);
    assert_eq!(count("Roof"), 1);
    // (24 - 4) / 3 → 7 floors a side, each a wall or a pane of glass.
    assert_eq!(count("Wall") + count("Glass"), 28);
    assert!(0 < count("Wall") && 0 < count("Glass"));
}

#[test]
fn the_same_seed_gives_the_same_model_and_another_one_does_not() {
    let leaves = |seed| {
        let model = Hand::default().generate(&rt::Shape::rectangle(20.0, 12.0).seed(seed)).unwrap();
        model.leaves().map(|leaf| leaf.rule().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(leaves(1), leaves(1));
    assert_ne!(leaves(1), leaves(2));
}

#[test]
fn a_restricted_range_is_checked() {
    let hand = Hand { height: 100.0, ..Hand::default() };
    let error = hand.generate(&rt::Shape::rectangle(20.0, 12.0)).unwrap_err();
    assert_eq!(error.to_string(), "attribute `height`: 100 is outside of 3 to 60");
}
