//! Arrays: making them, taking from them, setting in them, functions over them.

#[cfg(not(feature = "compiled"))]
use cga::Grammar as _;
use cga::{Error, LimitKind, cga};

use crate::{each_is, lines, lot, model, rules};

#[test]
fn arrays_are_printed_with_their_size() {
    cga! {
        grammar Printing = r#"
            attr a = [1, 2, 3]
            attr b = [true; false]
            wide = [1, 20; 300, -4]
            Lot --> print("x = " + str(a)) print(b) print([false, false, true]) print(wide) print(floatArray) print(["", "a b"]) X.
        "#;
    }
    let rules = Printing { a: [0.0, 1.0, 2.0].into(), ..Printing::default() };
    assert_eq!(
        lines(&model(&rules)),
        [
            "x = (3)[0,1,2]",
            "(2x1)\n    true\n   false",
            "(3)[false,false,true]",
            "(2x2)\n     1   20\n   300   -4",
            "(0)[]",
            "(2)[,a b]",
        ]
    );
}

#[test]
fn ranges() {
    each_is! { ""
        "[2:4]" => "[2,3,4]",
        "[0.5:3]" => "[0.5,1.5,2.5]",
        "[4:2]" => "[]",
        "[1:0.5:3]" => "[1,1.5,2,2.5,3]",
        "[4:-1:2]" => "[4,3,2]",
        "[1:-0.5:2]" => "[]",
        "[1:-0.5:1]" => "[1]",
        "[1:0:1]" => "[]",
        "[one:one + 1:one * 6]" => "[1,3,5]",
        "[zero:-one:-2.5]" => "[0,-1,-2]",
        "[one:zero:one]" => "[]",
        "size([0:0.1:1])" => "11",
        // The steps are multiplied, not added up.
        "[0:0.15:0.5][3] == 3*0.15" => "true",
        "[0:0.15:0.5][3] == 0.45" => "false",
    }
}

#[test]
fn arrays_are_put_together_from_elements_and_arrays() {
    each_is! { r#"const inner = ["B", "C"]  const low = [-1; -2]  const wide = [0:2; 3, 3, 3]"#
        r#"["A", inner, "D"]"# => r#"["A","B","C","D"]"#,
        "low" => "[-1;-2]",
        "wide" => "[0,1,2;3,3,3]",
        "[low, wide; wide, low]" => "[-1,0,1,2;-2,3,3,3;0,1,2,-1;3,3,3,-2]",
        "[[[one]]]" => "[1]",
        "[one == 1, zero == 1; false, true]" => "[true,false;false,true]",
        "[floatArray, one]" => "[1]",
        "[one, floatArray()]" => "[1]",
        "size([1,2;3,4]) + 10*nRows([1;2;3]) + 100*nColumns([1,2])" => "234",
    }
}

#[test]
fn elements() {
    each_is! { "const a = [1,2,3,4]  const m = [1,2,3;4,5,6;7,8,9]  const t = [\"x\"]  const b = [true]"
        "a[0]" => "1",
        "a[3]" => "4",
        "a[-1]" => "0",
        "a[4]" => "0",
        "t[1]" => "\"\"",
        "b[one]" => "false",
        "m[1,1]" => "5",
        "m[1,3]" => "0",
        "m[-1,0]" => "0",
        "m[3]" => "4",
        "m[one, one + 1]" => "6",
        "a[[0,2]]" => "[1,3]",
        "a[[1,1]]" => "[2,2]",
        "a[[false,false,true,true,true]]" => "[3,4,0]",
        "a[3:-1:1]" => "[4,3,2]",
        "a[[0,1;2,3]]" => "[1,2;3,4]",
        "a[a .> 2]" => "[3,4]",
        "a[a .> 1 .&& a .< 4]" => "[2,3]",
        "m[1,[0,2]]" => "[4,6]",
        "m[[0,0,1],2]" => "[3;3;6]",
        "m[0:2,[0,2]]" => "[1,3;4,6;7,9]",
        "m[[false,true,true],0]" => "[4;7]",
        "m[[2,3],-1:1]" => "[0,7,8;0,0,0]",
        "m[0:size(m)-1]" => "[1,2,3,4,5,6,7,8,9]",
        "m[[0;3;6]]" => "[1;4;7]",
        "m[0,[0,1;2,3]]" => "[1,2,3,0]",
        "a[[true,false;true,false]]" => "[1,3]",
        "floatArray[1:3]" => "[0,0,0]",
        "floatArray[1:2,1:3] .+ 1" => "[1,1,1;1,1,1]",
        r#"["-","n","e","w"][[1,0,0;0,2,0;0,0,3]]"# => r#"["n","-","-";"-","e","-";"-","-","w"]"#,
    }
}

