#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FoundUnreadDefaultOwn { pub low: u8 }
#[function]
pub fn found_unread_default(x: f64) -> i8 {
let mut a: FoundUnreadDefaultOwn = FoundUnreadDefaultOwn::default();
('l1: {
a = (if Ok::<SMatrix<u8, 3, 1>, u16>(SMatrix::<u8, 3, 1>::zeros()).is_ok_and(|mut length| (a != a)) { a } else { a });
(x as i8) })
}
