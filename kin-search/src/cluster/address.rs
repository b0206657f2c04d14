//! The addresses of processes.

use std::fmt;
use std::io::{self, Write};
use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::time::Duration;

use crate::say;
use tokio::net::{TcpListener, TcpStream};
use tokio::time::sleep;

/// The address on which a process listens: by default a free port of this machine, which no other machine reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Listen(pub SocketAddr);

impl Default for Listen {
    fn default() -> Self {
        Self(SocketAddr::from((Ipv4Addr::LOCALHOST, 0)))
    }
}

impl Listen {
    /// A warning, if other machines can reach the address.
    #[must_use]
    pub fn warning(self) -> Option<String> {
        (!self.0.ip().is_loopback()).then(|| {
            format!(
                "warning: {} can be reached from other machines. Nothing is encrypted, and nobody is asked for a \
                 password: whoever reaches it runs queries, and reads and writes files as the user who runs this \
                 program. Read \"On several machines\" in the chapter on searches first.",
                self.0.ip()
            )
        })
    }

    /// A listener on the address.
    ///
    /// # Errors
    ///
    /// The system's error, for instance of a port that is taken.
    pub(super) async fn bind(self) -> io::Result<TcpListener> {
        TcpListener::bind(self.0).await
    }

    /// The port of the address, or a free one if it is 0. Another process may take it before it is used.
    ///
    /// # Errors
    ///
    /// The system's error, for instance of a port that is taken.
    pub(super) fn port(self) -> io::Result<u16> {
        Ok(std::net::TcpListener::bind(self.0)?.local_addr()?.port())
    }

    /// The same address with any free port.
    pub(super) fn beside(self) -> Self {
        Self((self.0.ip(), 0).into())
    }

    pub(super) fn ip(self) -> IpAddr {
        self.0.ip()
    }
}

/// The address of a scheduler: a host and a port.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Endpoint {
    /// The name or the address of the machine.
    pub host: String,
    /// The port.
    pub port: u16,
}

impl Endpoint {
    /// Waits until a process listens on the port.
    pub(super) async fn reach(&self) {
        let mut said = false;
        while let Err(error) = TcpStream::connect((self.host.as_str(), self.port)).await {
            if !said {
                say(format_args!("waiting for the scheduler at {self} ({error})"));
                said = true;
            }
            sleep(PAUSE).await;
        }
    }
}

impl fmt::Display for Endpoint {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}:{}", self.host, self.port)
    }
}

/// The pause between two attempts to reach a scheduler.
pub(super) const PAUSE: Duration = Duration::from_millis(300);

/// Prints the address on which a process listens, for people and for programs that started the process.
pub(super) fn announce(address: SocketAddr) {
    // A reader that has gone away is no reason to end.
    let _ = writeln!(io::stdout(), "listening on {address}");
}
