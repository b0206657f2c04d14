//! The lists of the rooms.

/// A crate and its rooms.
pub(crate) struct House {
    pub(crate) name: &'static str,
    /// Its source, from the root of the repository.
    pub(crate) source: &'static str,
    /// The files that may name any room.
    pub(crate) faces: &'static [&'static str],
    /// Items that stand at the root of the crate, and are no re-exports.
    pub(crate) root_items: &'static [&'static str],
    /// From the lowest to the highest.
    pub(crate) rooms: &'static [Room],
    /// Arrows that run up all the same.
    pub(crate) known: &'static [(&'static str, &'static str)],
    /// Rooms that are larger than they should be.
    pub(crate) large: &'static [&'static str],
}

/// A part of a crate.
pub(crate) struct Room {
    pub(crate) name: &'static str,
    /// Its content, in a few words.
    pub(crate) holds: &'static str,
    /// Its files; a folder ends in a slash.
    pub(crate) files: &'static [&'static str],
}

impl Room {
    /// Whether a file is in the room.
    pub(crate) fn owns(&self, file: &str) -> bool {
        let holds = |own: &&str| file == *own || (own.ends_with('/') && file.starts_with(*own));
        self.files.iter().any(holds)
    }
}

const fn room(name: &'static str, files: &'static [&'static str], holds: &'static str) -> Room {
    Room { name, holds, files }
}

pub(crate) const CORE: House = House {
    name: "kin-core",
    source: "kin-core/src",
    faces: &["lib.rs", "prelude.rs", "private.rs"],
    root_items: &["storable", "each_library_mechanism", "__debug_by_display"],
    rooms: &[
        room("number", &["number/"], "numbers and rows"),
        room("geometry", &["geometry/"], "vectors and rotations"),
        room("quantity", &["quantity/"], "names, dimensions"),
        room("failure", &["failure/"], "typed errors"),
        room("assembly", &["assembly/"], "open, crossed, near"),
        room("solve", &["solve/"], "closed forms, Newton"),
        room("motion", &["motion/"], "values with rates"),
        room("hermite", &["hermite/"], "pieces of curves"),
        room("law", &["law/"], "motion laws"),
        room("picture", &["picture/"], "skeletons, angles"),
        room("mechanism", &["mechanism/"], "traits of mechanisms"),
        room("any", &["any.rs"], "without their types"),
        room("assemblies", &["assemblies/"], "all positions"),
        room("curve", &["curve/"], "positions over a line"),
        room("track", &["track/"], "from pose to pose"),
        room("load", &["load/"], "efforts, energies"),
        room("batch", &["batch/"], "columns, in lanes"),
        room("sweep", &["sweep/"], "sweeps, tables"),
        room("extremes", &["extremes/"], "peaks, means"),
        room("cycle", &["cycle/"], "circuits, branches"),
        room("tape", &["tape/"], "solvers as data"),
        room("exact", &["exact/"], "exact tables"),
        room("linkage", &["linkage/"], "answers, without types"),
        room("stored", &["stored/"], "traits of serde"),
        room("interop", &["interop/"], "other crates' types"),
        room("verify", &["verify/"], "two oracles"),
        room("library", &["library/"], "declared mechanisms"),
        room("editor", &["editor.rs"], "names for editors"),
    ],
    known: &[],
    large: &[],
};

pub(crate) const MACROS: House = House {
    name: "kin-macros",
    source: "kin-macros/src",
    faces: &["lib.rs"],
    root_items: &[],
    rooms: &[
        room("work", &["work.rs", "room.rs"], "counted work, stack"),
        room("mistakes", &["mistakes.rs"], "messages at places"),
        room("precedence", &["precedence.rs"], "parentheses"),
        room("algebra", &["algebra/"], "graph, functions"),
        room("syntax", &["syntax/"], "tokens to tree"),
        room("model", &["model/"], "names, dimensions"),
        room("structure", &["structure/"], "blocks and parts"),
        room("formulas", &["formulas/"], "text, MathML, LaTeX"),
        room("passes", &["passes.rs"], "switches for tests"),
        room("program", &["program/"], "the middle language"),
        room("refuse", &["refuse.rs"], "what has no solution"),
        room("derive", &["derive/"], "rates, Jacobians"),
        room("assemble", &["assemble/"], "steps of positions"),
        room("schedule", &["schedule/"], "straight-line code"),
        room("plan", &["plan/"], "the cheapest way"),
        room("translate", &["translate/"], "closure, skeleton"),
        room("emit", &["emit/"], "Rust, item by item"),
        room("editor", &["editor.rs"], "names for editors"),
        room("fallback", &["fallback.rs"], "stand-ins"),
        room("expand", &["expand.rs"], "the pipeline"),
        room("bug", &["bug.rs"], "the net for panics"),
    ],
    known: &[],
    large: &[],
};

/// Names that both crates give to one thing: kin-core to the thing itself, kin-macros to what it knows of it.
pub(crate) const OF_BOTH_CRATES: &[&str] = &[
    "Block",
    "BlockForm",
    "Body",
    "Dimension",
    "Formula",
    "Formulas",
    "Outline",
    "PolynomialSystem",
    "Slide",
];

/// Names of which one crate has several declarations, each with the reason.
pub(crate) const SEVERAL_TIMES: &[&str] = &[
    // the carrier of derivatives, with the feature `num-dual` and without it
    "ThroughSnap",
    // the words of a declaration, as an editor explains them
    "Quantity",
];
