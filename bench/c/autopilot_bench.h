/*
 * What the programs of the autopilot's filter have in common: the functions of a contender.
 */
#ifndef AUTOPILOT_BENCH_H
#define AUTOPILOT_BENCH_H

#ifdef BENCH_SINGLE
typedef float real;
#else
typedef double real;
#endif

#define STATES 24
#define HALF 300

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the state, and the covariance to a diagonal. */
void start(const real state[STATES], const real spread[STATES]);

/* Predicts a period, s, by a rate, rad/s, and a specific force, m/s². */
void predict(const real rate[3], const real force[3], real period);

/* Corrects by a measured velocity, m/s, and position, m. */
void place(const real measured[6]);

/* Corrects by a measured magnetic field, gauss. */
void compass(const real measured[3]);

/* Copies the state, and the lower triangle of the covariance by rows. */
void finish(real state[STATES], real covariance[HALF]);

#ifdef __cplusplus
}
#endif

#endif
