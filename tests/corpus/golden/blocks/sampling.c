/* The C of tests/corpus/src/programs/blocks/sampling.rs. Written by a test. */

/* converter.c */

static const float TAPS[5] = {0.1F, 0.2F, 0.4F, 0.2F, 0.1F};

void converter_init(converter_t *self)
{
    fir_f32_5_init(&self->fir);
    decimator_f32_5_init(&self->decimator);
    moving_f32_8_init(&self->noise);
}

void converter_step(converter_t *BESSEMER_RESTRICT self, float sample,
    option_f32_t *BESSEMER_RESTRICT result)
{
    const float smooth = fir_f32_5_step(&self->fir, TAPS, sample);
    decimator_f32_5_step(&self->decimator, TAPS, 4U, smooth, result);
}

void converter_noise(converter_t *BESSEMER_RESTRICT self, float sample,
    spread_f32_t *BESSEMER_RESTRICT spread)
{
    moving_f32_8_spread(&self->noise, sample, spread);
}

/* converter.h */

/** Smooths samples, and reports one in four. */
typedef struct {
    fir_f32_5_t fir;
    decimator_f32_5_t decimator;
    moving_f32_8_t noise;
} converter_t;

/* meter.c */

void meter_init(meter_t *self)
{
    integrator_f64_init(&self->energy);
    derivative_f64_init(&self->slope);
    moving_f64_3_init(&self->mean);
}

void meter_step(meter_t *BESSEMER_RESTRICT self, const integrator_parameters_f64_t *parameters,
    double power, bool reset, double result[BESSEMER_RESTRICT 3])
{
    if (reset) {
        integrator_f64_reset(&self->energy, 0.0);
    }
    const double result_step = integrator_f64_step(&self->energy, parameters, power);
    const double result_step_2 = derivative_f64_step(&self->slope, 0.05, parameters->period, power);
    const double result_average = moving_f64_3_average(&self->mean, power);
    result[0] = result_step;
    result[1] = result_step_2;
    result[2] = result_average;
}

/* meter.h */

/** Energy and power of a load. */
typedef struct {
    integrator_f64_t energy;
    derivative_f64_t slope;
    moving_f64_3_t mean;
} meter_t;
