"""Tables whose columns state once their name, their unit, their decimals and the source of their value."""

import html
import math
from typing import Any, Callable, NamedTuple


class Column(NamedTuple):
    """A column of numbers, or of words if it has no decimals.

    A value is a number, a word, or None if it is not known.
    """

    name: str
    value: Callable[[Any], Any]  # the value in a row
    decimals: int | str | None = None  # digits after the point; "9g": nine significant digits
    unit: str = ""
    missing: str = "-"  # stands for a value that is not known
    quoted: bool = False  # always in quotes in CSV

    @property
    def heading(self):
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    def text(self, value):
        if value is None:
            return self.missing
        if isinstance(value, str) or self.decimals is None:
            return str(value)
        return f"{value:.{self.decimals}}" if isinstance(self.decimals, str) else f"{value:.{self.decimals}f}"


class Table:
    """Rows of values.

    A row is whatever the columns take their values from, or a list of the values themselves, as in
    results that were read from a table.
    """

    def __init__(self, key, columns, rows, before="", after="", only_csv=False):
        self.key = key
        self.columns = columns
        self.rows = list(rows)
        self.before = before  # Markdown
        self.after = after
        self.only_csv = only_csv

    def values(self, row):
        return row if isinstance(row, list) else [column.value(row) for column in self.columns]

    def cells(self):
        return [[column.text(value) for column, value in zip(self.columns, self.values(row), strict=True)]
                for row in self.rows]

    def headings(self):
        return [column.heading for column in self.columns]

    def markdown_head(self):
        line = "|".join("---" if column.decimals is None else "---:" for column in self.columns)
        return markdown_row(self.headings()).replace("  |", " |") + f"|{line}|\n"

    def markdown(self):
        return self.markdown_head() + "".join(map(markdown_row, self.cells()))

    def csv(self):
        lines = [",".join(map(csv_cell, self.headings()))]
        lines += [",".join(csv_cell(cell.replace("**", ""), column.quoted)
                           for column, cell in zip(self.columns, cells, strict=True)) for cells in self.cells()]
        return "\n".join(lines) + "\n"

    def html(self):
        return "<table>" + html_row("th", self.headings()) + "".join(
            html_row("td", cells) for cells in self.cells()) + "</table>\n"


def markdown_row(cells):
    return "|" + "".join(f" {cell} |" for cell in cells) + "\n"


def csv_cell(text, always_quoted=False):
    text = text.replace("\n", " ")
    return '"' + text.replace('"', '""') + '"' if always_quoted or set(text) & set(',"') else text


def html_row(cell, texts):
    return "<tr>" + "".join(f"<{cell}>{html.escape(text)}</{cell}>" for text in texts) + "</tr>\n"


class Curve(NamedTuple):
    """A curve of a plot. Curves differ in more than colour, for colour-blind readers and for print."""

    title: str
    style: tuple  # colour, marker and line of matplotlib
    points: list  # (x, y), each > 0


class Plot(NamedTuple):
    """Curves over two logarithmic axes, as for work-precision diagrams.

    E. Hairer, G. Wanner, "Solving ordinary differential equations II", 1996.
    """

    stem: str  # file name without extension
    title: str
    x_title: str
    y_title: str
    curves: list
    levels: list = []  # (title, y): grey lines across the plot


class Report(NamedTuple):
    """The report of a benchmark's results."""

    title: str
    introduction: str  # Markdown
    tables: list
    after: str = ""
    plots: list = []

    def markdown(self):
        text = f"# {self.title}\n\n{self.introduction}"
        for table in self.tables:
            if table.rows and not table.only_csv:
                text += table.before + table.markdown() + table.after
        return text + self.after

    def with_read_tables(self, read):
        """The report with the rows of tables that were read from a document instead of measured.

        Such a table may lack columns, and may have had other headings.
        """
        for table in self.tables:
            if table.key in read:
                given = read[table.key]
                names = given.get("headings", {})
                table.columns = [column._replace(name=names[column.heading], unit="")
                                 if column.heading in names else column for column in table.columns
                                 if column.heading not in given.get("without", [])]
                table.rows = given["rows"]
        return self


def geometric_mean(numbers):
    """0 without any numbers."""
    return math.exp(sum(map(math.log, numbers)) / len(numbers)) if numbers else 0.0


def load_text(machine):
    """The load before the start as the end of a list; nothing if it was not kept."""
    load = machine["loadBefore"]
    return "" if load is None else f", load before the start {load:.1f}"


def machine_text(results):
    machine = results["machine"]
    return (f"{machine['processor']}, {machine['cores']} cores, VTK {machine['vtkVersion']}, {machine['date']}"
            f"{load_text(machine)}")
