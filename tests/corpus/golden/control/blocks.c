/* The C of tests/corpus/src/programs/control/blocks.rs. Written by a test. */

/* blocks.c */

double blocks_area(double a, double b, double c)
{
    const double half = (a + b + c) / 2.0;
    const double x = half - a;
    const double y = half - b;
    const double z = half - c;
    const double square = half * x * y * z;
    if (square > 0.0) {
        return sqrt(square);
    } else {
        return 0.0;
    }
}
