
/* What a counter of instructions looks for. */
void bench_begin(void);
void bench_end(void);
__attribute__((noinline)) void bench_begin(void) { __asm__ volatile(""); }
__attribute__((noinline)) void bench_end(void) { __asm__ volatile(""); }

/* The stack below a call is filled with a pattern, and looked at afterwards by a function that stands in the same place. */
#define STACK_WORDS 4096
#define STACK_PAINT 0xA5A5A5A5U

__attribute__((noinline, unused)) static void stack_paint(void)
{
    uint32_t below[STACK_WORDS];
    volatile uint32_t *at = below;
    /* The compiler is not to know what lies there. */
    __asm__ volatile("" : "+r"(at));
    for (int n = 0; n < STACK_WORDS; ++n) {
        at[n] = STACK_PAINT;
    }
}

__attribute__((noinline, unused)) static uint64_t stack_used(void)
{
    uint32_t below[STACK_WORDS];
    volatile uint32_t *at = below;
    __asm__ volatile("" : "+r"(at));
    int n = 0;
    while (n < STACK_WORDS && at[n] == STACK_PAINT) {
        ++n;
    }
    return (uint64_t)(STACK_WORDS - n) * 4U;
}
