//! Text: searching, cutting, lists in text.

use crate::each_is;

#[test]
fn substring_and_find() {
    each_is! { "const digits = \"0123456789\"  const words = \"CE_Zero CE_One CE_Two\""
        "substring(digits,0,5)" => "\"01234\"",
        "substring(digits,2,5)" => "\"234\"",
        "substring(digits,-20,5)" => "\"01234\"",
        "substring(digits,0,20)" => "\"0123456789\"",
        "substring(digits,5,0)" => "\"\"",
        "substring(digits,one,one)" => "\"\"",
        "substring(\"zäöü\",1,3)" => "\"äö\"",
        "find(words,\"CE\",0)" => "0",
        "find(words,\"CE\",1)" => "8",
        "find(words,\"asdf\",1)" => "-1",
        "find(words,\"CE\",3)" => "-1",
        "find(words,\"CE\",-one)" => "-1",
        "count(words,\"CE\")" => "3",
        "len(words)" => "21",
        "len(\"größe\")" => "5",
    }
}

#[test]
fn matches_do_not_overlap() {
    each_is! { ""
        "find(\"ababa\",\"aba\",0)" => "0",
        "find(\"ababa\",\"aba\",1)" => "-1",
        "find(\"abaaba\",\"aba\",1)" => "3",
        "count(\"ababa\",\"aba\")" => "1",
    }
}

#[test]
fn text_is_split_at_a_delimiter_or_a_pattern() {
    each_is! { ""
        r#"splitString("a.b.c",".")"# => r#"["a","b","c"]"#,
        r#"splitString(".b.",".")"# => r#"["","b",""]"#,
        r#"splitString("a.b\nc.d","\n")"# => r#"["a.b","c.d"]"#,
        r#"splitString("a\\b\\c","\\")"# => r#"["a","b","c"]"#,
        r#"splitString("abc","")"# => r#"["","a","b","c",""]"#,
        r#"splitString("a;b;c","$;")"# => r#"["a","b","c"]"#,
        r#"splitString("a.b.c","$\\.")"# => r#"["a","b","c"]"#,
        r#"splitString("a\t\tb\tc","$\t+")"# => r#"["a","b","c"]"#,
        r#"splitString("a b  c","$\\s+")"# => r#"["a","b","c"]"#,
        r#"splitString("a$b$c","$\\$")"# => r#"["a","b","c"]"#,
        r#"splitString("abc","$\\B")"# => r#"["a","b","c"]"#,
        r#"splitString("","x")"# => r#"[""]"#,
        r#"splitString("a;b|c","$;|\\|")[zero:2]"# => r#"["a","b","c"]"#,
    }
}

#[test]
fn parts_by_what_stands_around_them() {
    each_is! { "const name = \"myTexture.has.prefix.jpg\"  const slogan = \"rule your city with cityengine\""
        r#"getPrefix(name,".")"# => r#""myTexture""#,
        r#"getSuffix(slogan,"city")"# => r#""engine""#,
        r#"getRange(slogan,"y","city")"# => r#""our city with ""#,
        r#"getRange("CityEngine","CityEn","tyEngine")"# => r#""""#,
        r#"fileExtension("a/b.c.jpg")"# => r#""jpg""#,
        r#"fileBasename("a/b.c.jpg")"# => r#""b.c""#,
    }
}

#[test]
fn lists_in_text() {
    each_is! { "const list = \"rule;your;city;\""
        r#"listIndex(list,"*y")"# => "2",
        r#"listIndex(list,"*y*")"# => "1",
        r#"listIndex(list,"none")"# => "-1",
        r#"listCount(list,"*y*")"# => "2",
        r#"listAdd("rule;your;","city")"# => r#""rule;your;city;""#,
        r#"listClean(";;a;;b")"# => r#""a;b;""#,
        r#"listSize(list)"# => "3",
        r#"listItem(list,one)"# => r#""your""#,
        r#"listItem(list,3)"# => r#""""#,
        r#"listRange(list,1,3)"# => r#""your;city;""#,
        r#"listFirst(list) + listLast(list)"# => r#""rulecity""#,
        r#"listRemove("a;b;a;","a")"# => r#""b;a;""#,
        r#"listRemoveAll("a;b;a;","a")"# => r#""b;""#,
        r#"listRetainAll("a;b;a;","a")"# => r#""a;a;""#,
        r#"listTerminate("a;b")"# => r#""a;b;""#,
    }
}
