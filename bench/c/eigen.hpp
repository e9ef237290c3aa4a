// Eigen: fixed sizes where they are small, as its manual recommends; Chapter 6 in place.
#ifndef EIGEN_CASES_HPP
#define EIGEN_CASES_HPP

#include "case.h"

#include <Eigen/Dense>

template <typename Real, int N> struct Small {
    using Matrix = Eigen::Matrix<Real, N, N>;
    using Vector = Eigen::Matrix<Real, N, 1>;
    using A = Eigen::Map<const Matrix>;
    using B = Eigen::Map<const Vector>;

    static void lu_solve(const Real *a, const Real *b, Real *x)
    {
        Eigen::Map<Vector> result{x};
        result = A(a).partialPivLu().solve(B(b));
    }

    static void inverse(const Real *a, Real *x)
    {
        Eigen::Map<Matrix> result{x};
        result = A(a).inverse();
    }

    static void cholesky_solve(const Real *a, const Real *b, Real *x)
    {
        Eigen::Map<Vector> result{x};
        result = A(a).llt().solve(B(b));
    }

    static void product(const Real *a, const Real *b, Real *x)
    {
        Eigen::Map<Matrix> result{x};
        result.noalias() = A(a) * A(b);
    }
};

#endif
