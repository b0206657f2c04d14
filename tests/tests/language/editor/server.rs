//! A client of rust-analyzer, as small as the tests need it. It speaks the Language Server Protocol over pipes.

use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Duration;

use serde_json::{Value, json};

/// The longest time to wait for a message. The first one waits for a build of the macro.
const PATIENCE: Duration = Duration::from_secs(600);

/// The mark of the cursor in a text.
const CURSOR: char = '¦';

/// A running server with one open file.
pub(super) struct Server {
    process: Child,
    input: ChildStdin,
    messages: Receiver<Value>,
    requests: u64,
    versions: u64,
    file: PathBuf,
}

impl Server {
    /// Makes a program with this text, and starts a server for it.
    pub(super) fn start(text: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("editor");
        let file = write_program(&folder, text);
        let mut process = Command::new("rust-analyzer")
            .current_dir(&folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("rust-analyzer is installed by `rustup component add rust-analyzer`");
        let input = process.stdin.take().expect("the input is a pipe");
        let output = process.stdout.take().expect("the output is a pipe");
        let (sender, messages) = channel();
        thread::spawn(move || {
            let mut output = BufReader::new(output);
            while let Some(message) = read(&mut output) {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        let mut server = Self {
            process,
            input,
            messages,
            requests: 0,
            versions: 0,
            file,
        };
        server.request(
            "initialize",
            &json!({
                "processId": null,
                "rootUri": uri(&folder),
                "capabilities": {
                    "experimental": { "serverStatusNotification": true },
                    "textDocument": { "diagnostic": {} },
                },
                "initializationOptions": {
                    "checkOnSave": false,
                    "cachePriming": { "enable": false },
                    "cargo": { "targetDir": true },
                },
            }),
        );
        server.notify("initialized", &json!({}));
        let file = server.file.clone();
        server.open(&file, text);
        server.wait_until_loaded();
        server
    }

    /// Opens a file.
    pub(super) fn open(&mut self, file: &Path, text: &str) {
        let document = json!({ "uri": uri(file), "languageId": "rust", "version": 0, "text": text });
        self.notify("textDocument/didOpen", &json!({ "textDocument": document }));
    }

    /// The labels that are offered at the cursor.
    pub(super) fn completions(&mut self, text: &str) -> Vec<String> {
        let found = self.at_cursor("textDocument/completion", text);
        let items = found
            .get("items")
            .unwrap_or(&found)
            .as_array()
            .cloned()
            .unwrap_or_default();
        let label = |item: &Value| {
            let label = item["label"].as_str().unwrap_or_default();
            // the name alone, without `(…)` or `(as Trait)`
            label.split('(').next().unwrap_or_default().to_owned()
        };
        items.iter().map(label).collect()
    }

    /// The text of the hint at the cursor.
    pub(super) fn hover(&mut self, text: &str) -> String {
        let found = self.at_cursor("textDocument/hover", text);
        found["contents"]["value"].as_str().unwrap_or_default().to_owned()
    }

    /// The texts that follow the places where the name at the cursor is defined, in the open file.
    pub(super) fn definitions(&mut self, text: &str) -> Vec<String> {
        let found = self.at_cursor("textDocument/definition", text);
        let text = text.replace(CURSOR, "");
        let own = uri(&self.file);
        let places = found.as_array().cloned().unwrap_or_default();
        let rest = |place: &Value| {
            let (file, range) = match place.get("targetUri") {
                Some(file) => (file, &place["targetSelectionRange"]),
                None => (&place["uri"], &place["range"]),
            };
            let start = &range["start"];
            let line = text.lines().nth(usize::try_from(start["line"].as_u64()?).ok()?)?;
            let column = usize::try_from(start["character"].as_u64()?).ok()?;
            (*file == own).then(|| line[column..].to_owned())
        };
        places.iter().filter_map(rest).collect()
    }

    /// The messages about the program with this text.
    pub(super) fn diagnostics(&mut self, text: &str) -> Vec<String> {
        self.change(text);
        let file = self.file.clone();
        self.diagnostics_of(&file)
    }

    /// The messages about an open file.
    pub(super) fn diagnostics_of(&mut self, file: &Path) -> Vec<String> {
        let found = self.request(
            "textDocument/diagnostic",
            &json!({ "textDocument": { "uri": uri(file) } }),
        );
        let items = found["items"].as_array().cloned().unwrap_or_default();
        let message = |item: &Value| item["message"].as_str().unwrap_or_default().to_owned();
        items.iter().map(message).collect()
    }

    /// Changes the text to the one with a cursor, and asks about the place of the cursor.
    fn at_cursor(&mut self, method: &str, text: &str) -> Value {
        let before = text.split(CURSOR).next().unwrap_or_default();
        assert!(before.len() < text.len(), "a cursor is missing in {text}");
        self.change(&text.replace(CURSOR, ""));
        let line = before.matches('\n').count();
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count();
        let place = json!({
            "textDocument": { "uri": uri(&self.file) },
            "position": { "line": line, "character": column },
        });
        self.request(method, &place)
    }

    fn change(&mut self, text: &str) {
        self.versions += 1;
        let change = json!({
            "textDocument": { "uri": uri(&self.file), "version": self.versions },
            "contentChanges": [{ "text": text }],
        });
        self.notify("textDocument/didChange", &change);
    }

    /// Sends a request, and returns its answer. Requests of the server are answered with nothing.
    fn request(&mut self, method: &str, parameters: &Value) -> Value {
        self.requests += 1;
        let id = self.requests;
        self.send(json!({ "id": id, "method": method, "params": parameters }));
        loop {
            let message = self.receive();
            if message.get("method").is_none() && message["id"] == id {
                assert!(message.get("error").is_none(), "{method}: {message}");
                return message["result"].clone();
            }
        }
    }

    fn notify(&mut self, method: &str, parameters: &Value) {
        self.send(json!({ "method": method, "params": parameters }));
    }

    /// Waits until the program is loaded and the macro is built.
    fn wait_until_loaded(&mut self) {
        let mut has_worked = false;
        loop {
            let message = self.receive();
            if message["method"] == "experimental/serverStatus" {
                let quiet = message["params"]["quiescent"] == true;
                if quiet && has_worked {
                    return;
                }
                has_worked |= !quiet;
            }
        }
    }

    fn receive(&mut self) -> Value {
        let message = self.messages.recv_timeout(PATIENCE).expect("the server answers");
        if message.get("method").is_some() && message.get("id").is_some() {
            let items = message["params"]["items"].as_array().map_or(0, Vec::len);
            let result = if message["method"] == "workspace/configuration" {
                json!(vec![Value::Null; items])
            } else {
                Value::Null
            };
            self.send(json!({ "id": message["id"], "result": result }));
        }
        message
    }

    fn send(&mut self, mut message: Value) {
        message["jsonrpc"] = json!("2.0");
        let text = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).expect("the server reads");
        self.input.flush().expect("the server reads");
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // a server that has ended by itself needs no end
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Reads a message; `None` at the end of the output.
fn read(output: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        if let Some(count) = line.strip_prefix("Content-Length:") {
            length = count.trim().parse().ok()?;
        }
        if line.trim().is_empty() {
            break;
        }
    }
    let mut content = vec![0; length];
    output.read_exact(&mut content).ok()?;
    serde_json::from_slice(&content).ok()
}

/// Writes a program that depends on kin-core, and returns its file.
fn write_program(folder: &Path, text: &str) -> PathBuf {
    let repository = super::repository();
    let core = repository.join("kin-core");
    let manifest = format!(
        "[package]\nname = \"edited\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[dependencies]\n\
         kin-core = {{ path = \"{}\", features = [\"library\"] }}\n\n[workspace]\n",
        core.display()
    );
    let file = folder.join("src/main.rs");
    fs::create_dir_all(folder.join("src")).expect("the folder of tests can be written");
    fs::copy(repository.join("Cargo.lock"), folder.join("Cargo.lock")).expect("the repository has a lock file");
    fs::write(folder.join("Cargo.toml"), manifest).expect("the folder of tests can be written");
    fs::write(&file, text).expect("the folder of tests can be written");
    file
}

fn uri(file: &Path) -> String {
    format!("file://{}", file.display())
}
