/* The C of tests/corpus/src/programs/matrices/points.rs. Written by a test. */

/* points.c */

void points_halfway(const points_way_t *way, pair_f64_vector3_f64_t *BESSEMER_RESTRICT result)
{
    const double between[3] = {
        way->to[0] - way->from[0],
        way->to[1] - way->from[1],
        way->to[2] - way->from[2]
    };
    result->second[0] = way->from[0] + between[0] * 0.5;
    result->second[1] = way->from[1] + between[1] * 0.5;
    result->second[2] = way->from[2] + between[2] * 0.5;
    result->first = sqrt(between[0] * between[0] + between[1] * between[1]
        + between[2] * between[2]);
}

void points_moved(const float point[2], const float by[2], float result[BESSEMER_RESTRICT 2])
{
    float own_point[2];
    own_point[0] = point[0];
    own_point[1] = point[1];
    own_point[0] += by[0];
    own_point[1] -= by[1];
    const float back[2] = {-by[0] + own_point[0], -by[1] + own_point[1]};
    result[0] = by[0] + by[0] + back[0];
    result[1] = by[1] + by[1] + back[1];
}

void points_along(const double vector[3], const double direction[3],
    double result[BESSEMER_RESTRICT 3])
{
    double direction_2[3];
    norms_normalize_f64_3_1(direction, direction_2);
    const double result_dot = direction_2[0] * vector[0] + direction_2[1] * vector[1]
        + direction_2[2] * vector[2];
    result[0] = direction_2[0] * result_dot;
    result[1] = direction_2[1] * result_dot;
    result[2] = direction_2[2] * result_dot;
}

double points_above(const double point[3])
{
    const double up[3] = {0.0, 0.0, 1.0};
    const double result_elements[3] = {0.0, 0.0, 0.0};
    const double result_difference[3] = {
        point[0] - result_elements[0],
        point[1] - result_elements[1],
        point[2] - result_elements[2]
    };
    return up[0] * result_difference[0] + up[1] * result_difference[1]
        + up[2] * result_difference[2] + up[2];
}

/* points.h */

/** Position of a vehicle, and its previous position. */
typedef struct {
    /** Position. */
    double to[3];
    /** Previous position. */
    double from[3];
} points_way_t;
