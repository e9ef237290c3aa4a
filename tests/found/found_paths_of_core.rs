// {"entries":[{"name":"found_paths_of_core","params":[["","u32"]],"atomic":false,"stops":false},{"name":"found_paths_of_core_2","params":[["","u32"]],"atomic":false,"stops":false},{"name":"found_paths_of_core_3","params":[["","u32"]],"atomic":false,"stops":false},{"name":"found_paths_of_core_4","params":[["","u8"],["","u8"]],"atomic":false,"stops":false}],"instances":null,"unit":null}
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
