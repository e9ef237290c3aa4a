/*
 * Predictive control by the code of CVXPYgen.
 */
#include "qp.h"

#include "cpg_solve.h"
#include "cpg_workspace.h"

void start(void)
{
    /* Its settings are in its code. */
}

void step(const double state[NX], double input[NU])
{
    for (int i = 0; i < NX; i++) {
        cpg_update_now(i, state[i]);
    }
    cpg_solve();
    for (int i = 0; i < NU; i++) {
        input[i] = CPG_Result.prim->u[i];
    }
}
