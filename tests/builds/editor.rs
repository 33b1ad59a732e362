//! rust-analyzer inside the macro: completion, hover, definition, references, rename, errors while typing, and
//! semantic tokens of a large grammar. Runs where it is installed (`rustup component add rust-analyzer rust-src`). `docs/editor.md` tells users the
//! same.

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use super::package::{Package, target};

const RULES: &str = r##"cga::cga! {
    /// A tower.
    pub grammar Tower;
    /// Up to the roof.
    @Range(min = 3, max = 60)
    attr height = 24
    const floor = 12 / 4
    half(n) = n / 2

    @StartRule
    Lot --> extrude(height) comp(f) { side : Facade(height) | top : Roof }
    /// One wall.
    Facade(width) --> split(y) { ~floor : Tile(width, half(height)) | 1 : Roof }
    Tile(w, h) --> case w > h && scope.sx > 2 : Roof else : split(x) { w : Glass. | ~1 : NIL }
    Roof --> color("#ff0000") [ Leaf. ] Leaf.
}

/// Uses it.
pub fn tower() -> Tower {
    Tower { height: 3.0, ..Tower::default() }
}
"##;

/// A name, which of its occurrences is asked about, where all of them are, and what is said about it. Occurrences count from
/// 0, in the text above; the first one is where it is declared, unless another is named.
struct Case {
    name: &'static str,
    ask: usize,
    declared: usize,
    all: &'static [usize],
    said: &'static [&'static str],
}

const CASES: &[Case] = &[
    Case { name: "height", ask: 0, declared: 0, all: &[0, 1, 2, 3, 4], said: &["height: f64"] },
    Case { name: "height", ask: 2, declared: 0, all: &[0, 1, 2, 3, 4], said: &["height"] },
    Case { name: "height", ask: 4, declared: 0, all: &[0, 1, 2, 3, 4], said: &["height"] },
    Case { name: "floor", ask: 1, declared: 0, all: &[0, 1], said: &["const floor: f64"] },
    Case { name: "half", ask: 1, declared: 0, all: &[0, 1], said: &["fn half(n: f64) -> f64", "half(n) = n / 2"] },
    Case { name: "Facade", ask: 0, declared: 1, all: &[0, 1], said: &["fn Facade(width: f64)\\n", "One wall."] },
    Case { name: "Roof", ask: 1, declared: 3, all: &[0, 1, 2, 3], said: &["fn Roof()\\n"] },
    Case { name: "Leaf", ask: 1, declared: 0, all: &[0, 1], said: &["A leaf."] },
    Case { name: "width", ask: 1, declared: 0, all: &[0, 1], said: &["width: f64"] },
    Case { name: "Tower", ask: 1, declared: 0, all: &[0, 1, 2, 3], said: &["A tower"] },
];

/// Words of the language with a part of their documentation, and values that are known without errors alone.
const WORDS: &[(&str, &str)] = &[
    ("extrude", "Raises each face by a distance"),
    ("comp", "comp(component: word"),
    ("side", "Selects components that face neither"),
    ("sx", "The size of the scope"),
    ("Range", "Limits the values of a number"),
    ("NIL", "Removes the shape"),
    ("height", "default 24, range 3 to 60.\\n\\nUp to the roof."),
    ("floor", "floor: f64 = 3.0"),
];

/// A change of the text, where `|` is the cursor; names that are offered there, and a name that is not.
const COMPLETIONS: &[(&str, &str, &[&str], &str)] = &[
    ("extrude(height)", "ext|(height)", &["extrude", "comp", "Roof", "Facade"], "sin"),
    ("top : Roof", "top : Ro|", &["Roof", "roofHip", "NIL"], "front"),
    ("Roof --> color", "Roof --> | color", &["Roof", "texture"], "String"),
    ("{ side :", "{ | side :", &["front", "side", "all"], "extrude"),
    ("side :", "si| :", &["side"], "sin"),
    ("~floor", "~fl|", &["floor", "half", "height", "rand"], "extrude"),
    ("Tile(width,", "Tile(wi|,", &["width", "height", "scope"], "w"),
    ("scope.sx", "scope.|", &["sx", "tx"], "height"),
    ("split(y)", "split(|)", &["x", "y", "z", "u"], "height"),
    ("@StartRule", "@St|", &["StartRule", "Range"], "Roof"),
    // Rules that cannot be read yet.
    ("color(\"#ff0000\")", "comp(f) { | }", &["front", "top"], "extrude"),
    ("color(\"#ff0000\")", "split(x) { ~1 : Ti| }", &["Tile", "t"], "x"),
    ("Tile(w, h) --> case w >", "Tile(w, h) --> case * 5 5 | >", &["w", "h", "height"], "width"),
    ("Lot --> extrude", "Lot --> : 5 = fa| extrude", &["Facade", "Lot"], "sin"),
];

