"""Makes tables, pages and plots from the results of varimarch-bench.

A file of results that was kept with a report, Documentation/Reports/*/*.json, names the documents and
CSV files that have its tables. With --update their tables are written anew; with --check they are compared.
"""

import argparse
import json
import pathlib
import sys

from error_reports import extremes, order, promise
from light_reports import light_cost, light_methods, shadows_beside
from published_reports import published
from time_reports import features, scaling, shaders, soak, speed, times
from work_precision_reports import work_precision, work_precision_html

REPORTS = {
    "work-precision": work_precision, "published": published, "speed": speed, "shadows": light_cost,
    "occlusion": light_cost, "soft-shadows": light_cost, "scattering": light_cost, "light-methods": light_methods,
    "shadows-beside": shadows_beside, "scaling": scaling, "features": features, "shaders": shaders,
    "extremes": extremes, "order": order, "soak": soak, "times": times, "promise": promise,
}


def report_of(results):
    return REPORTS[results["benchmark"]](results).with_read_tables(results.get("tables", {}))


def write_report(results, source, folder, with_plots):
    """Writes NAME.md, a CSV file for each table, the plots, and for work-precision a page of HTML."""
    report = report_of(results)
    folder.mkdir(parents=True, exist_ok=True)
    name = results["benchmark"]
    (folder / f"{name}.md").write_text(report.markdown())
    for table in report.tables:
        if table.rows:
            (folder / f"{table.key}.csv").write_text(table.csv())
    if with_plots:
        from plots import write_plot
        for plot in report.plots:
            if plot.curves:
                write_plot(plot, folder)
    if name == "work-precision":
        (folder / f"{name}.html").write_text(work_precision_html(results, [folder, source]))


def with_table(text, table, found):
    """The document with the table in place of the next one that has its head.

    `found` has for each head the place after the last table that had it.
    """
    head = table.markdown_head()
    start = text.find(head, found.get(head, 0))
    if start < 0:
        raise ValueError(f"no table with the head {head.splitlines()[0]}")
    end = start + len(head)
    while text.startswith("|", end):
        end = text.find("\n", end) + 1
    new = table.markdown()
    found[head] = start + len(new)
    return text[:start] + new + text[end:]


def remade_documents(path):
    """The documents and CSV files that have tables of a file of results, with these tables made anew."""
    results = json.loads(path.read_text())
    texts, found = {}, {}
    tables = {table.key: table for table in report_of(results).tables}
    for key, files in results["documents"].items():
        for file in files:
            document = path.parent / file
            if document.suffix == ".csv":
                texts[document] = tables[key].csv()
            else:
                text = texts.get(document) or document.read_text()
                texts[document] = with_table(text, tables[key], found.setdefault(document, {}))
    return texts


def remake_documents(paths, only_check):
    differing = []
    for path in paths:
        for document, text in remade_documents(path).items():
            if document.read_text() != text:
                differing.append(f"{document} differs from what {path} makes")
                if not only_check:
                    document.write_text(text)
    return differing if only_check else []


def main():
    parser = argparse.ArgumentParser(prog="Report", description=__doc__.splitlines()[0])
    parser.add_argument("results", nargs="+", type=pathlib.Path, metavar="RESULTS.json",
                        help="results of varimarch-bench; - is the standard input")
    parser.add_argument("-o", "--output", type=pathlib.Path, metavar="FOLDER",
                        help="write the report as Markdown, CSV and HTML into this folder, instead of printing it")
    parser.add_argument("--plots", action="store_true", help="also write the plots into that folder; needs matplotlib")
    parser.add_argument("--update", action="store_true", help="write tables of documents anew")
    parser.add_argument("--check", action="store_true", help="compare tables of documents with the results")
    arguments = parser.parse_args()
    if arguments.update or arguments.check:
        return "\n".join(remake_documents(arguments.results, arguments.check)) or 0
    if arguments.plots and not arguments.output:
        parser.error("--plots needs --output")
    for path in arguments.results:
        results = json.loads(sys.stdin.read() if str(path) == "-" else path.read_text())
        if arguments.output:
            try:
                write_report(results, path.parent, arguments.output, arguments.plots)
            except ModuleNotFoundError as error:
                if error.name != "matplotlib":
                    raise
                return "Plots need matplotlib: install the Debian package python3-matplotlib."
        else:
            print(report_of(results).markdown(), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
