#!/bin/bash
# A campaign as an array of Slurm. Adapt SHARDS (and --array with it), SEEDS, KIND and the folder, which all nodes share;
# PROGRAM is what `cargo bessemer campaign` builds: target/release/examples/campaign. Then: sbatch slurm.sh
#
# A shard that is killed or requeued goes on with its file. Single shards again: sbatch --array=3,7 slurm.sh
#SBATCH --job-name=campaign
#SBATCH --array=1-64
#SBATCH --cpus-per-task=4
#SBATCH --time=04:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail

SHARDS=64
SEEDS=0..1000000
KIND=${KIND:-}
PROGRAM=${PROGRAM:-./campaign}
RESULTS=${RESULTS:-results}

mkdir -p "$RESULTS"
export RAYON_NUM_THREADS="${SLURM_CPUS_PER_TASK:-1}"
code=0
# Without a KIND, the program has one campaign.
"$PROGRAM" ${KIND:+"$KIND"} --seeds "$SEEDS" --shard "$SLURM_ARRAY_TASK_ID/$SHARDS" \
    --file "$RESULTS/${KIND:-campaign}-$SLURM_ARRAY_TASK_ID.csv" || code=$?
# 1 says that runs were faulty: the shard is done. When all are: "$PROGRAM" --merge results/*.csv --summary results.html
if [ "$code" -gt 1 ]; then
    exit "$code"
fi
