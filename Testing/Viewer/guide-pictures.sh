#!/usr/bin/env bash
# Makes the pictures of the ten tasks in Documentation/UserGuide.md anew, by walks through the tasks.
#
# Usage: guide-pictures.sh VIEWER_TASKS HEAD_CT; needs the packages xvfb and imagemagick. The head is
# that of the package invesalius-examples, everything else is computed.
set -euo pipefail
program=$(realpath "$1")
head=$(realpath "$2")
here=$(dirname "$(realpath "$0")")
images=$(realpath "$here/../../Documentation/Images")
walks=$(mktemp -d)
trap 'rm -rf "$walks"' EXIT

# keep WALK PICTURE NAME keeps a picture with 128 colours, which suffice for windows.
keep()
{
  local picture="$walks/$1/$2.png" name="$images/task-$3.png"
  convert "$picture" -strip -dither None -colors 128 -define png:compression-level=9 \
    "PNG8:$name"
}

# walk TASK WALK does a task.
walk()
{
  TASK=$1 "$here/walk.sh" "$program" "$walks" "$head" "$2"
}

for task in open-cd aneurysm pet nodule bone curved two-times face report
do
  walk "$task" 1280x720-en-light
  keep 1280x720-en-light "$task" "$task"
done
walk send 1280x720-en-light
keep 1280x720-en-light send-dialog send
walk pet 1280x720-de-light
keep 1280x720-de-light pet pet-de
walk bone 1280x720-es-light
keep 1280x720-es-light bone bone-es
walk open-cd 1280x720-en-dark
keep 1280x720-en-dark open-cd open-cd-dark
