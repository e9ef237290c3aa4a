/*
 * Wrappers of the library's operations of doubles, linked with `--wrap`. They note a subnormal operand or result.
 */
#include <stdint.h>
#include <string.h>

extern int subnormal_seen;
int subnormal_seen = 0;

static void note(double value)
{
    uint64_t word;
    (void)memcpy(&word, &value, sizeof(word));
    if (((word >> 52) & 0x7FFU) == 0U && (word << 12) != 0U) {
        subnormal_seen = 1;
    }
}

/* The compiler's own functions take doubles in integer registers. */
#define OWN __attribute__((pcs("aapcs")))

#define OF_TWO(name) \
    extern OWN double __real_##name(double x, double y); \
    extern OWN double __wrap_##name(double x, double y); \
    OWN double __wrap_##name(double x, double y) \
    { \
        const double result = __real_##name(x, y); \
        note(x); \
        note(y); \
        note(result); \
        return result; \
    }

#define OF_ONE(kind, type, name) \
    extern kind type __real_##name(double x); \
    extern kind type __wrap_##name(double x); \
    kind type __wrap_##name(double x) \
    { \
        note(x); \
        return __real_##name(x); \
    }

OF_TWO(__aeabi_dadd)
OF_TWO(__aeabi_dsub)
OF_TWO(__aeabi_dmul)
OF_TWO(__aeabi_ddiv)
OF_ONE(, double, sqrt)
OF_ONE(OWN, uint64_t, __aeabi_d2ulz)
OF_ONE(OWN, int64_t, __aeabi_d2lz)
