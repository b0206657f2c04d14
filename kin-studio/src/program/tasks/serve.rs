//! `kin serve`: the page of a mechanism in a browser of this machine.

use std::sync::OnceLock;

use super::super::command::Serve;
use super::super::server::{Answer, serve};
use super::report::page;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::subject::Subject;

static PAGE: OnceLock<String> = OnceLock::new();

pub(super) fn run(subject: &Subject, options: &Serve, settings: &Settings) -> Result<(), Fault> {
    let page = page(subject, &options.page(), settings)?;
    PAGE.get_or_init(|| page);
    serve(subject.description().name, options.port, &answer)
}

fn answer(path: &str) -> Option<Answer> {
    (path == "/").then(|| Answer {
        kind: "text/html; charset=utf-8",
        body: PAGE.get().cloned().unwrap_or_default(),
        // the page carries its own policy
        policy: None,
    })
}
