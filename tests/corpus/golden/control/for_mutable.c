/* The C of tests/corpus/src/programs/control/for_mutable.rs. Written by a test. */

/* for_mutable.c */

/* The size of one number with the sign of another; a NaN counts as positive. */
static double copysign_f64(double size, double sign)
{
    return isnan(sign) ? fabs(size) : copysign(size, sign);
}

void for_mutable_limit(double commands[4], double most)
{
    for (uint32_t i = 0U; i < 4U; i++) {
        if (fabs(commands[i]) > most) {
            commands[i] = copysign_f64(most, commands[i]);
        }
    }
}
