/* The C of tests/corpus/src/programs/functions/multi_rate.rs. Written by a test. */

/* smoother.c */

void smoother_init(smoother_t *self)
{
    self->level = 0.0;
}

double smoother_step(smoother_t *self, double value, double share)
{
    self->level += share * (value - self->level);
    return self->level;
}

/* smoother.h */

/** A first-order filter. */
typedef struct {
    double level;
} smoother_t;

/* two_rates.c */

static const uint8_t TWO_RATES_DIVIDER = 4U;

void two_rates_init(two_rates_t *self)
{
    smoother_init(&self->fast);
    smoother_init(&self->slow);
    self->wanted = 0.0;
    self->tick = 0U;
}

double two_rates_step(two_rates_t *self, double target, double angle, double rate)
{
    if (self->tick == 0U) {
        const double wanted_step = smoother_step(&self->slow, target - angle, 0.5);
        self->wanted = 4.0 * wanted_step;
    }
    self->tick = (uint8_t)((uint8_t)((uint32_t)self->tick + 1U) % TWO_RATES_DIVIDER);
    return smoother_step(&self->fast, self->wanted - rate, 0.8);
}

/* two_rates.h */

/** A rate loop at 200 Hz with an angle loop at 50 Hz around it. */
typedef struct {
    smoother_t fast;
    smoother_t slow;
    double wanted;
    uint8_t tick;
} two_rates_t;
