// Names that a pattern gives to a number in each of several alternatives, or twice.
#[function]
pub fn found_names_of_numbers_0(y: u8, x: i32) -> i32 {
    let z = match y { x @ 1 | x @ 2 => x as i32, _ => 0 };
    z.wrapping_add(x)
}
#[function]
pub fn found_names_of_numbers_1(y: u8, x: i32) -> i32 {
    let mut n = y % 5;
    match &mut n { x @ &mut 1 | x @ &mut 2 => *x += 7, x @ (&mut 3 | &mut 4) => *x += 9, _ => {} }
    match n { mut x @ 8 | mut x @ 9 => { x += 1; n = x; } x @ (y @ 12) => n = x + y, _ => {} }
    n as i32
}
#[function]
pub fn found_names_of_numbers_2(y: u8, x: i32, q: u8) -> i32 {
    let x = 7u8;
    match q % 5 { z @ (x @ 2) => (x + z) as i32 * 10, x @ 0 | x @ 4 if y & 1 == 0 => x as i32 + 100, x @ (0 | 1) => x as i32 + 200, _ => x as i32 }
}
