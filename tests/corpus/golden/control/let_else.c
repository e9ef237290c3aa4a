/* The C of tests/corpus/src/programs/control/let_else.rs. Written by a test. */

/* let_else.c */

double let_else_mean(const option_f64_t *one, const option_f64_t *other)
{
    if (!one->is_some) {
        double result = 0.0;
        if (other->is_some) {
            result = other->value;
        }
        return result;
    }
    const double first = one->value;
    if (!other->is_some) {
        return first;
    }
    const double second = other->value;
    return (first + second) / 2.0;
}
