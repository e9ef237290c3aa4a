/*
 * What the programs of `cargo xtask bench --only gradient` have in common: the function of a contender.
 */
#ifndef GRADIENT_H
#define GRADIENT_H

#ifdef BENCH_SINGLE
typedef float real;
#else
typedef double real;
#endif

#define STATES 5
#define INPUTS 100

/* Computes the cost, and returns its gradient by the inputs. */
const real *step(const real start[STATES], const real inputs[INPUTS], real period, real *cost);

/* Computes the sine and the cosine of an angle alone. */
void angles(real angle, real two[2]);

#endif
