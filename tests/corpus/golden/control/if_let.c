/* The C of tests/corpus/src/programs/control/if_let.rs. Written by a test. */

/* if_let.c */

double if_let_height(const if_let_altimeter_t *altimeter, double other)
{
    if (altimeter->height.is_some && altimeter->errors < 3U) {
        return altimeter->height.value;
    } else {
        return other;
    }
}

void if_let_lift(if_let_altimeter_t *altimeter, double by)
{
    if (altimeter->height.is_some) {
        altimeter->height.value += by;
    }
}

bool if_let_is_low(const if_let_altimeter_t *altimeter)
{
    return altimeter->height.is_some && altimeter->height.value < 0.5;
}

/* if_let.h */

/** Last reading of the altimeter. */
typedef struct {
    /** Height, m. */
    option_f64_t height;
    uint8_t errors;
} if_let_altimeter_t;
