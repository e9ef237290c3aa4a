/* The C of tests/corpus/src/programs/matrices/component_wise.rs. Written by a test. */

/* component_wise.c */

void component_wise_blended(const float a[6], const float b[6], const float mask[6],
    float result[BESSEMER_RESTRICT 6])
{
    BESSEMER_FEW_PASSES
    for (uint32_t i = 0U; i < 6U; i++) {
        result[i] = a[i] + (b[i] - a[i]) * mask[i];
    }
}
