//! The files of the page, built by npm from `ground/web`. They are part of the program, so that it needs no other
//! files and no internet.

/// Name, kind and content of each file.
const FILES: &[(&str, &str, &[u8])] = &[
    ("index.html", "text/html; charset=utf-8", include_bytes!("../page/index.html")),
    ("page.js", "text/javascript; charset=utf-8", include_bytes!("../page/page.js")),
    ("page.css", "text/css; charset=utf-8", include_bytes!("../page/page.css")),
    ("licences.txt", "text/plain; charset=utf-8", include_bytes!("../page/licences.txt")),
];

/// Kind and content of a file.
pub fn file(name: &str) -> Option<(&'static str, &'static [u8])> {
    FILES.iter().find(|(known, ..)| *known == name).map(|(_, kind, content)| (*kind, *content))
}
