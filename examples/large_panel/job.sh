#!/bin/bash
# Slurm job: 4.8 million elements on 4 nodes of 64 cores, 18,750 elements a rank.
#SBATCH --job-name=large_panel
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=64     # flat MPI: one rank a core,
#SBATCH --cpus-per-task=1        # no threads,
#SBATCH --hint=nomultithread     # and no second rank on a core
#SBATCH --mem-per-cpu=1G         # 0.6 kB an element; libraries and METIS need little besides
#SBATCH --time=02:00:00          # the model says less (below); a run that needs more goes on in the next job
#SBATCH --signal=USR1@120        # two minutes before: the run writes a checkpoint and leaves
#SBATCH --requeue                # after a failed node, too

# The program must have been built for the processors of these nodes: -DWEAVEFRONT_ARCH=native there, or x86-64-v4.
program=${WEAVEFRONT:-build/release/src/app/weavefront}

# What a step takes on this machine and how well it would scale: run once per machine, then look at the table.
#   srun $program partition examples/kevlar129_8ply/impact_267.yaml --calibrate machine.json
#   $program partition examples/large_panel/scene.yaml --ranks 64,128,256,512 --machine machine.json

# Results go to the parallel file system: 31 frames of about 0.33 GB.
# The same job, submitted again, goes on from the last checkpoint.
output=${SCRATCH:-runs}/large_panel
restart=()
if [ -e "$output/checkpoint.h5" ] || [ -e "$output/checkpoint.previous.h5" ]; then restart=(--restart auto); fi
srun "$program" run examples/large_panel/scene.yaml --output "$output" --checkpoint-every "10 min" "${restart[@]}"
