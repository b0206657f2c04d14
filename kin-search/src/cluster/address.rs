//! Where a process listens.

use std::io::{self, Write};
use std::net::{IpAddr, Ipv4Addr, SocketAddr};

use tokio::net::TcpListener;

/// Where a process listens: on this machine alone, and on a free port, unless told otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Listen(pub SocketAddr);

impl Default for Listen {
    fn default() -> Self {
        Self(SocketAddr::from((Ipv4Addr::LOCALHOST, 0)))
    }
}

impl Listen {
    /// What to warn of, if other machines can reach the address.
    #[must_use]
    pub fn warning(self) -> Option<String> {
        (!self.0.ip().is_loopback()).then(|| {
            format!(
                "warning: {} can be reached from other machines. Nothing is encrypted, and nobody is asked for a password: \
                 whoever reaches it runs queries, and reads the files of this user. Read \"On several machines\" in the \
                 chapter on searches first.",
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

    /// A port of the address that is free now. Another process may take it before it is used.
    pub(super) fn free_port(self) -> io::Result<u16> {
        Ok(std::net::TcpListener::bind((self.0.ip(), 0))?.local_addr()?.port())
    }

    pub(super) fn ip(self) -> IpAddr {
        self.0.ip()
    }
}

/// Prints where a process listens, for people and for programs that started it.
pub(super) fn announce(address: SocketAddr) {
    // A reader that has gone away is no reason to end.
    let _ = writeln!(io::stdout(), "listening on {address}");
}
