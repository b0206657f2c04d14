//! `kin serve FILE.kin`: the page of a file, made again whenever the file changes.

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime};

use super::super::command::{Report, Serve};
use super::super::server::{Answer, escaped, hash, serve};
use crate::case::fault::Fault;
use crate::case::file;

/// The time between two looks at the file.
const PAUSE: Duration = Duration::from_millis(100);

/// The frame around the page. It asks for the version, and loads the page again when that has changed.
const SCRIPT: &str = "const frame = document.querySelector('iframe');\n\
let known = null;\n\
async function look() {\n\
  try {\n\
    const version = await (await fetch('/version')).text();\n\
    if (known !== null && version !== known) frame.contentWindow.location.reload();\n\
    known = version;\n\
  } catch { /* the program has ended */ }\n\
  setTimeout(look, 200);\n\
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

/// Serves the page of a file.
pub(crate) fn watch(path: &Path, options: &Serve) -> Result<(), Fault> {
    let (looked, report) = (path.to_owned(), options.page());
    // before the first page, so that a change meanwhile is seen
    let mut known = stamp(path);
    show(path, &report);
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(PAUSE);
            let now = stamp(&looked);
            if now != known {
                known = now;
                show(&looked, &report);
            }
        }
    });
    serve(&path.display().to_string(), options.port, &answer)
}

/// The time and the length of the file, by which a change is seen.
fn stamp(path: &Path) -> Option<(SystemTime, u64)> {
    let file = std::fs::metadata(path).ok()?;
    Some((file.modified().ok()?, file.len()))
}

/// Makes the page, or the page of the mistake.
fn show(path: &Path, report: &Report) {
    let made = file::read(path).and_then(|(subject, settings)| super::page(&subject, report, &settings));
    let entry = match made {
        Ok(page) => {
            eprintln!("{} is shown", path.display());
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
