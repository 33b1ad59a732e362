//! Findings as JSON. A library for JSON would be a tenth of the module.

use std::fmt::Write;

use crate::finding::Finding;

/// The findings as a JSON list.
pub fn json(findings: &[Finding]) -> String {
    let mut out = String::from("[");
    for (at, finding) in findings.iter().enumerate() {
        if at != 0 {
            out.push(',');
        }
        let Finding { is_error, code, message, place, line, column, notes, help } = finding;
        let level = if *is_error { "error" } else { "warning" };
        // Writing to a `String` cannot fail.
        let _ =
            write!(out, "{{\"level\":\"{level}\",\"code\":\"{code}\",\"start\":{},\"end\":{}", place.start, place.end);
        let _ = write!(out, ",\"line\":{line},\"column\":{column},\"message\":");
        quote(&mut out, message);
        out.push_str(",\"notes\":");
        list(&mut out, notes);
        out.push_str(",\"help\":");
        list(&mut out, help);
        out.push('}');
    }
    out.push(']');
    out
}

fn list(out: &mut String, texts: &[String]) {
    out.push('[');
    for (at, text) in texts.iter().enumerate() {
        if at != 0 {
            out.push(',');
        }
        quote(out, text);
    }
    out.push(']');
}

fn quote(out: &mut String, text: &str) {
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            c if c < ' ' => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
}

#[cfg(test)]
mod tests {
    use super::json;
    use crate::finding::Finding;

    #[test]
    fn texts_are_quoted() {
        let finding = Finding {
            is_error: true,
            code: "x",
            message: "a \"b\" \\ \n\t\u{1}🏠".into(),
            place: 1..2,
            line: 3,
            column: 4,
            notes: vec!["n".into(), "m".into()],
            help: Vec::new(),
        };
        let one = r#"{"level":"error","code":"x","start":1,"end":2,"line":3,"column":4,"message":"a \"b\" \\ \n\u0009\u0001🏠","notes":["n","m"],"help":[]}"#;
        assert_eq!(json(&[finding.clone(), finding]), format!("[{one},{one}]"));
        assert_eq!(json(&[]), "[]");
    }
}
