//! The kinds of vectors that products are written for.

/// A kind of vectors.
pub(super) struct Target {
    /// Preprocessor condition of the target.
    pub condition: &'static str,
    /// Further comment on the target.
    pub text: &'static str,
    /// True if they are for `f32` alone.
    pub single: bool,
    /// Bytes of the widest.
    pub widest: u32,
    /// Number of registers.
    pub registers: u32,
    /// Instructions to multiply and add.
    pub step: u32,
    /// Quarters of an instruction to have a number in each lane.
    pub spread: u32,
    /// Bytes of code that a loop over terms may take; more of them written out take no less time.
    pub room: u32,
    /// True if a row that fills no vector uses scalars. They must multiply from memory, since without spare registers
    /// another vector is slower.
    pub alone: bool,
}

/// The widest first. Those of 64 bytes cross a line of the cache wherever a column does not begin at one; on a processor
/// whose units are as wide (Zen 5) they take 0.4 to 0.8 of the time of those of 32 from 8 rows on all the same. A last row by
/// numbers takes 1.15 times as long there as one more vector, and a loop over four terms no longer than all written
/// out. NEON flushes subnormals to zero, so it is there for those only who say that
/// they do not mind; its multiplication with addition rounds twice, as C's.
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
