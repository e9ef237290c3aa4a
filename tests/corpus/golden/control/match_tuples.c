/* The C of tests/corpus/src/programs/control/match_tuples.rs. Written by a test. */

/* match_tuples.c */

/* The signed integer with these bits. */
static int16_t wrap_i16(uint16_t bits)
{
    return bits <= (uint16_t)INT16_MAX ? (int16_t)bits : (int16_t)(-1 - (int16_t)(UINT16_MAX - bits));
}

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
