/* The C of tests/corpus/src/programs/data/destructuring.rs. Written by a test. */

/* destructuring.c */

double destructuring_side(const destructuring_line_t *line, const double point[2])
{
    const double x = point[0];
    const double y = point[1];
    const double along = line->a * x;
    const double across = line->b * y;
    return along + across - line->c;
}

/* destructuring.h */

/** A line `a·x + b·y = c`. */
typedef struct {
    double a;
    double b;
    double c;
} destructuring_line_t;
