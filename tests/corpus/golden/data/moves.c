/* The C of tests/corpus/src/programs/data/moves.rs. Written by a test. */

/* moves.c */

void moves_swapped(const two_t *two, two_t *BESSEMER_RESTRICT result)
{
    two_t own_two = *two;
    const int64_t first = own_two.first;
    own_two.first = own_two.second;
    own_two.second = first;
    *result = own_two;
}

void moves_both(const two_t *two, two_t result[BESSEMER_RESTRICT 2])
{
    two_t result_swapped;
    moves_swapped(two, &result_swapped);
    result[0] = *two;
    result[1] = result_swapped;
}

/* moves.h */

/** A state of two numbers. */
typedef struct {
    int64_t first;
    int64_t second;
} two_t;
