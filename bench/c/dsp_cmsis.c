/*
 * The jobs on the Cortex-M4F with CMSIS-DSP, whose folder the caller names.
 */
#include "dsp_inputs.h"

#include "arm_math.h"

#include <string.h>

/* Neither inlined nor specialised for the constants of a call, as a function of a library of its own. */
#define ALONE __attribute__((noipa))

static arm_pid_instance_f32 pid = {.A0 = 1.5f, .A1 = -2.0f, .A2 = 0.75f};
static arm_pid_instance_f32 inlined = {.A0 = 1.5f, .A1 = -2.0f, .A2 = 0.75f};
static float coefficients[5 * SECTIONS];
static float states[4 * SECTIONS];
static float taps[TAPS];
static float line[BLOCK + TAPS - 1];
static float block[BLOCK];
static float output[BLOCK];
static float first[12 * 12];
static float second[12 * 12];
static float result[12 * 12];
static float halfway[12];

ALONE static float pid_step(float error)
{
    return arm_pid_f32(&pid, error);
}

static inline void transformed(float a, float b, float sine, float cosine, float out[2])
{
    float alpha = 0.0f;
    float beta = 0.0f;
    arm_clarke_f32(a, b, &alpha, &beta);
    arm_park_f32(alpha, beta, &out[0], &out[1], sine, cosine);
}

ALONE static void clarke_park(
    float a, float b, float sine, float cosine, float out[2])
{
    transformed(a, b, sine, cosine, out);
}

ALONE static void clarke_park_at(float a, float b, float angle, float out[2])
{
    clarke_park(a, b, arm_sin_f32(angle), arm_cos_f32(angle), out);
}

typedef struct {
    arm_pid_instance_f32 direct;
    arm_pid_instance_f32 quadrature;
} currents_t;

#define GAINS {.A0 = 1.5f, .A1 = -2.0f, .A2 = 0.75f}
static currents_t currents[2] = {{GAINS, GAINS}, {GAINS, GAINS}};

ALONE static void currents_step(
    currents_t *it, const float wanted[2], float a, float b, float angle, float out[3])
{
    const float sine = arm_sin_f32(angle);
    const float cosine = arm_cos_f32(angle);
    float current[2];
    transformed(a, b, sine, cosine, current);
    const float d = arm_pid_f32(&it->direct, wanted[0] - current[0]);
    const float q = arm_pid_f32(&it->quadrature, wanted[1] - current[1]);
    float alpha = 0.0f;
    float beta = 0.0f;
    arm_inv_park_f32(d, q, &alpha, &beta, sine, cosine);
    arm_inv_clarke_f32(alpha, beta, &out[0], &out[1]);
    out[2] = -out[0] - out[1];
}

/* Functions inlined in their caller, which has every argument in a register. */
static void __attribute__((noinline)) run_inlined_step(void)
{
    for (size_t i = 0; i < PERIODS; i++) {
        const float error = unknown(1.0f - 0.25f * (float)i);
        bench_begin();
        const float out = arm_pid_f32(&inlined, error);
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
    transformed(a, b, sine, cosine, turned);
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
    fill_sections(coefficients);
    arm_biquad_casd_df1_inst_f32 direct;
    arm_biquad_cascade_df1_init_f32(&direct, SECTIONS, coefficients, states);
    fill(block, BLOCK, 1U);
    bench_begin();
    arm_biquad_cascade_df1_f32(&direct, block, block, BLOCK);
    bench_end();
    report(block, BLOCK);

    arm_biquad_cascade_df2T_instance_f32 transposed;
    arm_biquad_cascade_df2T_init_f32(&transposed, SECTIONS, coefficients, states);
    fill(block, BLOCK, 1U);
    bench_begin();
    arm_biquad_cascade_df2T_f32(&transposed, block, block, BLOCK);
    bench_end();
    report(block, BLOCK);

    arm_fir_instance_f32 fir;
    fill(block, BLOCK, 1U);
    fill(taps, TAPS, 2U);
    arm_fir_init_f32(&fir, TAPS, taps, line, BLOCK);
    bench_begin();
    arm_fir_f32(&fir, block, output, BLOCK);
    bench_end();
    report(output, BLOCK);
}

/* Both triangles: the factor's transpose is the second. */
ALONE static void definite(void)
{
    float lower[12 * 12] = {0};
    float upper[12 * 12];
    arm_matrix_instance_f32 a = {12, 12, first};
    arm_matrix_instance_f32 l = {12, 12, lower};
    arm_matrix_instance_f32 u = {12, 12, upper};
    arm_matrix_instance_f32 b = {12, 1, block};
    arm_matrix_instance_f32 y = {12, 1, halfway};
    arm_matrix_instance_f32 x = {12, 1, output};
    (void)arm_mat_cholesky_f32(&a, &l);
    (void)arm_mat_solve_lower_triangular_f32(&l, &b, &y);
    (void)arm_mat_trans_f32(&l, &u);
    (void)arm_mat_solve_upper_triangular_f32(&u, &y, &x);
}

/* Both forms have one peer. The library's exponential is newlib's for each element of a vector. */
static void run_elementary(void)
{
    for (size_t i = 0; i < 2; i++) {
        float angle = 0.0f;
        bench_begin();
        (void)arm_atan2_f32(0.7f, -0.4f, &angle);
        bench_end();
        report(&angle, 1);
    }
    const float exponent = 0.7f;
    for (size_t i = 0; i < 2; i++) {
        float power = 0.0f;
        bench_begin();
        arm_vexp_f32(&exponent, &power, 1);
        bench_end();
        report(&power, 1);
    }
}

/* Its matrices are by rows: a product of the transposes has the factors exchanged. */
void run_jobs(void)
{
    for (size_t i = 0; i < PERIODS; i++) {
        const float error = 1.0f - 0.25f * (float)i;
        bench_begin();
        const float out = pid_step(error);
        bench_end();
        report(&out, 1);
    }
    run_inlined_step();
    run_blocks();

    bench_begin();
    clarke_park(0.5f, -0.25f, 0.6f, 0.8f, output);
    bench_end();
    report(output, 2);
    run_inlined_transforms();
    bench_begin();
    clarke_park_at(0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 2);
    bench_begin();
    clarke_park_at(0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 2);

    const float wanted[2] = {0.25f, 1.5f};
    bench_begin();
    currents_step(&currents[0], wanted, 0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 3);
    bench_begin();
    currents_step(&currents[1], wanted, 0.5f, -0.25f, 0.7f, output);
    bench_end();
    report(output, 3);

    bench_begin();
    const float sine = arm_sin_f32(0.7f);
    bench_end();
    report(&sine, 1);
    bench_begin();
    const float fast = arm_sin_f32(0.7f);
    bench_end();
    report(&fast, 1);
    run_elementary();

    fill(first, 12 * 12, 3U);
    fill(second, 12 * 12, 4U);
    const arm_matrix_instance_f32 a = {12, 12, second};
    const arm_matrix_instance_f32 b = {12, 12, first};
    arm_matrix_instance_f32 c = {12, 12, result};
    bench_begin();
    (void)arm_mat_mult_f32(&a, &b, &c);
    bench_end();
    report(result, 12 * 12);

    fill_matrix(first, 12, 5U, 1);
    fill(block, 12, 6U);
    bench_begin();
    definite();
    bench_end();
    report(output, 12);
}