#[test]
fn an_editor_finds_names_inside_the_macro() {
    let found = Command::new("rust-analyzer").arg("--version").output();
    if !found.is_ok_and(|output| output.status.success()) {
        println!("left out: rust-analyzer is not installed");
        return;
    }
    let package = Package::new("editor", "cga", "");
    package.write("src/lib.rs", RULES);
    let mut editor = Editor::new(&package.folder);
    for case in CASES {
        editor.check(RULES, case);
    }
    for (word, said) in WORDS {
        let hover = editor.hover(RULES, word, 0);
        assert!(hover.contains(said), "{word}: {hover}");
    }
    for (from, to, offered, other) in COMPLETIONS {
        let text = RULES.replacen(from, to, 1);
        let cursor = text.find(to).expect("the text has it") + to.find('|').expect("a cursor");
        let names = editor.complete(&format!("{}{}", &text[..cursor], &text[cursor + 1..]), cursor);
        let has = |name: &str| names.iter().any(|own| own.trim_end_matches("(…)").trim_end_matches("()") == name);
        assert!(offered.iter().all(|name| has(name)) && !has(other), "{to}: {names:?}");
    }
    // An error far from them.
    let wrong = RULES.replace("Glass.", "Glas");
    editor.change(&wrong);
    for case in CASES {
        editor.check(&wrong, case);
    }
    let errors = editor.errors("Glas");
    assert_eq!(starts(&errors), [place(&wrong, "Glas", 0)], "{errors}");
    editor.check_large_grammar();
}

/// Where an occurrence of a word begins.
fn place(text: &str, word: &str, number: usize) -> Value {
    position(text, text.match_indices(word).nth(number).expect("the text has it").0)
}

fn position(text: &str, at: usize) -> Value {
    let line = text[..at].matches('\n').count();
    json!({ "line": line, "character": at - text[..at].rfind('\n').map_or(0, |end| end + 1) })
}

/// The time after which rust-analyzer is ended.
const LONGEST: Duration = Duration::from_secs(300);

/// rust-analyzer, spoken to over its protocol.
struct Editor {
    process: Arc<Mutex<Child>>,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    file: String,
    asked: u64,
    version: u64,
    /// The errors that it shows.
    shown: Value,
}

impl Editor {
    fn new(package: &Path) -> Self {
        let mut process = Command::new("rust-analyzer")
            .current_dir(package)
            .env("CARGO_NET_OFFLINE", "true")
            .env("CARGO_TARGET_DIR", target())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("rust-analyzer");
        let input = process.stdin.take().expect("it is piped");
        let output = BufReader::new(process.stdout.take().expect("it is piped"));
        let root = format!("file://{}", package.display());
        let process = Arc::new(Mutex::new(process));
        let watched = Arc::downgrade(&process);
        // It must not wait for an answer for ever.
        thread::spawn(move || {
            thread::sleep(LONGEST);
            if let Some(process) = watched.upgrade() {
                process.lock().expect("a process").kill().expect("it runs");
            }
        });
        let mut editor = Editor {
            process,
            input,
            output,
            file: format!("{root}/src/lib.rs"),
            asked: 0,
            version: 1,
            shown: Value::Null,
        };
        let hover = json!({ "contentFormat": ["plaintext"] });
        editor.ask(
            "initialize",
            json!({
                "processId": null,
                "rootUri": root,
                "capabilities": {
                    "experimental": { "serverStatusNotification": true },
                    "textDocument": { "hover": hover },
                },
                "initializationOptions": { "checkOnSave": false },
            }),
        );
        editor.tell("initialized", json!({}));
        let document = json!({ "uri": editor.file, "languageId": "rust", "version": 1, "text": RULES });
        editor.tell("textDocument/didOpen", json!({ "textDocument": document }));
        // It has read the package, and built the macro.
        while editor.hear()["params"]["quiescent"] != true {}
        editor
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{body}", body.len()).expect("it listens");
        self.input.flush().expect("it listens");
    }

    fn tell(&mut self, what: &str, params: Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": what, "params": params }));
    }

