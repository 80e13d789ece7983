"""The table as text, as CSV and as a page that needs no network."""
import csv
import html
import textwrap

from .row import Verdict

STYLE = """
body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 78em; padding: 0 1em; color: #222; background: #fff; }
table { border-collapse: collapse; width: 100%; }
td, th { text-align: left; vertical-align: top; padding: .35em .7em; border-bottom: 1px solid #ddd; }
th.group { padding-top: 1.4em; font-size: 110%; border-bottom: 2px solid #888; }
td.verdict { font-weight: bold; white-space: nowrap; }
.holds { color: #1a7431; } .fails { color: #fff; background: #b3261e; } .reported { color: #555; }
ul { margin: 0; padding-left: 1.1em; } .miss { color: #b3261e; font-weight: bold; }
code { background: #f3f3f3; padding: .1em .3em; } .number { text-align: right; white-space: nowrap; }
"""


def text_of(result, width=118):
    """One row for the terminal."""
    head = f"{result.verdict.value.upper():8}  {result.row.name}: {result.row.scene}"
    lines = [f"asked: {result.row.asked}"]
    lines += [("NOT MET: " if figure.holds is False else "") + figure.text for figure in result.figures]
    wrapped = [textwrap.fill(line, width, initial_indent=" " * 10, subsequent_indent=" " * 12) for line in lines]
    return "\n".join([head, *wrapped])


def summary(results):
    counts = {verdict: sum(r.verdict is verdict for r in results) for verdict in Verdict}
    return ", ".join(f"{count} {verdict.value}" for verdict, count in counts.items())


def write_csv(path, results):
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["name", "scene", "asked", "observed", "verdict", "seconds"])
        for r in results:
            out.writerow([r.row.name, r.row.scene, r.row.asked, r.observed, r.verdict.value, f"{r.seconds:.1f}"])


def html_row(result):
    items = "".join(f'<li{" class=miss" if figure.holds is False else ""}>{html.escape(figure.text)}</li>'
                    for figure in result.figures)
    verdict = result.verdict.value
    return (f'<tr id="{result.row.name}"><td>{html.escape(result.row.scene)}</td>'
            f'<td>{html.escape(result.row.asked)}</td>'
            f'<td><ul>{items}</ul></td><td class="verdict {verdict}">{verdict}</td>'
            f'<td class=number>{result.seconds:.0f}</td></tr>')


def write_html(path, results, groups, facts):
    """`groups`: title -> its rows; `facts`: what made the report, name -> text."""
    by_row = {result.row.name: result for result in results}
    parts = ["<!doctype html><html lang=en><meta charset=utf-8><title>ritz: the stability report</title>",
             f"<style>{STYLE}</style><h1>The stability report</h1>",
             "<p>Stiff and extreme scenes, run through the programs. A row <b>holds</b> or <b>fails</b> at the gate "
             "that is asked; <b>reported</b> has no gate.</p>", f"<p><b>{summary(results)}</b></p>", "<table>",
             *(f"<tr><th>{html.escape(k)}</th><td><code>{html.escape(v)}</code></td></tr>" for k, v in facts.items()),
             "</table><table>", "<tr><th>scene<th>asked<th>observed<th>verdict<th>s</tr>"]
    for title, rows in groups.items():
        shown = [html_row(by_row[row.name]) for row in rows if row.name in by_row]
        if shown:
            parts += [f"<tr><th class=group colspan=5>{html.escape(title)}</th></tr>", *shown]
    path.write_text("\n".join([*parts, "</table></html>", ""]))
