//! A server for this machine only, with a fixed list of paths.

use std::io::{self, BufRead as _, BufReader, Read as _, Write as _};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::time::Duration;

use crate::case::fault::Fault;

/// The longest head of a request.
const LONGEST_HEAD: u64 = 16 * 1024;
/// The longest rest of a request that is read and thrown away.
const LONGEST_REST: u64 = 1024 * 1024;
/// The longest wait for each read and each write.
const PATIENCE: Duration = Duration::from_secs(5);

/// The content that is sent for a path.
pub(crate) struct Answer {
    /// The type of the content.
    pub(crate) kind: &'static str,
    /// The content.
    pub(crate) body: String,
    /// The policy for pages that carry none.
    pub(crate) policy: Option<String>,
}

/// Answers every request until the program is ended. `answer` returns nothing for a path that is not in its list.
pub(crate) fn serve(
    name: &str,
    port: Option<u16>,
    answer: &'static (dyn Fn(&str) -> Option<Answer> + Sync),
) -> Result<(), Fault> {
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port.unwrap_or(0))).map_err(|error| {
        Fault::wrong(match port {
            Some(port) => format!("the port {port} cannot be used: {error}; leave `--port` out to take a free one"),
            None => format!("no port can be opened on 127.0.0.1: {error}"),
        })
    })?;
    let port = listener.local_addr().map_err(Fault::wrong)?.port();
    ctrlc::set_handler(|| std::process::exit(0)).map_err(Fault::wrong)?;
    let mut output = io::stdout().lock();
    // nobody may read the output
    let _ = writeln!(output, "{name}: http://127.0.0.1:{port}/ (Ctrl-C ends it)");
    let _ = output.flush();
    drop(output);
    for stream in listener.incoming() {
        // a connection that fails is the browser's concern
        let Ok(stream) = stream else { continue };
        std::thread::spawn(move || {
            let _ = connection(&stream, port, answer);
        });
    }
    Ok(())
}

fn connection(mut stream: &TcpStream, port: u16, answer: &dyn Fn(&str) -> Option<Answer>) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_write_timeout(Some(PATIENCE))?;
    let mut lines = BufReader::new(stream.take(LONGEST_HEAD)).lines();
    let first = lines.next().transpose()?.unwrap_or_default();
    let mut hosts = Vec::new();
    let mut is_whole = false;
    for line in lines.by_ref() {
        let line = line?;
        if line.is_empty() {
            is_whole = true;
            break;
        }
        if let Some((name, value)) = line.split_once(':')
            && name.eq_ignore_ascii_case("host")
        {
            hosts.push(value.trim().to_owned());
        }
    }
    let mut words = first.split(' ');
    let (method, path, version) = (words.next(), words.next(), words.next());
    let (status, answer) = match (method, path, version) {
        _ if !is_whole => ("400 Bad Request", None),
        (Some(_), Some(_), Some("HTTP/1.1" | "HTTP/1.0")) if !is_for_this_machine(&hosts, port) => {
            ("403 Forbidden", None)
        }
        (Some("GET" | "HEAD"), Some(path), Some("HTTP/1.1" | "HTTP/1.0")) => match answer(path) {
            Some(answer) => ("200 OK", Some(answer)),
            None => ("404 Not Found", None),
        },
        (Some(_), Some(_), Some("HTTP/1.1" | "HTTP/1.0")) => ("405 Method Not Allowed", None),
        _ => ("400 Bad Request", None),
    };
    let answer = answer.unwrap_or_else(|| Answer {
        kind: "text/plain; charset=utf-8",
        body: format!("{status}\n"),
        policy: None,
    });
    let policy = answer
        .policy
        .map(|policy| format!("Content-Security-Policy: {policy}\r\n"))
        .unwrap_or_default();
    write!(
        stream,
        "HTTP/1.1 {status}\r\nContent-Type: {}\r\nContent-Length: {}\r\n{policy}Cache-Control: no-store\r\n\
         X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\nConnection: close\r\n\r\n",
        answer.kind,
        answer.body.len()
    )?;
    if method != Some("HEAD") {
        stream.write_all(answer.body.as_bytes())?;
    }
    stream.flush()?;
    // bytes that have not been read would turn the end of the connection into an error
    stream.shutdown(Shutdown::Write)?;
    io::copy(&mut stream.take(LONGEST_REST), &mut io::sink())?;
    Ok(())
}

/// Whether the request names this machine. A page of another site, whose name was made to lead to this machine, sends
/// the name of that site.
fn is_for_this_machine(hosts: &[String], port: u16) -> bool {
    let [host] = hosts else { return false };
    let (name, of_host) = match host.split_once(':') {
        Some((name, port)) => (name, port),
        // browsers leave the port of HTTP out
        None => (host.as_str(), "80"),
    };
    ["127.0.0.1", "localhost"].contains(&name) && of_host == port.to_string()
}

/// A text inside of HTML.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// The hash of a script or a style, as a policy names it.
pub(crate) fn hash(text: &str) -> String {
    format!(
        "'sha256-{}'",
        data_encoding::BASE64.encode(&hmac_sha256::Hash::hash(text.as_bytes()))
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_this_machine_is_answered() {
        let hosts = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
        for name in ["127.0.0.1:80", "localhost:80", "127.0.0.1", "localhost"] {
            assert!(is_for_this_machine(&hosts(&[name]), 80), "{name}");
        }
        for name in ["127.0.0.1", "localhost"] {
            assert!(!is_for_this_machine(&hosts(&[name]), 8080), "{name}");
        }
        for names in [
            &[][..],
            &["evil.example:80"],
            &["evil.example"],
            &["127.0.0.1:81"],
            &["127.0.0.1:080"],
            &["127.0.0.1:"],
            &["127.0.0.1:80", "evil.example"],
        ] {
            assert!(!is_for_this_machine(&hosts(names), 80), "{names:?}");
        }
        assert_eq!(escaped("<b a=\"&\">"), "&lt;b a=&quot;&amp;&quot;&gt;");
    }
}
