//! `.kin` files.

use std::time::{Duration, Instant};

use crate::serving::Server;
use crate::typed::{Folder, kin, typed_in};

const WIPER: &str = include_str!("wiper.kin");

/// Waits until the page of a server says something.
fn wait(server: &Server, is_there: impl Fn(&str) -> bool) -> String {
    let start = Instant::now();
    loop {
        let page = server.get("/page");
        if is_there(&page) {
            return page;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "the file is not looked at");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn says(told: &str, text: &str) {
    assert!(told.contains(text), "{told}");
}

/// A file is run, changed and spoilt, where nothing but the program is installed.
#[test]
fn a_file_is_run() {
    let folder = Folder::new("run");
    folder.write("wiper.kin", WIPER);
    let run = |arguments: &[&str]| {
        let output = kin(&folder).args(arguments).env("PATH", "").output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    says(
        &run(&["run", "wiper.kin", "sweep", "--rows", "5"]),
        "180.000   8.9079  150.637  -192.187  220.656         270.000       45.0000        45.000\n",
    );
    folder.write("wiper.kin", &WIPER.replace("crank = 40mm", "crank = 4.5cm"));
    says(
        &run(&["run", "wiper.kin", "peaks", "--of", "psi"]),
        "theta moves at 270 deg/s\n",
    );
    says(
        &run(&["run", "wiper.kin", "show"]),
        "  crank * cis(theta) + rod * cis(phi)",
    );
    says(&run(&["run", "wiper.kin", "verify"]), "Wiper: passed, ");
    says(&run(&["run", "wiper.kin", "code", "c"]), "wiper.c: ");

    // a block is called by its unknowns wherever one is named
    for (line, text) in [
        ("cycle --set rod=120mm", "of phi, psi"),
        ("sweep --set rod=120mm", "limit position of phi, psi"),
        ("sweep --set rod=120mm --json -", "\"phi, psi\""),
        ("report --set rod=12mm", "phi, psi"),
    ] {
        let told = typed_in(&folder, &format!("kin run wiper.kin {line}"));
        assert!(told.contains(text) && !told.contains('‹'), "{told}");
    }

    // mistakes that the compiler finds have their places in the file
    for (own, other, message, place) in [
        (
            "rocker * cis(psi);",
            "rocker * cis(chi);",
            "is called `chi`; did you mean `phi`?",
            "wiper.kin:6:62\n",
        ),
        (
            "rod * cis(phi) ==",
            "rod + cis(phi) ==",
            "cannot add a plane vector of lengths and a plane vector of plain numbers",
            "wiper.kin:6:26\n",
        ),
    ] {
        folder.write("wiper.kin", &WIPER.replacen(own, other, 1));
        let told = typed_in(&folder, "kin run wiper.kin report");
        says(&told, message);
        says(&told, place);
        says(&told, "-- code 2\n");
    }
}

/// The page comes back when the file is mended.
#[test]
fn a_file_is_watched() {
    let folder = Folder::new("watched");
    folder.write("wiper.kin", &WIPER.replacen("cis(psi);", "cis(chi);", 1));
    let server = Server::start(&folder, &["run", "wiper.kin", "serve"]);
    says(&server.get("/"), "<iframe");
    says(&server.get("/page"), "A mistake");
    let version = server.get("/version");
    folder.write("wiper.kin", WIPER);
    let page = wait(&server, |page| !page.contains("A mistake"));
    says(&page, "Wiper");
    assert_ne!(server.get("/version"), version);
}

/// The first look at the file lasts until the pipe is closed, and by then another file has its name.
#[cfg(unix)]
#[test]
fn a_change_during_the_first_look_is_seen() {
    let folder = Folder::new("changed");
    let path = folder.path().join("wiper.kin");
    let made = std::process::Command::new("mkfifo").arg(&path).status().unwrap();
    assert!(made.success());
    let other = folder.write("other.kin", &WIPER.replacen("kin 1", "kin 2", 1));
    let writer = std::thread::spawn(move || {
        let mut pipe = std::fs::OpenOptions::new().write(true).open(&path).unwrap();
        std::fs::rename(other, &path).unwrap();
        std::io::Write::write_all(&mut pipe, WIPER.replacen("motion {", "movement {", 1).as_bytes()).unwrap();
    });
    let server = Server::start(&folder, &["run", "wiper.kin", "serve"]);
    writer.join().unwrap();
    wait(&server, |page| page.contains("kin 2"));
}