    /// The next message; what it asks is answered with nothing.
    fn hear(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert!(0 < self.output.read_line(&mut line).expect("it speaks"), "it has ended");
            match line.trim().strip_prefix("Content-Length: ") {
                Some(number) => length = number.parse().expect("a number"),
                None if line.trim().is_empty() => break,
                None => {}
            }
        }
        let mut body = vec![0; length];
        self.output.read_exact(&mut body).expect("it speaks");
        let message: Value = serde_json::from_slice(&body).expect("JSON");
        if message.get("method").is_some() && message.get("id").is_some() {
            let id = message["id"].clone();
            self.send(&json!({ "jsonrpc": "2.0", "id": id, "result": null }));
        }
        if message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == self.file {
            self.shown = message["params"]["diagnostics"].clone();
        }
        message
    }

    fn ask(&mut self, what: &str, params: Value) -> Value {
        self.asked += 1;
        let id = self.asked;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": what, "params": params }));
        loop {
            let mut message = self.hear();
            if message["id"] == id && message.get("method").is_none() {
                return message["result"].take();
            }
        }
    }

    fn change(&mut self, text: &str) {
        self.version += 1;
        let document = json!({ "uri": self.file, "version": self.version });
        let changes = json!([{ "text": text }]);
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    /// What is shown about an occurrence of a name.
    fn hover(&mut self, text: &str, name: &str, number: usize) -> String {
        let at = json!({ "textDocument": { "uri": self.file }, "position": place(text, name, number) });
        self.ask("textDocument/hover", at)["contents"]["value"].to_string()
    }

    /// The names that are offered in a text.
    fn complete(&mut self, text: &str, cursor: usize) -> Vec<String> {
        self.change(text);
        let at = json!({ "textDocument": { "uri": self.file }, "position": position(text, cursor) });
        let answer = self.ask("textDocument/completion", at);
        let items = if answer.is_array() { &answer } else { &answer["items"] };
        let labels = items.as_array().into_iter().flatten().filter_map(|item| item["label"].as_str());
        labels.map(str::to_owned).collect()
    }

    /// The errors that it shows by itself, once they name something.
    fn errors(&mut self, name: &str) -> Value {
        while !self.shown.to_string().contains(name) {
            thread::sleep(Duration::from_millis(50));
            // An answer comes after the messages before it.
            self.hover(RULES, "Tower", 0);
        }
        self.shown.take()
    }

    /// All semantic tokens of 400 rules come. The time is printed; docs/editor.md has a figure.
    fn check_large_grammar(&mut self) {
        let mut text = "cga::cga! {\n    grammar Town;\n    attr height = 24\n    Roof --> roofHip(30)\n".to_owned();
        for number in 0..200 {
            let next = (number + 1) % 200;
            text += &format!(
                "    Wall{number}(w) --> split(y) {{ ~3 : Tile{number}(w, height) | 1 : s(1, scope.sy, 2) Roof }}
                 Tile{number}(w, h) --> case w > h : color(\"#ff0000\") Wall{next}(w) else : comp(f) {{ front : Roof }}\n"
            );
        }
        self.change(&(text + "}\n"));
        let from = Instant::now();
        let tokens = self.ask("textDocument/semanticTokens/full", json!({ "textDocument": { "uri": self.file } }));
        assert!(2000 * 5 < tokens["data"].as_array().map_or(0, Vec::len), "{tokens}");
        println!("semantic tokens of 400 rules: {:?}", from.elapsed());
    }

    fn check(&mut self, text: &str, case: &Case) {
        let Case { name, ask, declared, all, said } = *case;
        let at = json!({ "textDocument": { "uri": self.file }, "position": place(text, name, ask) });
        let with = |key: &str, value: Value| {
            let mut at = at.clone();
            at[key] = value;
            at
        };
        let hover = self.hover(text, name, ask);
        assert!(said.iter().all(|said| hover.contains(said)), "{name} {ask}: {hover}");
        let definition = self.ask("textDocument/definition", at.clone());
        assert_eq!(starts(&definition), [place(text, name, declared)], "{name} {ask}: definition");
        let mut wanted: Vec<Value> = all.iter().map(|number| place(text, name, *number)).collect();
        wanted.sort_by_key(Value::to_string);
        let references = self.ask("textDocument/references", with("context", json!({ "includeDeclaration": true })));
        assert_eq!(starts(&references), wanted, "{name} {ask}: references");
        let rename = self.ask("textDocument/rename", with("newName", json!("renamed")));
        let edits = match &rename["changes"] {
            Value::Null => &rename["documentChanges"][0]["edits"],
            changes => &changes[&self.file],
        };
        assert_eq!(starts(edits), wanted, "{name} {ask}: rename");
    }
}

impl Drop for Editor {
    fn drop(&mut self) {
        let mut process = self.process.lock().expect("a process");
        process.kill().expect("it runs");
        process.wait().expect("it has ended");
    }
}

/// Where ranges begin, each once.
fn starts(list: &Value) -> Vec<Value> {
    let list = list.as_array().map(Vec::as_slice).unwrap_or_default();
    let mut starts: Vec<Value> = list.iter().map(|one| one["range"]["start"].clone()).collect();
    starts.sort_by_key(Value::to_string);
    starts.dedup();
    starts
}
