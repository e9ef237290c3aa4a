/*
 * The jobs on the Cortex-M4F with the emitted C.
 */
#include "dsp_inputs.h"

#include "bessemer_inline.h"
#include "currents.h"
#include "direct_cascade.h"
#include "fir.h"
#include "models.h"
#include "regulator.h"
#include "transposed_cascade.h"

#include <string.h>

static regulator_t pid;
static currents_t currents;
static currents_t fast_currents;
static memory_t inlined;
static const gains_t gains = {1.5f, -2.0f, 0.75f};
static section_t sections[SECTIONS];
static direct_cascade_t direct;
static transposed_cascade_t transposed;
static fir_t fir;
static float taps[TAPS];
static float block[BLOCK];
static float output[BLOCK];
static float first[20 * 20];
static float second[12 * 12];
static float result[12 * 12];
static option_cholesky_factor_f32_12_t factor;
static solve_f32_8_work_t work_8;
static solve_f32_20_work_t work_20;

/* Functions inlined in their caller, which has every argument in a register. */
static void __attribute__((noinline)) run_inlined_step(void)
{
    for (size_t i = 0; i < PERIODS; i++) {
        const float error = unknown(1.0f - 0.25f * (float)i);
        bench_begin();
        const float out = memory_advance(&inlined, &gains, error);
        computed(out);
        bench_end();
        report(&out, 1);
    }
}

static void __attribute__((noinline)) run_inlined_transforms(void)
{
    const float a = unknown(0.5f);
    const float b = unknown(-0.25f);
    const float sine = unknown(0.6f);
    const float cosine = unknown(0.8f);
    float turned[2];
    bench_begin();
    models_transformed(a, b, sine, cosine, turned);
    const float direct = turned[0];
    const float quadrature = turned[1];
    computed(direct);
    computed(quadrature);
    bench_end();
    report(&direct, 1);
    report(&quadrature, 1);
}

static void run_blocks(void)
{
    float coefficients[5 * SECTIONS];
    fill_sections(coefficients);
    (void)memcpy(sections, coefficients, sizeof sections);
    fill(block, BLOCK, 1U);
    bench_begin();
    direct_cascade_filter(&direct, sections, block);
    bench_end();
    report(block, BLOCK);

    fill(block, BLOCK, 1U);
    bench_begin();
    transposed_cascade_filter(&transposed, sections, block);
    bench_end();
    report(block, BLOCK);

    fill(block, BLOCK, 1U);
    fill(taps, TAPS, 2U);
    bench_begin();
    fir_filter(&fir, taps, block, output);
    bench_end();
    report(output, BLOCK);
}

static void run_systems(void)
{
    static const size_t sizes[] = {4, 8, 20};
    for (size_t i = 0; i < 3; i++) {
        const size_t n = sizes[i];
        fill_matrix(first, n, 5U, 0);
        fill(block, n, 6U);
        bench_begin();
        switch (n) {
        case 4:
            models_solved_4(first, block, output);
            break;
        case 8:
            models_solved_8(first, block, &work_8, output);
            break;
        default:
            models_solved_20(first, block, &work_20, output);
            break;
        }
        bench_end();
        report(output, n);

        bench_begin();
        switch (n) {
        case 4:
            (void)models_into_4(first, block);
            break;
        case 8:
            (void)models_into_8(first, block, &work_8);
            break;
        default:
            (void)models_into_20(first, block, &work_20);
            break;
        }
        bench_end();
        report(block, n);
    }
}

static void run_elementary(void)
{
    bench_begin();
    const float angle = models_angle(0.7f, -0.4f);
    bench_end();
    report(&angle, 1);
    bench_begin();
    const float fast_angle = models_angle_fast(0.7f, -0.4f);
    bench_end();
    report(&fast_angle, 1);
    bench_begin();
    const float power = models_power(0.7f);
    bench_end();
    report(&power, 1);
    bench_begin();
    const float fast_power = models_power_fast(0.7f);
    bench_end();
    report(&fast_power, 1);
}

void run_jobs(void)
{
    for (size_t i = 0; i < PERIODS; i++) {
        const float error = 1.0f - 0.25f * (float)i;
        bench_begin();
        const float out = regulator_step(&pid, &gains, error);
        bench_end();
        report(&out, 1);
    }
    run_inlined_step();
    run_blocks();

    bench_begin();
    models_clarke_park(0.5f, -0.25f, 0.6f, 0.8f, output);
    bench_end();
    report(output, 2);
    run_inlined_transforms();
    bench_begin();
    models_clarke_park_at(0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 2);
    bench_begin();
    models_clarke_park_fast(0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 2);
    const float wanted[2] = {0.25f, 1.5f};
    bench_begin();
    currents_step(&currents, &gains, wanted, 0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 3);
    bench_begin();
    currents_step_fast(&fast_currents, &gains, wanted, 0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 3);

    bench_begin();
    const float sine = models_sine(0.7f);
    bench_end();
    report(&sine, 1);
    bench_begin();
    const float fast = models_sine_fast(0.7f);
    bench_end();
    report(&fast, 1);
    run_elementary();

    fill(first, 12 * 12, 3U);
    fill(second, 12 * 12, 4U);
    bench_begin();
    models_product(first, second, result);
    bench_end();
    report(result, 12 * 12);

    fill_matrix(first, 12, 5U, 1);
    fill(block, 12, 6U);
    bench_begin();
    models_definite(first, block, &factor, output);
    bench_end();
    report(output, 12);
    run_systems();
}
