//! The server, asked as a browser and as others would.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::process::{Child, Stdio};

use crate::typed::{Folder, kin};

/// A server that is ended with the test.
pub(crate) struct Server {
    child: Child,
    pub(crate) port: u16,
}

impl Server {
    pub(crate) fn start(folder: &Folder, arguments: &[&str]) -> Self {
        let mut child = kin(folder)
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap())
            .read_line(&mut line)
            .unwrap();
        let port = line.split("127.0.0.1:").nth(1).and_then(|rest| rest.split('/').next());
        let port = port
            .unwrap_or_else(|| panic!("no address in {line:?}"))
            .parse()
            .unwrap();
        Self { child, port }
    }

    /// The answer to a request, head and content.
    pub(crate) fn ask(&self, request: &str) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream
            .write_all(request.replace("PORT", &self.port.to_string()).as_bytes())
            .unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        String::from_utf8(answer).unwrap()
    }

    pub(crate) fn get(&self, path: &str) -> String {
        self.ask(&format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1:PORT\r\n\r\n"))
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // it may have ended by itself
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn only_the_page_and_only_this_machine() {
    let folder = Folder::new("serve");
    let server = Server::start(&folder, &["serve", "scotch_yoke"]);
    let page = server.get("/");
    assert!(page.starts_with("HTTP/1.1 200 OK\r\n"), "{}", &page[..60]);
    assert!(page.contains("Content-Type: text/html") && page.contains("nosniff") && page.contains("<!doctype html>"));
    let host = "Host: 127.0.0.1:PORT";
    for (request, status) in [
        (format!("HEAD / HTTP/1.1\r\n{host}\r\n\r\n"), "200"),
        ("GET / HTTP/1.1\r\nHost: localhost:PORT\r\n\r\n".to_owned(), "200"),
        ("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n".to_owned(), "403"),
        ("GET / HTTP/1.1\r\n\r\n".to_owned(), "403"),
        (format!("GET / HTTP/1.1\r\n{host}\r\nHost: evil.example\r\n\r\n"), "403"),
        (format!("GET /etc/passwd HTTP/1.1\r\n{host}\r\n\r\n"), "404"),
        (format!("GET /../Cargo.toml HTTP/1.1\r\n{host}\r\n\r\n"), "404"),
        (format!("POST / HTTP/1.1\r\n{host}\r\n\r\n"), "405"),
        ("nonsense\r\n\r\n".to_owned(), "400"),
        (
            format!("GET / HTTP/1.1\r\n{host}\r\n{}\r\n\r\n", "a".repeat(20_000)),
            "400",
        ),
    ] {
        let answer = server.ask(&request);
        assert!(
            answer.starts_with(&format!("HTTP/1.1 {status}")),
            "{request:.60}: {answer:.60}"
        );
    }
}

/// Ctrl-C ends the program without a message.
#[cfg(unix)]
#[test]
fn it_ends_on_an_interrupt() {
    let folder = Folder::new("interrupt");
    let mut server = Server::start(&folder, &["serve", "scotch_yoke"]);
    let killed = std::process::Command::new("kill")
        .args(["-INT", &server.child.id().to_string()])
        .status()
        .unwrap();
    assert!(killed.success());
    assert!(server.child.wait().unwrap().success());
}
