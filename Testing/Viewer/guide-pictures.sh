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

# keepHalf WALK PICTURE NAME keeps a picture of a large screen at half its size.
keepHalf()
{
  convert "$walks/$1/$2.png" -strip -resize 50% -quality 60 "$images/task-$3.jpg"
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
walk two-times 3840x2160-de-dark
keepHalf 3840x2160-de-dark two-times two-times-large
walk open-cd 1280x720-en-dark
keep 1280x720-en-dark open-cd open-cd-dark