#[test]
fn what_is_no_number_counts_as_0_and_leaves_a_fault() {
    rules! {
        grammar Odd = "const a = [4,5]  nan = (scope.sx - 2) / 0
            Lot --> print(a[nan]) print(a[nan + 1/0]) print([1:nan:3]) print(setElems(a, nan, 1)) print(a[[1, nan]]) X.";
    }
    let model = Odd::default().generate(&lot()).expect("faults end no run");
    assert_eq!(lines(&model), ["4", "4", "(0)[]", "(2)[1,5]", "(2)[5,0]"]);
    assert_eq!(model.faults().len(), 4, "{:?}", model.faults());
}

#[test]
fn arrays_are_compared_row_by_row() {
    each_is! { ""
        "[1,2] == [1,2]" => "true",
        "[1,2] == [1;2]" => "false",
        "[1,2] != [1;2]" => "true",
        "[true,false] == [true,true]" => "false",
        "[true,true] != [true,true]" => "false",
        r#"["a","b"] != ["a";"b"]"# => "true",
        "[1,2] < [1,3]" => "true",
        r#"["a";"b"] <= ["a"]"# => "false",
        r#"["a";"b"] > ["a"]"# => "true",
        r#"["a";"b"] >= ["a";"b"]"# => "true",
        "[1,2,3] >= [1,2]" => "true",
        "[1,2,3] < [1,2]" => "false",
        // An element decides before the size does, and columns before rows.
        "[1,9;1,1] < [2]" => "true",
        "[1;2;3] < [1,0]" => "true",
        "floatArray < [one]" => "true",
        "floatArray == floatArray" => "true",
    }
}

#[test]
fn elements_are_set_in_a_copy() {
    each_is! { "const z = [0,0,0,0,0,0]  const m = [0,0,0;0,0,0;0,0,0]  const s = [1:7]"
        "setElems(z,2,1)" => "[0,0,1,0,0,0]",
        "z" => "[0,0,0,0,0,0]",
        "setElems(z,[1:4],1)" => "[0,1,1,1,1,0]",
        "setElems(z,[1,3,5],[1:3])" => "[0,1,0,2,0,3]",
        "setElems(z,[5,1,3],[1:3])" => "[0,2,0,3,0,1]",
        "setElems(z,[1,1,1],[1:3])" => "[0,3,0,0,0,0]",
        "setElems(m,1,1,5)" => "[0,0,0;0,5,0;0,0,0]",
        "setElems(m,[0,2],[0:2],1)" => "[1,1,1;0,0,0;1,1,1]",
        "setElems(m,[1,2],[0,2],[1,2;3,4])" => "[0,0,0;1,0,2;3,0,4]",
        "setElems(m,[2,1],[2,0],[1,2;3,4])" => "[0,0,0;4,0,3;2,0,1]",
        "setElems(m,[1,1],[0,2],[1,2;3,4])" => "[0,0,0;3,0,4;0,0,0]",
        "setElems(s,s .> 4,4)" => "[1,2,3,4,4,4,4]",
        "setElems(s,s .> 4,[3,2,1])" => "[1,2,3,4,3,2,1]",
        "setElems([1,1],3,5)" => "[1,1,0,5]",
        "setElems([1,1],2,2,5)" => "[1,1,0;0,0,0;0,0,5]",
        "setElems([1,1],-1,5)" => "[1,1]",
        "setElems(floatArray[1:3,1:3],[0:4:8],1)" => "[1,0,0;0,1,0;0,0,1]",
        "setElems(floatArray[1:3,1:2],[0:5],[1,2,3;4,5,6])" => "[1,2;3,4;5,6]",
        r#"setElems(["a"],2,"c")"# => r#"["a","","c"]"#,
        "setElems([true],[zero, 2],false)" => "[false,false,false]",
    }
}

