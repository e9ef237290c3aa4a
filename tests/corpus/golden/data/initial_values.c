/* The C of tests/corpus/src/programs/data/initial_values.rs. Written by a test. */

/* lowpass.c */

void lowpass_init(lowpass_t *self)
{
    /* In Rust: `1.0 / 8.0`. */
    self->share = 0.125;
    self->value = 0.0;
    self->started = false;
}

double lowpass_step(lowpass_t *self, double value)
{
    if (!self->started) {
        self->started = true;
        self->value = value;
    }
    self->value += self->share * (value - self->value);
    return self->value;
}

/* lowpass.h */

/** A first-order low-pass. */
typedef struct {
    /** Weight of a new value. */
    double share;
    /** The smoothed value. */
    double value;
    /** True after the first value. */
    bool started;
} lowpass_t;
