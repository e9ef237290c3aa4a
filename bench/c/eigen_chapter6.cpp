// The Chapter 6 job with Eigen, in place.
#include "case.h"

#include <Eigen/Dense>

#include <cstring>

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Matrix a;
Matrix inverse;

void load_solve()
{
    a = Eigen::Map<const Matrix>(matrix.f64, 200, 200);
}

void solve()
{
    const Eigen::PartialPivLU<Eigen::Ref<Matrix>> lu(a);
    Eigen::Map<Vector>(result.f64, 200) = lu.solve(Eigen::Map<const Vector>(vector.f64, 200));
}

void load_inverse()
{
    a = Eigen::Map<const Matrix>(matrix.f64, 100, 100);
    inverse.resize(100, 100);
}

void invert()
{
    const Eigen::PartialPivLU<Eigen::Ref<Matrix>> lu(a);
    inverse.noalias() = lu.inverse();
}

void store_inverse()
{
    std::memcpy(result.f64, inverse.data(), 10000 * sizeof(double));
}

} // namespace

extern "C" {
extern const case_t CASES[] = {
    {"lu_solve_f64_200", LU_SOLVE, 200, 0, load_solve, solve, nullptr},
    {"inverse_f64_100", INVERSE, 100, 0, load_inverse, invert, store_inverse},
};
extern const size_t CASE_COUNT = 2;
}
