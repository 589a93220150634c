#!/usr/bin/env python3
"""Times of the processes that draw in ParaView, and a model of more of them.

Usage: scaling.py times FOLDER...  the least times of each process, from logs of pvbatch [ms]
       scaling.py model            the time of an image on 1 to 1,024 processes
       scaling.py rounding         the error of parts that are composited in 8 bits

The model. N is the number of voxels along an axis, p of processes, P of pixels that show the volume.
A process has a brick of 1/p of the volume, which covers P / p^(2/3) pixels and N / p^(1/3) voxels of a
ray. IceT's compositing exchanges halves of the image in log2(p) rounds and collects the result at one
process:

  march      = a N P / p + r W                 a per voxel of a ray, r per pixel of the window W
  composite  = (b + 4 / B) c(p) + log2(p) L    b per blended pixel, B bytes per second, L latency
  collect    = 4 W / B + L
  c(p)       = P / p^(2/3) sum over k = 1 .. log2(p) of 2^(2 k / 3) / 2^k

In round k a process holds a part of the image that 2^k bricks have drawn, and of it 1 / 2^k. A process
takes the picture of its brick to the graphics memory and back, r W, whatever the size of the brick.
"""

import collections
import math
import pathlib
import re
import sys

import numpy

# From the least times of "composite" on 2 and 8 processes in Documentation/Reports/ParaView.md, 81
# voxels along an axis, 38,600 of 65,536 pixels: march and read take 3.5 ms and 2.2 ms, compressing
# and blending 0.12 ms and less.
SECONDS_PER_VOXEL_OF_A_RAY = (3.5e-3 - 2.2e-3) / (1 / 2 - 1 / 8) / (81 * 38_600)
SECONDS_PER_READ_PIXEL = (2.2e-3 - (3.5e-3 - 2.2e-3) / (1 / 2 - 1 / 8) / 8) / 65_536
SECONDS_PER_BLENDED_PIXEL = 0.1e-3 / 65_536 + 0.02e-3 / 20_000
# Networks that are assumed: bytes per second, and seconds until a message arrives.
NETWORKS = {"1 Gbit/s Ethernet": (1.17e8, 5e-5), "100 Gbit/s InfiniBand": (1.2e10, 2e-6)}
WINDOW = 1920 * 1080
COVERED = 0.6  # part of the window that shows the volume

TIME = re.compile(r"\[pvbatch\.(\d+) .*(ICET|VARIMARCH)_(\w+)_TIME: ([\d.e-]+)")


def times(folders):
    """A row for each process that has written into FOLDER/log."""
    print("| processes | process | march and read | composite | of it blend | compress | collect |")
    print("|---:|---:|---:|---:|---:|---:|---:|")
    for folder in folders:
        found = collections.defaultdict(lambda: collections.defaultdict(list))
        log = (pathlib.Path(folder) / "log").read_text(encoding="utf-8", errors="replace")
        # Where floats are composited, ParaView's own compositing of one picture follows.
        maker = "VARIMARCH" if "VARIMARCH_COMPOSITE_TIME" in log else "ICET"
        for process, by, name, seconds in TIME.findall(log):
            if by == maker:
                found[int(process)][name].append(float(seconds))
        for process, named in sorted(found.items()):
            least = [
                f"{1000 * min(named[name]):.2f}"
                for name in ("RENDER", "COMPOSITE", "BLEND", "COMPRESS", "COLLECT")
            ]
            print("|", " | ".join([str(len(found)), str(process), *least]), "|")


def exchanged_pixels(pixels, processes):
    rounds = int(math.log2(processes))
    return pixels / processes ** (2 / 3) * sum(2 ** (2 * k / 3 - k) for k in range(1, rounds + 1))


def frame_seconds(voxels, processes, network):
    """The seconds of marching and of everything else."""
    bandwidth, latency = network
    pixels = COVERED * WINDOW
    march = SECONDS_PER_VOXEL_OF_A_RAY * voxels * pixels / processes
    march += SECONDS_PER_READ_PIXEL * WINDOW
    if processes == 1:
        return march, 0.0
    exchanged = exchanged_pixels(pixels, processes)
    composite = (SECONDS_PER_BLENDED_PIXEL + 4 / bandwidth) * exchanged
    composite += math.log2(processes) * latency
    collect = 4 * WINDOW / bandwidth + latency
    return march, composite + collect


def model():
    for name, network in NETWORKS.items():
        print(f"\n{name}, 1920 x 1080 pixels: march + compositing [ms]\n")
        print("| processes | 1024^3 | 2048^3 | 4096^3 | 8192^3 |")
        print("|---:|---:|---:|---:|---:|")
        for processes in (1, 2, 8, 64, 512, 1024):
            row = [str(processes)]
            for voxels in (1024, 2048, 4096, 8192):
                march, rest = frame_seconds(voxels, processes, network)
                row.append(f"{1000 * march:.0f} + {1000 * rest:.0f}")
            print("|", " | ".join(row), "|")


def rounding():
    """Random rays through parts of equal extinction, composited as IceT does: each part is rounded to
    8 bits, and the product with the transmittance in front is cut to an integer."""
    random = numpy.random.default_rng(1)
    rays = 200_000
    print("| parts behind each other | RMSE [1/255] | mean | ratio [dB] | without cutting [dB] |")
    print("|---:|---:|---:|---:|---:|")
    for parts in (1, 2, 3, 4):
        transmittances = random.uniform(0.02, 0.9, rays)[:, None] ** (1 / parts)
        opacities = 1.0 - numpy.repeat(transmittances, parts, axis=1)
        colors = opacities * random.uniform(0.1, 1.0, (rays, parts))
        exact, cut, rounded = 0.0, 0.0, 0.0
        for part in reversed(range(parts)):
            own = numpy.round(255 * colors[:, part])
            left = 255 - numpy.round(255 * opacities[:, part])
            exact = 255 * colors[:, part] + (1 - opacities[:, part]) * exact
            cut = own + numpy.floor(cut * left / 255)
            rounded = own + numpy.round(rounded * left / 255)
        single = numpy.round(exact)  # one process rounds too
        errors = [picture - single for picture in (cut, rounded)]
        root = [float(numpy.sqrt((error**2).mean())) for error in errors]
        ratio = [20 * math.log10(255 / each) if each else math.inf for each in root]
        print(f"| {parts} | {root[0]:.2f} | {errors[0].mean():.2f} | {ratio[0]:.1f} | {ratio[1]:.1f} |")


command, *arguments = sys.argv[1:]
{"times": lambda: times(arguments), "model": model, "rounding": rounding}[command]()
