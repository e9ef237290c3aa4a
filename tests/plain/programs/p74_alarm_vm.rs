//! Stack machine for configurable alarm expressions stored as byte code.

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VmError {
    UnknownOpcode(u8),
    TruncatedCode,
    StackOverflow,
    StackUnderflow,
    NoSuchInput(u8),
    DivisionByZero,
    /// More or less than one value was left on the stack.
    Unbalanced,
}

enum Op {
    Push(i16),
    Input(u8),
    /// Jumps forward if the top is zero, else drops it: short-circuit "and".
    SkipIfFalse(u8),
    Not,
    Abs,
    Binary(Binary),
}

enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Greater,
}

impl Binary {
    fn apply(self, a: i32, b: i32) -> Result<i32, VmError> {
        Ok(match self {
            Self::Add => a.saturating_add(b),
            Self::Sub => a.saturating_sub(b),
            Self::Mul => a.saturating_mul(b),
            Self::Div if b == 0 => return Err(VmError::DivisionByZero),
            Self::Div => a.saturating_div(b),
            Self::Greater => (a > b).into(),
        })
    }
}

struct Reader<'c>(&'c [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], VmError> {
        let (head, rest) = self.0.split_first_chunk().ok_or(VmError::TruncatedCode)?;
        self.0 = rest;
        Ok(*head)
    }

    fn jump(&mut self, distance: u8) -> Result<(), VmError> {
        self.0 = self.0.get(distance.into()..).ok_or(VmError::TruncatedCode)?;
        Ok(())
    }

    fn op(&mut self) -> Result<Op, VmError> {
        let [opcode] = self.take()?;
        Ok(match opcode {
            0x01 => Op::Push(i16::from_le_bytes(self.take()?)),
            0x02 => Op::Input(u8::from_le_bytes(self.take()?)),
            0x03 => Op::SkipIfFalse(u8::from_le_bytes(self.take()?)),
            0x04 => Op::Not,
            0x05 => Op::Abs,
            0x10 => Op::Binary(Binary::Add),
            0x11 => Op::Binary(Binary::Sub),
            0x12 => Op::Binary(Binary::Mul),
            0x13 => Op::Binary(Binary::Div),
            0x14 => Op::Binary(Binary::Greater),
            other => return Err(VmError::UnknownOpcode(other)),
        })
    }
}

impl Iterator for Reader<'_> {
    type Item = Result<Op, VmError>;

    fn next(&mut self) -> Option<Self::Item> {
        (!self.0.is_empty()).then(|| self.op())
    }
}

#[derive(Default)]
struct Stack {
    values: [i32; 8],
    depth: usize,
}

impl Stack {
    fn push(&mut self, value: i32) -> Result<(), VmError> {
        *self.values.get_mut(self.depth).ok_or(VmError::StackOverflow)? = value;
        self.depth += 1;
        Ok(())
    }

    fn pop(&mut self) -> Result<i32, VmError> {
        self.depth = self.depth.checked_sub(1).ok_or(VmError::StackUnderflow)?;
        Ok(self.values[self.depth])
    }
}

/// An expression whose instructions are known to decode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expression<'c> {
    code: &'c [u8],
}

impl<'c> TryFrom<&'c [u8]> for Expression<'c> {
    type Error = VmError;

    fn try_from(code: &'c [u8]) -> Result<Self, VmError> {
        Reader(code).try_for_each(|op| op.map(drop))?;
        Ok(Self { code })
    }
}

impl Expression<'_> {
    pub fn evaluate(&self, inputs: &[i32]) -> Result<i32, VmError> {
        let mut stack = Stack::default();
        let mut code = Reader(self.code);

        while let Some(op) = code.next() {
            let result = match op? {
                Op::Push(value) => value.into(),
                Op::Input(n) => *inputs.get(usize::from(n)).ok_or(VmError::NoSuchInput(n))?,
                Op::Not => (stack.pop()? == 0).into(),
                Op::Abs => stack.pop()?.saturating_abs(),
                Op::Binary(op) => {
                    let (b, a) = (stack.pop()?, stack.pop()?);
                    op.apply(a, b)?
                }
                Op::SkipIfFalse(distance) => {
                    if stack.pop()? != 0 {
                        continue;
                    }
                    code.jump(distance)?;
                    0
                }
            };
            stack.push(result)?;
        }
        match stack.values[..stack.depth] {
            [result] => Ok(result),
            _ => Err(VmError::Unbalanced),
        }
    }
}
