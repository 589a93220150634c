#!/usr/bin/env python3
"""Makes the tables of the committed reports anew, and plots where matplotlib is installed.

Usage: test_reports.py CASE. Exit code 77: matplotlib is missing.
"""

import importlib.util
import json
import pathlib
import shutil
import sys
import tempfile

from bench_reports import run_report

DOCUMENTS = pathlib.Path(__file__).parents[2] / "Documentation" / "Reports"


def committed_tables(_):
    """Each table whose figures were kept as JSON is the same to the byte when it is made from them."""
    kept = sorted(DOCUMENTS.glob("*/*.json"))
    assert len(kept) >= 15, kept
    checked = run_report("--check", *kept)
    assert checked.returncode == 0, checked.stderr


def other_figures(folder):
    """A figure that differs is found, and --update puts it into the document."""
    shutil.copytree(DOCUMENTS / "Order", folder / "Order")
    shutil.copy(DOCUMENTS / "Order.md", folder)
    kept = folder / "Order" / "order.json"
    results = json.loads(kept.read_text())
    results["tables"]["grid"]["rows"][1][4] = 2.5
    kept.write_text(json.dumps(results))
    checked = run_report("--check", kept)
    assert checked.returncode == 1 and "Order.md differs" in checked.stderr, checked.stderr
    assert run_report("--update", kept).returncode == 0
    before, after = ((place / "Order.md").read_text().splitlines() for place in (DOCUMENTS, folder))
    changed = [(old, new) for old, new in zip(before, after, strict=True) if old != new]
    assert [new for _, new in changed] == [
        "| Varimarch, cubic spline | 2 | 2.52 ± 0.28 | 7 of 7 | 2.500 | 0.0100 |"], changed
    assert run_report("--check", kept).returncode == 0


def no_matplotlib(folder):
    """Tables need no matplotlib, and one sentence says that plots do."""
    (folder / "matplotlib.py").write_text("raise ModuleNotFoundError(name='matplotlib')\n")
    results = DOCUMENTS / "Order" / "order.json"
    environment = {"PYTHONPATH": str(folder)}
    assert run_report(results, "-o", folder / "tables", env=environment).returncode == 0
    made = run_report(results, "-o", folder / "plots", "--plots", env=environment)
    assert made.returncode == 1 and made.stderr == (
        "Plots need matplotlib: install the Debian package python3-matplotlib.\n"), made.stderr
    assert (folder / "plots" / "order.md").exists()


def plots(folder):
    """Curves are where their numbers are, and the SVG holds their titles as words."""
    if not importlib.util.find_spec("matplotlib"):
        sys.exit(77)
    from columns import Curve, Plot
    from plots import write_plot
    blue, orange = (0, 114, 178), (213, 94, 0)
    write_plot(Plot("phantom", "precision of a phantom", "time [ms]", "RMSE", [
        Curve("low and slow", ("#0072b2", "o", "-"), [(80.0, 1.0), (160.0, 0.5)]),
        Curve("high and quick", ("#d55e00", "s", "-"), [(10.0, 100.0), (20.0, 50.0)])]), folder)
    from matplotlib import image
    pixels = (image.imread(folder / "phantom.png")[..., :3] * 255).round()
    assert pixels.shape[:2] == (900, 1400), pixels.shape
    places = []
    for color in (blue, orange):
        rows, columns = (pixels[:, :980] == color).all(axis=-1).nonzero()  # without the legend
        assert len(rows) > 100, color
        places.append((columns.mean(), rows.mean()))
    (slow_x, slow_y), (quick_x, quick_y) = places
    assert slow_x > quick_x + 300 and slow_y > quick_y + 300, places
    text = (folder / "phantom.svg").read_text()
    for part in ("precision of a phantom", "time [ms]", "low and slow", "high and quick", "#0072b2", "#d55e00"):
        assert part in text, part


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        globals()[sys.argv[1]](pathlib.Path(name))