#[test]
fn indices_in_sorted_order() {
    each_is! { "const rows = [4,0,1;2,1,9;1,3,0;2,1,0]
        by(a, column) = byAll(a, [column])
        byAll(a, columns) = a[sortRowIndices(a[0:nRows(a)-1,columns]),0:nColumns(a)-1]
        up(a) = a[sortIndices(a .+ 0)]  words(a) = a[sortIndices(a .+ \"\")]  turned(a) = a[size(a)-1:-1:0]"
        r#"sortIndices(["c","b","d","a"])"# => "[3,1,0,2]",
        "sortIndices([2,1,3,3,1])" => "[1,4,0,2,3]",
        r#"sortIndices(["e","c","d";"b","a","c";"d","a","d"])"# => "[1,2,0;4,3,5;7,6,8]",
        "sortRowIndices(rows)" => "[2,3,1,0]",
        "by(rows, 1)" => "[4,0,1;2,1,9;2,1,0;1,3,0]",
        "byAll(rows, [1,0,2])" => "[4,0,1;2,1,0;2,1,9;1,3,0]",
        r#"words(["a","c","b"])"# => r#"["a","b","c"]"#,
        "turned(up([1,4,-1,9]))" => "[9,4,1,-1]",
        "sortIndices(floatArray)" => "[]",
    }
}

#[test]
fn sums() {
    each_is! { "sums(a) = case size(a) < 2 : a else : sums(a, floatArray, 0)
        sums(a, so_far, i) = case i == size(a) : so_far else : sums(a, [so_far, sum(a[0:i])], i + 1)"
        "sum([1,2,3])" => "6",
        "sum([one,2;3,4])" => "10",
        "sum([true,false,true])" => "2",
        r#"sum(["a","b","c"])"# => "\"abc\"",
        "sum(floatArray)" => "0",
        "sum(stringArray)" => "\"\"",
        "sums([1:5])" => "[1,3,6,10,15]",
        r#"transpose(["a","b";"c","d";"e","f"])"# => r#"["a","c","e";"b","d","f"]"#,
        "[transpose([1,1,1]), transpose([2,2,2])]" => "[1,2;1,2;1,2]",
        "transpose([1,1,1;2,2,2])[0:5]" => "[1,2,1,2,1,2]",
        "findFirst([1,2,3,4],2,0)" => "1",
        "findFirst([1,2,3;4,5,6],4,0)" => "3",
        "findFirst([6,8.1,6,8.1],8,0.5)" => "1",
        "findFirst([1],2,0)" => "-1",
        r#"findFirst(["a","b"],"b")"# => "1",
    }
}

#[test]
fn functions_that_call_themselves_work_on_arrays() {
    each_is! { "fib(n) = fib(n, [0, 1])
        fib(n, list) = case size(list) >= n : list[0:n-1] else : fib(n, [list, list[size(list)-1] + list[size(list)-2]])
        primes(max) = primes([2:max], 0)
        primes(left, i) = case i == size(left) : left
            else : primes(left[(left .% left[i]) .!= 0 .|| left .== left[i]], i + 1)
        largest(a) = largest(a, 0, 0)
        largest(a, i, best) = case i == size(a) : best
            else : case a[i] > a[best] : largest(a, i + 1, i) else : largest(a, i + 1, best)"
        "fib(10)" => "[0,1,1,2,3,5,8,13,21,34]",
        "primes(20)" => "[2,3,5,7,11,13,17,19]",
        "largest([3,one,7,7,2])" => "2",
    }
}

#[test]
fn an_array_that_grows_for_ever_ends_the_run() {
    rules! { grammar Growing = "twice(a, n) = case n == 0 : a else : twice([a, a], n - 1)  Lot --> print(size(twice([1, 2], 100)))"; }
    match Growing::default().generate(&lot()) {
        Err(Error::Limit { what: LimitKind::Array, .. }) => {}
        other => panic!("{other:?}"),
    }
    rules! { grammar Range = "Lot --> print(size([0:1e-300:1])) X."; }
    match Range::default().generate(&lot()) {
        Err(Error::Limit { what: LimitKind::Array, .. }) => {}
        other => panic!("{other:?}"),
    }
}
