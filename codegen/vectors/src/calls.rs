//! Calls.

use bessemer_ir::{Argument, FunctionId};

use crate::body::{Cx, Result};
use crate::place::{Path, picked};

impl Cx<'_> {
    pub(crate) fn call(&self, callee: FunctionId, arguments: &[Argument]) -> Result<String> {
        let mut passed = vec!["m".to_owned()];
        let (mut before, mut after) = (String::new(), String::new());
        for argument in arguments {
            passed.push(match argument {
                Argument::Value(expr) => self.value(expr)?,
                Argument::Ref(expr) => self.reference(expr)?,
                Argument::RefMut(place) if self.is_byte(place) => {
                    return Err(self.error(place.span, "passes a byte by mutable reference"));
                }
                Argument::RefMut(place) => match self.path(place)? {
                    Path::Direct(text) => {
                        match text.strip_prefix("(*").and_then(|it| it.strip_suffix(')')) {
                            Some(name) => name.to_owned(),
                            None => format!("&mut {text}"),
                        }
                    }
                    // An element of each lane is copied, changed, and written back.
                    Path::Selected { array, index, rest } => {
                        let part = format!("part{}", before.matches("let mut").count());
                        let picked = picked(&array, &index, &rest);
                        before.push_str(&format!("let mut {part} = {picked}; "));
                        after.push_str(&format!(
                            "lanes::each(&mut {array}[..], {index}, m, |it, m| it{rest}.assign(m, &{part})); "
                        ));
                        format!("&mut {part}")
                    }
                },
            });
        }
        let call = format!("self::{}({})", self.names.of_function(callee), passed.join(", "));
        Ok(match before.is_empty() {
            true => call,
            false => format!("{{ {before}let value = {call}; {after}value }}"),
        })
    }
}
