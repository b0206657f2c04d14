//! `kin run FILE.kin serve`: the page of a file, made again whenever the file changes.

use std::ffi::OsString;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use super::super::fault::Fault;
use super::super::server::{Answer, escaped, hash, serve};
use super::Run;

/// The time between two looks at the file.
const PAUSE: Duration = Duration::from_millis(300);

/// The frame around the page. It asks for the version, and loads the page again when that has changed.
const SCRIPT: &str = "const frame = document.querySelector('iframe');\n\
let known = null;\n\
async function look() {\n\
  try {\n\
    const version = await (await fetch('/version')).text();\n\
    if (known !== null && version !== known) frame.contentWindow.location.reload();\n\
    known = version;\n\
  } catch { /* the program has ended */ }\n\
  setTimeout(look, 500);\n\
}\n\
look();\n";
const STYLE: &str =
    "html, body { margin: 0; height: 100%; } iframe { border: 0; width: 100%; height: 100%; display: block; }";
const MISTAKE_STYLE: &str = "\
body { font: 15px/1.5 ui-monospace, monospace; margin: 2rem; } pre { white-space: pre-wrap; } \
@media (prefers-color-scheme: dark) { body { background: #111; color: #ddd; } }";

/// The page that is shown.
struct Shown {
    page: Mutex<(String, bool)>,
    version: AtomicU64,
}

static SHOWN: Shown = Shown {
    page: Mutex::new((String::new(), true)),
    version: AtomicU64::new(0),
};

/// Serves the page of a file. The arguments are those of `serve`.
pub(crate) fn watch(run: &Run, arguments: &[OsString]) -> Result<(), Fault> {
    let (port, arguments) = port_of(arguments)?;
    let name = run.path.display().to_string();
    // before the first build, which may take minutes, so that a change meanwhile is seen
    let mut known = stamp(run);
    show(run, &arguments);
    let looked = run.clone();
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(PAUSE);
            let now = stamp(&looked);
            if now != known {
                known = now;
                show(&looked, &arguments);
            }
        }
    });
    serve(&name, port, &answer)
}

/// The time and the length of the file, by which a change is seen.
fn stamp(run: &Run) -> Option<(std::time::SystemTime, u64)> {
    let file = std::fs::metadata(&run.path).ok()?;
    Some((file.modified().ok()?, file.len()))
}

/// Makes the page, or the page of the mistake.
fn show(run: &Run, arguments: &[OsString]) {
    let made = page(run, arguments);
    let entry = match made {
        Ok(page) => {
            eprintln!("{} is shown", run.path.display());
            (page, true)
        }
        Err(fault) => {
            eprintln!("{fault}");
            (fault.to_string(), false)
        }
    };
    if let Ok(mut shown) = SHOWN.page.lock() {
        *shown = entry;
    }
    SHOWN.version.fetch_add(1, Ordering::Release);
}

fn page(run: &Run, arguments: &[OsString]) -> Result<String, Fault> {
    let mut command = run.command()?;
    let output = command
        .arg("report")
        .args(arguments)
        .args(["--output", "-"])
        .output()
        .map_err(|error| Fault::build(format!("what was built cannot be run: {error}")))?;
    let told = String::from_utf8_lossy(&output.stderr);
    let told = told.trim();
    if !output.stdout.is_empty() {
        // a page of a motion that does not close everywhere is shown as well
        if !told.is_empty() {
            eprintln!("{told}");
        }
        return Ok(String::from_utf8_lossy(&output.stdout).into_owned());
    }
    Err(Fault::wrong(told.strip_prefix("error: ").unwrap_or(told)))
}

fn answer(path: &str) -> Option<Answer> {
    let html = "text/html; charset=utf-8";
    match path {
        "/" => Some(Answer {
            kind: html,
            body: format!(
                "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>kin</title><style>{STYLE}</style>\
                 <iframe src=\"/page\" title=\"The mechanism\"></iframe><script>{SCRIPT}</script></html>"
            ),
            policy: Some(format!(
                "default-src 'none'; script-src {}; style-src {}; connect-src 'self'; frame-src 'self'",
                hash(SCRIPT),
                hash(STYLE)
            )),
        }),
        "/version" => Some(Answer {
            kind: "text/plain; charset=utf-8",
            body: SHOWN.version.load(Ordering::Acquire).to_string(),
            policy: None,
        }),
        "/page" => {
            let (text, is_page) = SHOWN.page.lock().ok()?.clone();
            Some(if is_page {
                Answer {
                    kind: html,
                    body: text,
                    policy: None,
                }
            } else {
                Answer {
                    kind: html,
                    body: format!(
                        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>A mistake</title>\
                         <style>{MISTAKE_STYLE}</style>\
                         <h1>A mistake</h1><pre>{}</pre><p>The page comes back when the file is mended.</p></html>",
                        escaped(&text)
                    ),
                    policy: Some(format!("default-src 'none'; style-src {}", hash(MISTAKE_STYLE))),
                }
            })
        }
        _ => None,
    }
}

/// The port that was asked for, and the other arguments.
fn port_of(arguments: &[OsString]) -> Result<(Option<u16>, Vec<OsString>), Fault> {
    let mut others = Vec::new();
    let mut port = None;
    let mut words = arguments.iter();
    while let Some(word) = words.next() {
        let text = word.to_string_lossy();
        let value = match text.strip_prefix("--port=") {
            Some(value) => value.to_owned(),
            None if text == "--port" => words
                .next()
                .map(|value| value.to_string_lossy().into_owned())
                .unwrap_or_default(),
            None => {
                others.push(word.clone());
                continue;
            }
        };
        let number = value
            .parse()
            .map_err(|_| Fault::wrong(format!("`{value}` is no port: write `--port 8080`")))?;
        port = Some(number);
    }
    Ok((port, others))
}
