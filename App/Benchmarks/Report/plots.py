"""Draws plots with matplotlib, which nothing else here needs."""

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.fonttype"] = "none"  # words stay words
import matplotlib.pyplot as pyplot  # noqa: E402
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter  # noqa: E402

PIXELS = (1400, 900)
DOTS_PER_INCH = 100


def write_plot(plot, folder):
    """Writes STEM.png and STEM.svg, with the legend beside the plot, where it hides no curve."""
    figure, axes = pyplot.subplots(figsize=[length / DOTS_PER_INCH for length in PIXELS], layout="constrained")
    axes.set(title=plot.title, xlabel=plot.x_title, ylabel=plot.y_title, xscale="log", yscale="log")
    axes.grid(color="#e1e1e1")
    for curve in plot.curves:
        color, marker, line = curve.style
        axes.plot(*zip(*curve.points), color=color, marker=marker, linestyle=line, linewidth=2, markersize=9,
                  label=curve.title)
    for title, height in plot.levels:
        axes.axhline(height, color="#787878", linestyle="-.", label=title)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.legend(loc="upper left", bbox_to_anchor=(1.02, 1))
    figure.savefig(folder / f"{plot.stem}.png", dpi=DOTS_PER_INCH)
    figure.savefig(folder / f"{plot.stem}.svg")
    pyplot.close(figure)
