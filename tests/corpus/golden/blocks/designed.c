/* The C of tests/corpus/src/programs/blocks/designed.rs. Written by a test. */

/* cart.c */

static const double GAIN[2] = {29.720190477657685, 5.969414389469317};
static const double INPUT[2] = {9.983354145850682e-5, 0.01995008322927075};
static const double OBSERVER[2] = {0.23351654621556814, 2.652131530853144};
static const section_f64_t SMOOTH[2] = {
    {
        .b0 = 0.13672873599731955,
        .b1 = 0.13672873599731955,
        .b2 = 0.0,
        .a1 = -0.726542528005361,
        .a2 = 0.0
    },
    {
        .b0 = 0.021196675392203188,
        .b1 = 0.042393350784406376,
        .b2 = 0.021196675392203188,
        .a1 = -1.647552215703991,
        .a2 = 0.7323389172728039
    }
};

/** A matrix by columns: [row + 2 * column]. */
static const double TRANSITION[4] = {
    1.0, 0.0,
    0.009975041614635374, 0.9950124791926823
};

void cart_init(cart_t *self)
{
    self->estimate[0] = 0.0;
    self->estimate[1] = 0.0;
    cascade_f64_2_init(&self->smooth);
}

double cart_step(cart_t *self, double target, double measured)
{
    const double innovation = measured - self->estimate[0];
    self->estimate[0] += OBSERVER[0] * innovation;
    self->estimate[1] += OBSERVER[1] * innovation;
    const double wanted = cascade_f64_2_step(&self->smooth, SMOOTH, target);
    const double vector_difference[2] = {wanted - self->estimate[0], 0.0 - self->estimate[1]};
    const double vector[1] = {GAIN[0] * vector_difference[0] + GAIN[1] * vector_difference[1]};
    const double force = vector[0];
    const double estimate_product[2] = {
        TRANSITION[0 + 2 * 0] * self->estimate[0] + TRANSITION[0 + 2 * 1] * self->estimate[1],
        TRANSITION[1 + 2 * 0] * self->estimate[0] + TRANSITION[1 + 2 * 1] * self->estimate[1]
    };
    self->estimate[0] = estimate_product[0] + INPUT[0] * force;
    self->estimate[1] = estimate_product[1] + INPUT[1] * force;
    return force;
}

/* cart.h */

/** Holds a cart at a position. */
typedef struct {
    /** Estimated position and speed. */
    double estimate[2];
    cascade_f64_2_t smooth;
} cart_t;
