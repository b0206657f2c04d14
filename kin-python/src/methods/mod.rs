//! What Python calls on classes that make objects of many others. A class itself stands below those that hold it.

mod linkage;
mod mechanism;
mod sweep;
