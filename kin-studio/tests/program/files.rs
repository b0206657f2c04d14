//! `.kin` files.

use std::time::{Duration, Instant};

use crate::serving::Server;
use crate::typed::{Folder, kin, typed_in};

const WIPER: &str = include_str!("wiper.kin");
const PLATFORM: &str = include_str!("platform.kin");

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

/// Six legs that are declared as one, on a body that is a frame.
#[test]
fn a_platform_is_run() {
    let folder = Folder::new("platform");
    folder.write("platform.kin", PLATFORM);
    let told = typed_in(&folder, "kin run platform.kin sweep --rows 2 --columns x,y,pitch");
    says(&told, "170.000  -9.75846  6.71925  -0.99571");
    says(&typed_in(&folder, "kin run platform.kin verify"), "Platform: passed, ");
    // one leg is wrong, and the list says which
    folder.write("platform.kin", &PLATFORM.replace("a5, b5, l5", "a5, l5, b5"));
    let told = typed_in(&folder, "kin check platform.kin");
    says(
        &told,
        "but this is a scalar: write `vec3(x, y, z)`\n  --> platform.kin:15:36\n",
    );
    assert_eq!(told.matches("-->").count(), 1, "{told}");
}

#[test]
fn a_file_is_formatted() {
    let folder = Folder::new("formatted");
    let path = folder.write("wiper.kin", &WIPER.replace(' ', "  ").replacen("kin  1", "kin 1", 1));
    let read = || std::fs::read_to_string(&path).unwrap();
    let told = typed_in(&folder, "kin fmt --check wiper.kin");
    says(&told, "wiper.kin is in another form");
    says(&told, "-- code 1\n");
    assert_ne!(read(), WIPER);
    assert_eq!(
        typed_in(&folder, "kin fmt wiper.kin"),
        "$ kin fmt wiper.kin\n-- code 0\n"
    );
    // but for the words of comments
    assert_eq!(read().replace("  ", " "), WIPER);
    says(&typed_in(&folder, "kin fmt --check wiper.kin"), "-- code 0\n");

    // what has mistakes in its form is left alone
    let spoilt = WIPER.replacen("psi: Angle;", "psi:  Angle", 1);
    folder.write("wiper.kin", &spoilt);
    let told = typed_in(&folder, "kin fmt wiper.kin");
    says(&told, "a statement ends with `;`\n --> wiper.kin:5:");
    says(&told, "-- code 2\n");
    assert_eq!(read(), spoilt);
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
