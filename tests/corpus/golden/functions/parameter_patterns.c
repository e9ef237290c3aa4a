/* The C of tests/corpus/src/programs/functions/parameter_patterns.rs. Written by a test. */

/* parameter_patterns.c */

double parameter_patterns_length(const pair_f64_f64_t *x_y)
{
    const double x = x_y->first;
    const double y = x_y->second;
    return sqrt(x * x + y * y);
}

double parameter_patterns_volume(const double width_depth_height[3])
{
    return width_depth_height[0] * width_depth_height[1] * width_depth_height[2];
}

double parameter_patterns_slope(const spot_t *x_y)
{
    return x_y->y / x_y->x;
}

double parameter_patterns_all(const spot_t *point, const double sides[3])
{
    const pair_f64_f64_t result_x_y = {.first = point->x, .second = point->y};
    const double result_length = parameter_patterns_length(&result_x_y);
    return result_length + parameter_patterns_volume(sides) + parameter_patterns_slope(point);
}

/* parameter_patterns.h */

/** A point, m. */
typedef struct {
    double x;
    double y;
} spot_t;
