#!/bin/bash
# Slurm job that goes on by itself until its run is done: sbatch examples/large_panel/job.sh [SCENE [OPTIONS]]
# The numbers are for the large panel: 4.8 million elements on 4 nodes of 64 cores, 18,750 elements a rank.
#SBATCH --job-name=large_panel
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=64     # flat MPI: one rank a core,
#SBATCH --cpus-per-task=1        # no threads,
#SBATCH --hint=nomultithread     # and no second rank on a core
#SBATCH --mem-per-cpu=1G         # 0.6 kB an element; libraries and METIS need little besides
#SBATCH --time=02:00:00          # the model says less (below); a run that needs more goes on in the requeued job
#SBATCH --signal=USR1@120        # two minutes before: the run writes a checkpoint and leaves with status 4
#SBATCH --requeue                # after a failed node or a preemption, too
#SBATCH --open-mode=append       # one output file for all parts of the run

# The program must have been built for the processors of these nodes: -DWEAVEFRONT_ARCH=native there, or x86-64-v4.
program=${WEAVEFRONT:-build/release/src/app/weavefront}

# What a step takes on this machine and how well it would scale: run once per machine, then look at the table.
#   srun $program partition examples/kevlar129_8ply/impact_267.yaml --calibrate machine.json
#   $program partition examples/large_panel/scene.yaml --ranks 64,128,256,512 --machine machine.json

# The run leaves before this time. Slurm sets it since version 23.02.
: "${SLURM_JOB_END_TIME:=$(date --date "$(squeue --noheader --jobs "$SLURM_JOB_ID" --format %e)" +%s)}"
export SLURM_JOB_END_TIME

# Results go to the parallel file system: 31 frames of about 0.33 GB.
# The same job, requeued or submitted again, goes on from the last checkpoint.
output=${SCRATCH:-runs}/large_panel
steps() { grep -o '"steps": *[0-9]*' "$output/summary.json" 2>/dev/null; }
before=$(steps)
restart=()
if [ -e "$output/checkpoint.h5" ] || [ -e "$output/checkpoint.previous.h5" ]; then restart=(--restart auto); fi
# Where srun starts ranks that do not know each other: srun --mpi=pmix for Open MPI, --mpi=pmi2 for MPICH.
srun "$program" run "${1:-examples/large_panel/scene.yaml}" "${@:2}" --output "$output" --checkpoint-every "10 min" "${restart[@]}"
status=$?

# Stopped with a checkpoint, not by the file `stop` or by scancel: go on in this job, unless its time is too short for a single step.
if [ $status -eq 4 ] && ! grep -q 'stop was found' "$output/summary.json"; then
    if [ "$(steps)" = "$before" ]; then
        echo "the job ends before the run has made a step: give it more time (--time)" >&2
    else
        scontrol requeue "$SLURM_JOB_ID"
    fi
fi
exit $status
