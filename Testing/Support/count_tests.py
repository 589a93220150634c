#!/usr/bin/env python3
"""Prints "N passed, N failed, N skipped" for a run of ctest.

Usage: count_tests.py JUNIT_REPORT FOLDER. The folder holds the reports of GoogleTest, one for each
test of ctest that runs a suite of cases: such a test counts as its cases.
"""

import collections
import pathlib
import sys
import xml.etree.ElementTree


def outcome(case):
    if case.find("failure") is not None:
        return "failed"
    if case.find("skipped") is not None or case.get("status") in ("notrun", "disabled"):
        return "skipped"
    return "passed"


def outcomes(report):
    return [outcome(case) for case in xml.etree.ElementTree.parse(report).iter("testcase")]


def main(junit, folder):
    counts = collections.Counter()
    for test in xml.etree.ElementTree.parse(junit).iter("testcase"):
        report = pathlib.Path(folder) / f"{test.get('name')}.xml"
        cases = outcomes(report) if report.exists() else [outcome(test)]
        if outcome(test) == "failed" and "failed" not in cases:
            # The suite crashed, ran out of time, or printed an error of VTK.
            cases.append("failed")
        counts.update(cases)
    print(", ".join(f"{counts[name]} {name}" for name in ("passed", "failed", "skipped")))


if __name__ == "__main__":
    main(*sys.argv[1:])
