/* The C of tests/corpus/src/programs/numbers/ordering.rs. Written by a test. */

/* ordering.c */

bool ordering_inside(double value, double low, double high)
{
    return low < value && value < high;
}

int8_t ordering_ordered(int64_t a, int64_t b, int64_t c)
{
    if (a < b && b < c) {
        return 1;
    } else if (a > b && b > c) {
        return -1;
    } else {
        return 0;
    }
}
