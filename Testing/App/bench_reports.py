"""Makes reports from results of varimarch-bench, for tests of both."""

import pathlib
import subprocess
import sys

REPORT = pathlib.Path(__file__).parents[2] / "App" / "Benchmarks" / "Report"
sys.path.insert(0, str(REPORT))

from time_reports import speed_summaries  # noqa: E402, F401
from work_precision_reports import tolerance_rows, worst_against_vtk  # noqa: E402, F401


def run_report(*arguments, **options):
    command = [sys.executable, "-B", str(REPORT), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False, **options)


def made_report(results):
    """Writes tables and pages beside the results, and returns the Markdown that the report prints."""
    written = run_report(results, "-o", results.parent)
    assert written.returncode == 0, written.stderr
    printed = run_report(results)
    assert printed.returncode == 0, printed.stderr
    assert results.with_suffix(".md").read_text() == printed.stdout
    return printed.stdout
