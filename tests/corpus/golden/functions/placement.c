/* The C of tests/corpus/src/programs/functions/placement.rs. Written by a test. */

/* placement.c */

/* Stands where it is called. Nothing where the compiler is not known. */
#ifndef BESSEMER_ALWAYS_INLINE
#if defined(__GNUC__)
#define BESSEMER_ALWAYS_INLINE __attribute__((always_inline))
#else
#define BESSEMER_ALWAYS_INLINE
#endif
#endif

/* Stands by itself, however often it is called. Nothing where the compiler is not known. */
#ifndef BESSEMER_NEVER_INLINE
#if defined(__GNUC__)
#define BESSEMER_NEVER_INLINE __attribute__((noinline))
#else
#define BESSEMER_NEVER_INLINE
#endif
#endif

/* Stands in a section of its own. Nothing where the compiler is not known. */
#ifndef BESSEMER_SECTION
#if defined(__GNUC__)
#define BESSEMER_SECTION(name) __attribute__((section(name)))
#else
#define BESSEMER_SECTION(name)
#endif
#endif

/** The electric power that is lost, W. */
BESSEMER_ALWAYS_INLINE
static inline float placement_power(float current, float resistance)
{
    return current * current * resistance;
}

BESSEMER_SECTION(".ramfunc") BESSEMER_NEVER_INLINE
float motor_torque(float current, float constant)
{
    return current * constant;
}

void placement_efficiency(float current, float constant, float resistance, option_f32_t *result)
{
    if (current == 0.0F) {
        *result = (option_f32_t){.is_some = false};
        return;
    }
    result->is_some = true;
    result->value = motor_torque(current, constant) / placement_power(current, resistance);
}
