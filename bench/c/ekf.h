/*
 * What the programs of `cargo xtask bench --only ekf` have in common: the functions of a contender.
 */
#ifndef EKF_H
#define EKF_H

#ifdef BENCH_SINGLE
typedef float real;
#else
typedef double real;
#endif

#define STATES 12
#define HALF 78

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the state to zero, and the covariance to a diagonal. */
void start(const real spread[STATES]);

/* Predicts a period, and corrects by a measured position and velocity. */
void step(const real rate[3], const real force[3], real period, const real measured[6]);

/* Computes the sines and the cosines of a step alone. */
void angles(const real three[3], real six[6]);

/* Copies the state, and the lower triangle of the covariance by rows. */
void finish(real state[STATES], real covariance[HALF]);

#ifdef __cplusplus
}
#endif

#endif
