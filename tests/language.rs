//! The language beyond splits and comps: imports, styles, arrays, locals, overloads.
use cga::{Model, Shape, cga};

fn sum(model: &Model, key: &str) -> Option<f64> {
    model.reported(key).map(|it| it.summary().sum)
}

#[test]
fn fact_74() {
    cga! { grammar A = r#"import imp : "tests/rules/import/height.cga" attr height = 20  Lot --> imp.Lot"#; }
    cga! { grammar B = r#"import imp : "tests/rules/import/height.cga" (height) attr height = 20  Lot --> imp.Lot"#; }
    cga! { grammar C = r#"import imp : "tests/rules/import/height.cga" () attr height = 20  Lot --> imp.start"#; }
    cga! { grammar D = r##"import imp : "tests/rules/import/height.cga" (height = 20, Roof --> color("#ff0000") Top.)  Lot --> imp(height=30).Lot"##; }
    cga! { grammar E = r#"import imp : "tests/rules/import/height.cga"  Lot --> set(imp.height, 20) imp( ).Lot imp.Tall(5)  imp.Missing --> report("missing", 1)"#; }
    let shape = Shape::rectangle(2.0, 2.0);
    assert_eq!(sum(&A::default().generate(&shape).unwrap(), "height"), Some(20.0));
    assert_eq!(sum(&B::default().generate(&shape).unwrap(), "height"), Some(10.0));
    assert_eq!(sum(&C::default().generate(&shape).unwrap(), "height"), Some(10.0));
    let d = D::default().generate(&shape).unwrap();
    assert_eq!((sum(&d, "height"), sum(&d, "double")), (Some(30.0), Some(60.0)));
    assert_eq!(d.leaves().map(|leaf| leaf.rule()).collect::<Vec<_>>(), ["Top"]);
    let e = E::default().generate(&shape).unwrap();
    assert_eq!((sum(&e, "height"), sum(&e, "missing"), sum(&e, "tall")), (Some(10.0), Some(1.0), Some(5.0)));
    let a = A { height: 7.0, ..A::default() };
    assert_eq!(sum(&a.generate(&shape).unwrap(), "double"), Some(14.0));
    let a = A { imp_height: Some(3.0), ..A::default() };
    assert_eq!(sum(&a.generate(&shape).unwrap(), "double"), Some(6.0));
}

#[test]
fn styles() {
    cga! { grammar S = r##"
        attr h = 1
        attr kind = "a"
        k2 = kind + "!"
        Lot --> report("h", h) print(k2) Next
        Next --> X.
        style Big
        attr h = 5
        Next --> Y.
        style Bigger extends Big
        attr kind = "c"
    "##; }
    let shape = Shape::rectangle(2.0, 2.0);
    for (start, h, leaf, printed) in [
        ("Lot", 1.0, "X", "a!"),
        ("Default$Lot", 1.0, "X", "a!"),
        ("Big$Lot", 5.0, "Y", "a!"),
        ("Bigger$Lot", 5.0, "Y", "c!"),
    ] {
        let model = S::default().generate_from(start, &shape).unwrap();
        assert_eq!(sum(&model, "h"), Some(h), "{start}");
        assert_eq!(model.leaves().next().unwrap().rule(), leaf);
        assert_eq!(model.prints().iter().map(|it| it.to_string()).collect::<Vec<_>>(), [printed]);
    }
}

#[test]
fn arrays() {
    cga! { grammar S = r##"
        attr a = [1, 2, 3]
        attr names = ["x"; "y"]
        fib(n) = case n < 2 : [0, 1] else : fib(n, [0, 1])
        fib(n, list) = case size(list) >= n : list else : fib(n, [list, list[size(list)-1] + list[size(list)-2]])
        total(list) with ( s := sum(list)  t := s * 2 ) = s + t
        pick(x) = x + "!"
        big(a) with ( keep := scope.sx ) = keep
        Lot --> print("x = " + str(a)) print(fib(10)) print(total(a)) print(a[a .> 1]) print([1:0.5:3]) print(names)
                print([8;-5;0] .% 3) print([1,2]==[1;2]) print(pick(str(3))) print(3 > 2 && !false) set(a, [0, a]) print(a) Next(2, "q")
        Next(n, t) with ( m := n * 10 ) --> print(m) print(t) [ t(m,0,0) split(x) { ~1 : s(m, '1, '1) print(m) X. } ]
        Next(n) --> print(n)
    "##; }
    let shape = Shape::rectangle(2.0, 2.0);
    let model = S { a: [0.0, 1.0, 2.0].into(), ..S::default() }.generate(&shape).unwrap();
    let lines: Vec<String> = model.prints().iter().map(|line| line.to_string()).collect();
    assert_eq!(
        lines,
        [
            "x = (3)[0,1,2]",
            "(10)[0,1,1,2,3,5,8,13,21,34]",
            "9",
            "(1)[2]",
            "(5)[1,1.5,2,2.5,3]",
            "(2x1)\n   x\n   y",
            "(3x1)\n    2\n   -2\n    0",
            "false",
            "3!",
            "true",
            "(4)[0,0,1,2]",
            "20",
            "q",
            "20"
        ]
    );
    assert_eq!(model.faults(), []);
}
