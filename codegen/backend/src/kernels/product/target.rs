//! Kinds of vectors for which products have variants.

/// A kind of vectors.
pub(super) struct Target {
    /// Preprocessor condition of the target.
    pub condition: &'static str,
    /// Further comment on the target.
    pub text: &'static str,
    /// True if the vectors are for `f32` only.
    pub single: bool,
    /// Width of the widest vector, bytes.
    pub widest: u32,
    /// Number of registers.
    pub registers: u32,
    /// Number of instructions for a multiplication and an addition.
    pub step: u32,
    /// Four times the number of instructions that copy one number to all lanes of a vector.
    pub spread: u32,
    /// Largest code size of a loop over terms, bytes; more unrolling gains nothing.
    pub room: u32,
    /// True if a row that fills no vector uses scalars. They must multiply from memory, since without spare registers
    /// another vector is slower.
    pub alone: bool,
}

/// Targets, the widest vectors first. Vectors of 64 bytes cross a cache line unless a column begins at one. Still, on
/// a processor with units that wide (Zen 5) they take 0.4 to 0.8 of the time of 32 bytes, from 8 rows on. There a
/// last row in scalars takes 1.15 times as long as another vector, and a loop over four terms no longer than all
/// written out. NEON flushes subnormals to zero, so it is used only on request; its multiply-add rounds twice, as C's
/// does.
pub(super) const TARGETS: [Target; 4] = [
    Target {
        condition: "defined(__AVX512F__)",
        text: "",
        single: false,
        widest: 64,
        registers: 32,
        step: 2,
        spread: 2,
        room: 4 * 1024,
        alone: false,
    },
    Target {
        condition: "defined(__AVX__)",
        text: "",
        single: false,
        widest: 32,
        registers: 16,
        step: 2,
        spread: 4,
        room: u32::MAX,
        alone: true,
    },
    Target {
        condition: "defined(__SSE2__)",
        text: "",
        single: false,
        widest: 16,
        registers: 16,
        step: 3,
        spread: 8,
        room: u32::MAX,
        alone: false,
    },
    Target {
        condition: "defined(__ARM_NEON) && defined(BESSEMER_NEON_F32)",
        text: NEON,
        single: true,
        widest: 16,
        registers: 16,
        step: 1,
        spread: 4,
        room: u32::MAX,
        alone: false,
    },
];

const NEON: &str = r#"#include <arm_neon.h>
#define TIMES(rows, number) vmulq_n_f32((float32x4_t)(rows), (number))
#define PLUS(sum, rows, number) vmlaq_n_f32((float32x4_t)(sum), (float32x4_t)(rows), (number))
#define IN_ITS_REGISTER(value) __asm__("" : "+w"(value))
"#;
