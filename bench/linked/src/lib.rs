//! The flight software as rustc compiles it, with functions for C and for hosts of WebAssembly. They advance the onboard software
//! and the height control by one period.
//!
//! A caller has memory of [`linked_size`] bytes, aligned to 8. It writes the words of settings and inputs to
//! [`linked_words`], calls the functions in their order here, and reads the words of the results from the same place.

#![cfg_attr(not(target_os = "linux"), no_std)]

use core::mem::MaybeUninit;
#[cfg(not(target_os = "linux"))]
use core::panic::PanicInfo;
#[cfg(target_family = "wasm")]
use core::sync::atomic::AtomicU64;

use bessemer::Plain;
use models::{Height, Inputs, Onboard, Outputs, Settings};

/// Number of words of the arguments, and of the results.
const WORDS: (usize, usize) =
    (Settings::WORDS + Inputs::WORDS, Outputs::WORDS + Onboard::WORDS + Height::WORDS + f64::WORDS);

/// Most words of the two.
const MOST: usize = if WORDS.0 > WORDS.1 { WORDS.0 } else { WORDS.1 };

/// Memory of the caller.
#[derive(Debug)]
pub struct Linked {
    onboard: Onboard,
    settings: Settings,
    inputs: Inputs,
    outputs: Outputs,
    height: Height,
    thrust: f64,
    words: [u64; MOST],
}

/// Returns the size of [`Linked`].
#[unsafe(no_mangle)]
pub extern "C" fn linked_size() -> usize {
    size_of::<Linked>()
}

/// Memory for a host of WebAssembly, which knows none that is free.
#[cfg(target_family = "wasm")]
static MEMORY: [AtomicU64; size_of::<Linked>().div_ceil(8)] =
    [const { AtomicU64::new(0) }; size_of::<Linked>().div_ceil(8)];

/// Returns the address of memory for a [`Linked`].
#[cfg(target_family = "wasm")]
#[unsafe(no_mangle)]
pub extern "C" fn linked_memory() -> *const AtomicU64 {
    MEMORY.as_ptr()
}

/// Sets the state before the first period.
#[unsafe(no_mangle)]
pub extern "C" fn linked_init(linked: &mut MaybeUninit<Linked>) {
    linked.write(Linked {
        onboard: Onboard::default(),
        settings: Settings::default(),
        inputs: Inputs::default(),
        outputs: Outputs::default(),
        height: Height::default(),
        thrust: 0.0,
        words: [0; MOST],
    });
}

/// Returns the address of the words.
#[unsafe(no_mangle)]
pub extern "C" fn linked_words(linked: &mut Linked) -> *mut u64 {
    linked.words.as_mut_ptr()
}

/// Returns the number of words of settings and inputs.
#[unsafe(no_mangle)]
pub extern "C" fn linked_arguments() -> usize {
    WORDS.0
}

/// Returns the number of words of the results.
#[unsafe(no_mangle)]
pub extern "C" fn linked_results() -> usize {
    WORDS.1
}

/// Reads settings and inputs from the words.
#[unsafe(no_mangle)]
pub extern "C" fn linked_take(linked: &mut Linked) {
    let mut words = linked.words.iter().copied();
    let mut next = || words.next().unwrap_or_default();
    linked.settings = Settings::load(&mut next);
    linked.inputs = Inputs::load(&mut next);
}

/// Advances the onboard software by one period.
#[unsafe(no_mangle)]
pub extern "C" fn linked_step(linked: &mut Linked) {
    linked.outputs = linked.onboard.step(&linked.settings, &linked.inputs);
}

/// Advances the height control by one period, from the estimate and the target of [`linked_step`].
#[unsafe(no_mangle)]
pub extern "C" fn linked_height(linked: &mut Linked) {
    let Linked { height, settings, outputs, .. } = linked;
    let (parameters, target) = (&settings.parameters, &outputs.reference.target);
    let estimate = &outputs.estimate;
    linked.thrust = height.step(parameters, target, estimate.position.z, estimate.velocity.z);
}

/// Writes outputs, states and thrust to the words.
#[unsafe(no_mangle)]
pub extern "C" fn linked_give(linked: &mut Linked) {
    let Linked { onboard, outputs, height, thrust, words, .. } = linked;
    let mut places = words.iter_mut();
    let mut put = |word| places.by_ref().take(1).for_each(|place| *place = word);
    outputs.store(&mut put);
    onboard.store(&mut put);
    height.store(&mut put);
    thrust.store(&mut put);
}

/// Stops: a fault of the flight software, which the comparison of words then shows.
#[cfg(not(target_os = "linux"))]
#[panic_handler]
fn panicked(_: &PanicInfo) -> ! {
    loop {}
}
