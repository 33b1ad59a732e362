//! rust-analyzer finds names inside the macro: hover, definition, references and rename of rules, attributes, constants and
//! parameters, also with an error elsewhere. Runs where it is installed (`rustup component add rust-analyzer`).
#![forbid(unsafe_code)]

use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

const RULES: &str = r##"cga::cga! {
    /// A tower.
    pub grammar Tower;
    @Range(min = 3, max = 60)
    attr height = 24
    const floor = height / 8

    @StartRule
    Lot --> extrude(height) comp(f) { side : Facade(height) | top : Roof }
    Facade(width) --> split(y) { ~floor : Tile(width, height) | 1 : Roof }
    Tile(w, h) --> case w > h : Roof else : split(x) { w : Glass. | ~1 : NIL }
    Roof --> color("#ff0000")
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
    said: &'static str,
}

const CASES: &[Case] = &[
    Case { name: "height", ask: 0, declared: 0, all: &[0, 1, 2, 3, 4, 5], said: "f64" },
    Case { name: "height", ask: 2, declared: 0, all: &[0, 1, 2, 3, 4, 5], said: "height" },
    Case { name: "height", ask: 5, declared: 0, all: &[0, 1, 2, 3, 4, 5], said: "height" },
    Case { name: "floor", ask: 1, declared: 0, all: &[0, 1], said: "floor" },
    Case { name: "Facade", ask: 0, declared: 1, all: &[0, 1], said: "Facade" },
    Case { name: "Roof", ask: 1, declared: 3, all: &[0, 1, 2, 3], said: "Roof" },
    Case { name: "width", ask: 1, declared: 0, all: &[0, 1], said: "width: f64" },
    Case { name: "Tower", ask: 1, declared: 0, all: &[0, 1, 2, 3], said: "A tower" },
];

#[test]
fn an_editor_finds_names_inside_the_macro() {
    let found = Command::new("rust-analyzer").arg("--version").output();
    if !found.is_ok_and(|output| output.status.success()) {
        println!("left out: rust-analyzer is not installed");
        return;
    }
    let package = package();
    let mut editor = Editor::new(&package);
    for case in CASES {
        editor.check(RULES, case);
    }
    // An error far from them.
    let wrong = RULES.replace("Glass.", "Glas");
    editor.change(&wrong);
    for case in CASES {
        editor.check(&wrong, case);
    }
}

fn package() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("editor");
    fs::create_dir_all(folder.join("src")).expect("a writable target folder");
    let root = env!("CARGO_MANIFEST_DIR");
    let manifest = format!(
        "[package]\nname = \"editor\"\nversion = \"0.0.0\"\nedition = \"2021\"\npublish = false\n\n[dependencies]\n\
         cga = {{ path = {root:?}, default-features = false }}\n\n[workspace]\n"
    );
    fs::write(folder.join("Cargo.toml"), manifest).expect("a writable target folder");
    fs::write(folder.join("src/lib.rs"), RULES).expect("a writable target folder");
    fs::copy(Path::new(root).join("Cargo.lock"), folder.join("Cargo.lock")).expect("a lock file");
    folder
}

/// Where an occurrence of a word begins.
fn place(text: &str, word: &str, number: usize) -> Value {
    let (at, _) = text.match_indices(word).nth(number).expect("so many");
    let line = text[..at].matches('\n').count();
    json!({ "line": line, "character": at - text[..at].rfind('\n').map_or(0, |end| end + 1) })
}

/// rust-analyzer, spoken to over its protocol.
struct Editor {
    process: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    file: String,
    asked: u64,
}

impl Editor {
    fn new(package: &Path) -> Self {
        let mut process = Command::new("rust-analyzer")
            .current_dir(package)
            .env("CARGO_NET_OFFLINE", "true")
            .env("CARGO_TARGET_DIR", package.join("target"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("rust-analyzer");
        let input = process.stdin.take().expect("it is piped");
        let output = BufReader::new(process.stdout.take().expect("it is piped"));
        let root = format!("file://{}", package.display());
        let mut editor = Editor { process, input, output, file: format!("{root}/src/lib.rs"), asked: 0 };
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
        let document = json!({ "uri": self.file, "version": 2 });
        let changes = json!([{ "text": text }]);
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }

    fn check(&mut self, text: &str, case: &Case) {
        let Case { name, ask, declared, all, said } = *case;
        let at = json!({ "textDocument": { "uri": self.file }, "position": place(text, name, ask) });
        let with = |key: &str, value: Value| {
            let mut at = at.clone();
            at[key] = value;
            at
        };
        let hover = self.ask("textDocument/hover", at.clone())["contents"]["value"].to_string();
        assert!(hover.contains(said), "{name} {ask}: {hover}");
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
        self.process.kill().expect("it runs");
        self.process.wait().expect("it has ended");
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
