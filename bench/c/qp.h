/*
 * What the programs of `cargo xtask bench --only qp` have in common: the functions of a contender.
 */
#ifndef QP_H
#define QP_H

#include <stddef.h>

enum { NX = 12, NU = 4, PERIODS = 10, UNKNOWNS = 40 };

#ifdef __cplusplus
extern "C" {
#endif

/* Prepares the constants. */
void start(void);

/* Returns the first input for a state. */
void step(const double state[NX], double input[NU]);

#ifdef __cplusplus
}
#endif

#endif
