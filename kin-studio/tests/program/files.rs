//! `.kin` files that are built for real.

use std::time::{Duration, Instant};

use crate::serving::Server;
use crate::typed::{Folder, kin, typed_in};

const WIPER: &str = include_str!("wiper.kin");

/// A file is built, run, changed, spoilt and shown. It takes minutes, since kin itself is built for it.
#[test]
#[ignore = "builds kin once more"]
fn a_file_is_built_and_run() {
    let folder = Folder::new("built");
    folder.write("wiper.kin", WIPER);
    let cold = Instant::now();
    says(
        &typed_in(&folder, "kin run wiper.kin sweep --rows 5"),
        "180.000   8.9079  150.637  -192.187  220.656         270.000       45.0000        45.000\n",
    );
    let cold = cold.elapsed();

    // other numbers need no other build
    let warm = Instant::now();
    folder.write("wiper.kin", &WIPER.replace("crank = 40mm", "crank = 4.5cm"));
    says(
        &typed_in(&folder, "kin run wiper.kin peaks --of psi"),
        "theta moves at 270 deg/s\n",
    );
    let warm = warm.elapsed();
    assert!(3 * warm < cold, "{warm:?} after {cold:?}");
    says(
        &typed_in(&folder, "kin run wiper.kin show"),
        "  crank * cis(theta) + rod * cis(phi)",
    );

    // mistakes that the macro finds have their places in the file
    let build = Instant::now();
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
        says(&told, "-- code 3\n");
    }
    eprintln!(
        "first build {cold:.1?}, from the cache {warm:.1?}, two mistakes {:.1?}",
        build.elapsed()
    );

    // the page comes back when the file is mended
    let server = Server::start(&folder, &["run", "wiper.kin", "serve"]);
    assert!(server.get("/").contains("<iframe"));
    let version = server.get("/version");
    assert!(server.get("/page").contains("A mistake"));
    folder.write("wiper.kin", WIPER);
    let start = Instant::now();
    while server.get("/version") == version {
        assert!(start.elapsed() < Duration::from_secs(120), "the file is not looked at");
        std::thread::sleep(Duration::from_millis(100));
    }
    let page = server.get("/page");
    assert!(page.contains("Wiper") && !page.contains("A mistake"));
    drop(server);

    // two at once wait for each other
    folder.write("wiper.kin", &WIPER.replace("Wiper", "Other"));
    let both: Vec<_> = (0..2)
        .map(|_| {
            kin(&folder)
                .args(["run", "wiper.kin", "sweep", "--rows", "2"])
                .stdout(std::process::Stdio::null())
                .spawn()
                .unwrap()
        })
        .collect();
    for mut one in both {
        assert!(one.wait().unwrap().success());
    }
    assert!(typed_in(&folder, "kin cache clear").contains("FOLDER/cache is empty"));
    assert!(!folder.path().join("cache/built").exists());
}

fn says(told: &str, text: &str) {
    assert!(told.contains(text), "{told}");
}

#[test]
fn a_missing_toolchain_is_named() {
    let folder = Folder::new("toolchain");
    folder.write("wiper.kin", WIPER);
    let output = kin(&folder)
        .args(["run", "wiper.kin", "sweep"])
        .env("PATH", "")
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(3));
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(
        told.contains("`rustc` is not found") && told.contains("https://rustup.rs"),
        "{told}"
    );
}

#[test]
fn a_cache_that_cannot_be_written_is_named() {
    let folder = Folder::new("read-only");
    folder.write("wiper.kin", WIPER);
    // a file where the folder would be, which even an administrator cannot write into
    let place = folder.write("occupied", "");
    let output = kin(&folder)
        .args(["run", "wiper.kin", "sweep"])
        .env("KIN_CACHE", &place)
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(3));
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(
        told.contains("cannot be written") && told.contains("KIN_CACHE"),
        "{told}"
    );
}

/// The first look at the file lasts until the pipe is closed, and by then another file has its name.
#[cfg(unix)]
#[test]
fn a_change_during_the_first_build_is_seen() {
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
    let start = Instant::now();
    while !server.get("/page").contains("kin 2") {
        assert!(start.elapsed() < Duration::from_secs(20), "the change is not seen");
        std::thread::sleep(Duration::from_millis(100));
    }
}
