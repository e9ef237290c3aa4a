/* The C of tests/corpus/src/programs/control/match_tuples.rs. Written by a test. */

/* match_tuples.c */

int16_t match_tuples_drive(bool forward, bool backward, int16_t speed)
{
    if (forward && !backward) {
        return speed;
    } else if (!forward && backward) {
        return wrap_i16((uint16_t)(0U - (uint32_t)speed));
    } else {
        return 0;
    }
}
