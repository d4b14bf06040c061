// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm::jobs {

/// Queue's run_job. A shell may end `wait` early for a signal, so it waits again; one that has reported the end of the process already says 127 then.
constexpr const char* run_job_script = R"sh(#!/bin/sh
# run_job FOLDER BERM run CASE ...: runs the job, or goes on with it where it was stopped. What berm says goes to FOLDER.messages, which goes
# where it ends well; else its exit status is left in FOLDER.status. TERM stops the run, which then leaves a checkpoint and ends with 75.
folder=$1
shift
before=$(cat "$folder.status" 2> /dev/null)
if [ -n "$before" ] && [ "$before" -ne 75 ]; then exit "$before"; fi
if [ ! -e "$folder.messages" ] && [ -e "$folder/summary.json" ]; then exit 0; fi
rm -f "$folder.status"
if [ -h "$folder.messages" ] || { [ -e "$folder.messages" ] && [ ! -f "$folder.messages" ]; }; then
  echo "berm: cannot write $folder.messages: it is not a regular file" >&2
  echo 1 > "$folder.status.part" && mv "$folder.status.part" "$folder.status"
  exit 1
fi
if [ "$2" = run ] && [ -e "$folder.messages" ] && { [ -e "$folder/checkpoint/case_file.txt" ] || [ -e "$folder/summary.json" ]; }; then
  case " $* " in
    *' --uncertainty '*) set -- "$1" run --resume "$folder" --threads 1 --uncertainty ;;
    *) set -- "$1" run --resume "$folder" --threads 1 ;;
  esac
fi
asked= again= process=
trap 'asked=yes again=yes; [ -z "$process" ] || kill -TERM "$process" 2> /dev/null' TERM INT
# In a session of its own: a second TERM, sent to all processes of a task, would end it without a checkpoint.
setsid "$@" >> "$folder.messages" 2>&1 < /dev/null &
process=$!
[ -z "$asked" ] || kill -TERM "$process" 2> /dev/null
wait "$process"
status=$?
while [ -n "$again" ]; do
  again=
  wait "$process"
  new=$?
  [ "$new" -eq 127 ] || status=$new
done
# Before it could write a checkpoint it has lost nothing.
if [ -n "$asked" ] && [ "$status" -eq 143 ]; then status=75; fi
if [ "$status" -eq 0 ]; then
  rm -f "$folder.messages" "$folder.status"
else
  echo "$status" > "$folder.status.part" && mv "$folder.status.part" "$folder.status"
fi
exit "$status"
)sh";

/// The task of Slurm's job array. Slurm sends TERM to this shell alone (--signal=B:TERM), 120 s before the time limit.
constexpr const char* task_script = R"sh(#!/bin/bash
#SBATCH --job-name=berm
#SBATCH --output=task_%a.out
#SBATCH --open-mode=append
#SBATCH --requeue
#SBATCH --signal=B:TERM@120
# Task k of the array does PACK lines of `jobs`, as many at a time as it has processors (--cpus-per-task). Stopped before all are done it stands in line
# again; the runs then go on from their checkpoints.
pack=PACK
at_once=${SLURM_CPUS_PER_TASK:-1}
asked= again= unfinished= worst=0
processes=()
trap 'asked=yes again=yes; kill -TERM $(jobs -p) 2> /dev/null' TERM
while IFS= read -r -u 3 line; do
  while [ -z "$asked" ] && [ "$(jobs -pr | wc -l)" -ge "$at_once" ]; do sleep 0.1; done
  if [ -n "$asked" ]; then
    unfinished=yes
    break
  fi
  eval "exec 3<&-; exec $line" &
  processes+=($!)
done 3< <(tail -n +$((SLURM_ARRAY_TASK_ID * pack + 1)) jobs | head -n "$pack")
for process in "${processes[@]}"; do
  again=
  wait "$process"
  status=$?
  while [ -n "$again" ]; do
    again=
    wait "$process"
    status=$?
  done
  if [ "$status" -eq 75 ]; then unfinished=yes; elif [ "$status" -ne 0 ]; then worst=$status; fi
done
[ -n "$unfinished" ] || exit "$worst"
# A task that is being cancelled stays so.
id=${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID
for _ in 1 2 3 4 5; do
  if state=$(env -u SQUEUE_STATES -u SQUEUE_PARTITION squeue --noheader --format=%T --jobs="$id"); then break; fi
  sleep 2
done
[ "$state" != RUNNING ] || scontrol requeue "$id"
exit 75
)sh";

}  // namespace berm::jobs
