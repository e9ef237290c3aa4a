/* The C of tests/corpus/src/programs/data/grids_of_structs.rs. Written by a test. */

/* grids_of_structs.c */

float grids_of_structs_highest(const square_t map[2][3])
{
    float most = 0.0F;
    for (uint32_t i = 0U; i < 2U; i++) {
        for (uint32_t j = 0U; j < 3U; j++) {
            if (map[i][j].seen) {
                most = max_f32(most, map[i][j].height);
            }
        }
    }
    return most;
}

/* grids_of_structs.h */

/** A square of a map. */
typedef struct {
    float height;
    bool seen;
} square_t;
