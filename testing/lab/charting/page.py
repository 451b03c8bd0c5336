# SPDX-License-Identifier: GPL-3.0-or-later
"""One static page: verdicts first, then every chart with how to read it, then every number."""

import html

STYLE = """
body { font: 15px/1.5 sans-serif; max-width: 1080px; margin: 2em auto; padding: 0 1em; color: #222; }
img { max-width: 100%; height: auto; } h2 { margin-top: 2em; }
table { border-collapse: collapse; font-size: 12px; } td, th { padding: 2px 8px; text-align: left; border-bottom: 1px solid #ddd; }
.fail { color: #b00; font-weight: bold; } .absent { color: #777; } .pass { color: #060; }
figcaption { color: #444; } summary { cursor: pointer; margin: .4em 0; }
"""


def short(value):
    return "" if value is None else f"{value:.6g}"


def verdicts(tables):
    rows = [row for table in tables.values() for row in table]
    judged = [row for row in rows if row.verdict in ("pass", "fail")]
    failed = [row for row in judged if row.verdict == "fail"]
    absent = sorted({f"{row.experiment}: {row.method}" for row in rows if row.verdict == "absent"})
    parts = [f"<p><b>{len(judged) - len(failed)} of {len(judged)} verdicts passed</b> in {len(tables)} experiments.</p>"]
    if failed:
        parts.append("<h2 class='fail'>What failed</h2>" + table_of(failed))
    if absent:
        parts.append("<p class='absent'>Left out, an optional library is not installed: " + html.escape("; ".join(absent)) + ".</p>")
    return "\n".join(parts)


def table_of(rows):
    head = "".join(f"<th>{name}</th>" for name in ("case", "method", "quantity", "value", "unit", "truth", "limit",
                                                   "verdict", "p50 [µs]", "p99 [µs]", "most [µs]"))
    lines = []
    for row in rows:
        quantity = row.quantity + (", at least" if row.at_least else "")
        cells = [row.case, row.method, quantity, short(row.value), row.unit, short(row.truth), short(row.pass_line)]
        lines.append("<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in cells) +
                     f"<td class='{row.verdict}'>{row.verdict}</td><td>{short(row.cost_us_p50)}</td>"
                     f"<td>{short(row.cost_us_p99)}</td><td>{short(row.cost_us_most)}</td></tr>")
    return f"<table><tr>{head}</tr>{''.join(lines)}</table>"


def page(tables, charts, missing):
    """charts: (name, title, caption); missing: (title, why)."""
    parts = ["<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>Palpate: the lab</title>",
             f"<style>{STYLE}</style></head><body><h1>Palpate: speed against accuracy, and stability where methods fail</h1>",
             "<p>Every number comes from a simulation in virtual time with a truth that is not ours: a formula or an exact "
             "oracle. Costs are wall-clock times of this machine and this run; compare them with each other, not with "
             "another page.</p>", verdicts(tables)]
    for name, title, caption in charts:
        parts.append(f"<h2>{html.escape(title)}</h2><figure><a href='{name}.svg'><img src='{name}.png' alt='{html.escape(title)}'></a>"
                     f"<figcaption>{html.escape(caption)}</figcaption></figure>")
    for title, why in missing:
        parts.append(f"<h2>{html.escape(title)}</h2><p class='absent'>Not drawn: {html.escape(why)}.</p>")
    parts.append("<h2>Every number</h2>")
    for experiment, rows in sorted(tables.items()):
        failed = sum(row.verdict == "fail" for row in rows)
        mark = f" <span class='fail'>{failed} failed</span>" if failed else ""
        told = [row for row in rows if not row.quantity.startswith("map: ")]  # of maps there is the chart
        drawn = f", {len(rows) - len(told)} of them drawn as maps alone" if len(told) < len(rows) else ""
        parts.append(f"<details><summary>{html.escape(experiment)}: {len(rows)} rows{drawn}{mark}</summary>{table_of(told)}</details>")
    parts.append("</body></html>\n")
    return "\n".join(parts)
