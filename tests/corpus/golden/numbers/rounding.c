/* The C of tests/corpus/src/programs/numbers/rounding.rs. Written by a test. */

/* rounding.c */

double rounding_snapped(double x)
{
    return round(x * 4.0) / 4.0;
}

void rounding_parts(float x, float result[2])
{
    result[0] = truncf(x);
    result[1] = x - truncf(x);
}

double rounding_pages(double bytes)
{
    return max_f64(ceil(bytes / 512.0), floor(bytes / 4096.0));
}
