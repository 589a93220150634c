#!/usr/bin/env bash
# Makes the pictures in Documentation/UserGuide.md anew: those of the ten tasks by walks through the
# tasks, the others by a walk through the guide.
#
# Usage: guide-pictures.sh VIEWER_TASKS VIEWER_GUIDE HEAD_CT; needs the packages xvfb and imagemagick.
# The head is that of the package invesalius-examples, everything else is computed.
set -euo pipefail
program=$(realpath "$1")
guide=$(realpath "$2")
head=$(realpath "$3")
here=$(dirname "$(realpath "$0")")
images=$(realpath "$here/../../Documentation/Images")
walks=$(mktemp -d)
trap 'rm -rf "$walks"' EXIT

# reduce FROM TO writes a picture with 128 colours, which suffice for windows.
reduce()
{
  convert "$1" -strip -dither None -colors 128 -define png:compression-level=9 "PNG8:$2"
}

# keep WALK PICTURE NAME keeps a picture of a task.
keep()
{
  reduce "$walks/$1/$2.png" "$images/task-$3.png"
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

QT_QPA_PLATFORM=xcb xvfb-run --auto-servernum --server-args "-screen 0 1400x900x24 -noreset" \
  "$guide" "$head" "$walks"
for picture in "$walks"/viewer-*.png
do
  reduce "$picture" "$images/$(basename "$picture")"
done
