/* The C of tests/corpus/src/programs/data/enum_arrays.rs. Written by a test. */

/* enum_arrays.c */

static const int32_t STEPS[4][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}};

bessemer_status_t enum_arrays_walked(const enum_arrays_way_t path[5],
    int32_t place[BESSEMER_RESTRICT 2])
{
    int32_t place_value[2] = {0, 0};
    for (uint32_t i = 0U; i < 5U; i++) {
        const int32_t step[2] = {
            STEPS[(uint64_t)((uint32_t)path[i] < 3U ? path[i] : ENUM_ARRAYS_WAY_WEST)][0],
            STEPS[(uint64_t)((uint32_t)path[i] < 3U ? path[i] : ENUM_ARRAYS_WAY_WEST)][1]
        };
        if ((int64_t)place_value[0] + (int64_t)step[0] < INT32_MIN
                || (int64_t)place_value[0] + (int64_t)step[0] > INT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        place_value[0] += step[0];
        if ((int64_t)place_value[1] + (int64_t)step[1] < INT32_MIN
                || (int64_t)place_value[1] + (int64_t)step[1] > INT32_MAX) {
            return BESSEMER_STATUS_OVERFLOW;
        }
        place_value[1] += step[1];
    }
    place[0] = place_value[0];
    place[1] = place_value[1];
    return BESSEMER_STATUS_OK;
}

/* enum_arrays.h */

/** A direction. */
typedef enum {
    ENUM_ARRAYS_WAY_NORTH = 0,
    ENUM_ARRAYS_WAY_EAST = 1,
    ENUM_ARRAYS_WAY_SOUTH = 2,
    ENUM_ARRAYS_WAY_WEST = 3
} enum_arrays_way_t;
