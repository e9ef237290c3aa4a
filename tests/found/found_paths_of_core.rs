// Functions of types by their whole paths.
use core::num::NonZeroU32;
#[function]
pub fn found_paths_of_core(x: u32) -> u32 { NonZeroU32::new(x).map_or(1, |n| n.get() / 2) }
#[function]
pub fn found_paths_of_core_2(x: u32) -> u32 { core::num::NonZeroU32::new(x).map_or(1, |n| n.get() / 2) }
#[function]
pub fn found_paths_of_core_3(x: u32) -> u32 { Some(x).and_then(core::num::NonZeroU32::new).map_or(1, |n| n.get() / 2) }
#[function]
pub fn found_paths_of_core_4(a: u8, b: u8) -> bool { core::cmp::Ordering::is_lt(a.cmp(&b)) }
