/* The C of tests/corpus/src/programs/control/for_mutable.rs. Written by a test. */

/* for_mutable.c */

void for_mutable_limit(double commands[4], double most)
{
    for (uint32_t i = 0U; i < 4U; i++) {
        if (fabs(commands[i]) > most) {
            commands[i] = copysign_f64(most, commands[i]);
        }
    }
}
