//! Catches panics of a model, which are expected faults, without printing them.
//!
//! Invariant: only the thread that expects a panic is silent; panics of other threads are printed as usual.
//!
//! What it must not know: the meaning of the messages.

use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    static LOOKED_FOR: Cell<bool> = const { Cell::new(false) };
}

/// The result of `call`, or the message of its panic.
///
/// # Errors
/// The message; empty if it is no text.
///
/// ```
/// use bessemer_legs::panics::caught;
///
/// assert_eq!(caught(|| 1 + 1), Ok(2));
/// assert_eq!(caught(|| -> u8 { panic!("of a model") }), Err("of a model".to_owned()));
/// ```
pub fn caught<T>(call: impl FnOnce() -> T) -> Result<T, String> {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |info| {
            if !LOOKED_FOR.get() {
                before(info);
            }
        }));
    });
    let outer = LOOKED_FOR.replace(true);
    let outcome = catch_unwind(AssertUnwindSafe(call));
    LOOKED_FOR.set(outer);
    outcome.map_err(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        text.or(panic.downcast_ref::<&str>().copied()).unwrap_or_default().to_owned()
    })
}
