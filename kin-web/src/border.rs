//! The functions that JavaScript calls. A question in UTF-8 stands in memory that the caller reserves, and the answer
//! in memory of the module until the next one.

// the names are those of C, and the functions take pointers
#![allow(unsafe_code, unreachable_pub)]

use std::cell::RefCell;

thread_local! {
    static ANSWER: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Memory for a question of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn reserve(length: usize) -> *mut u8 {
    Box::into_raw(vec![0_u8; length].into_boxed_slice()).cast()
}

/// Answers a question, and returns the length of the answer in bytes.
///
/// # Safety
/// `question` comes from [`reserve`] with the same length, and is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ask(question: *mut u8, length: usize) -> usize {
    // SAFETY: `reserve` leaked a slice of this start and length.
    let bytes = unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(question, length)) };
    let answer = crate::question::answer(&String::from_utf8_lossy(&bytes));
    ANSWER.with_borrow_mut(|last| {
        *last = answer;
        last.len()
    })
}

/// The last answer in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn answered() -> *const u8 {
    ANSWER.with_borrow(|last| last.as_ptr())
}
