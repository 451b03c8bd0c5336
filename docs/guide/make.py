# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the user guide as HTML: make.py FOLDER [TUTORIALS]

TUTORIALS is where their scripts have left pictures and state files, made with the data in the folder that PALPATE_DATA names;
without it the pages show the tree's pictures. Needs python3-markdown and reads docstrings without importing anything.
"""

import ast
import os
import re
import shutil
import sys
from html import escape
from pathlib import Path

import markdown
from markdown.extensions.toc import slugify

ROOT = Path(__file__).resolve().parents[2]
PAGES = ["docs/guide/README.md", *(f"docs/guide/{name}.md" for name in ("skull", "brain", "soft-brain", "spatula", "stone", "wire", "flow", "labyrinth", "api")),
         *(f"docs/{name}.md" for name in ("touching", "fields", "servers", "tools", "soft", "mechanisms", "program", "devices", "first-arm", "regression", "faults", "glossary")),
         "plugin/README.md", "README.md"]
DOCUMENTED = ["filters/pipeline/python/testing/__init__.py", "filters/pipeline/python/testing/compare.py",
              "filters/views/python/simple.py"]
# Where the help of a page of the panel is. A browser that is started with the name of a file does not get a heading with it: each
# page of the panel has a file of its own, panel-NAME.html, that leads to the heading.
PANEL = {"main": "plugin-README.html#what-it-sets", "contact": "plugin-README.html#what-is-touched-measured",
         "material": "touching.html#arrays-on-surfaces", "field": "fields.html", "lines": "touching.html#lines-in-space",
         "tool": "tools.html", "tissue": "soft.html", "mechanism": "mechanisms.html", "device": "devices.html",
         "view": "plugin-README.html#with-the-mouse", "stability": "plugin-README.html#why-a-wall-shakes-and-what-to-do",
         "state": "plugin-README.html#what-it-shows", "scene": "touching.html"}
DATA = "data/cache"  # below the folder where a script of the guide is run
STYLE = ("body{max-width:60em;margin:2em auto;padding:0 1em;font-family:sans-serif;line-height:1.5}img{max-width:100%}"
         "pre{background:#f4f4f4;padding:.7em;overflow:auto}table{border-collapse:collapse}td,th{border:1px solid #ccc;padding:.3em .6em}")


def html_name(page):
    """Where a page of the tree lies in the guide."""
    return "index.html" if page == PAGES[0] else page.removeprefix("docs/").replace("/", "-").removesuffix(".md") + ".html"


def api():
    """Every public function with a docstring, its arguments and the docstring."""
    parts = []
    for file in DOCUMENTED:
        tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
        package, name = ("palpate.testing", Path(file).stem) if "/testing/" in file else ("palpate", Path(file).stem)
        parts.append(f"<h2>{package if name == '__init__' else f'{package}.{name}'}</h2><pre>{escape(ast.get_docstring(tree))}</pre>")
        for node in tree.body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_") and ast.get_docstring(node):
                arguments = f"({ast.unparse(node.args)})" if isinstance(node, ast.FunctionDef) else ""
                parts.append(f"<h3><code>{escape(node.name + arguments)}</code></h3><pre>{escape(ast.get_docstring(node))}</pre>")
    return "".join(parts)


def with_links(page, text, out):
    """Links among the pages lead to their HTML, pictures are copied, and other targets are named instead."""

    def replaced(match):
        attribute, target, anchor = match.groups("")
        if re.match(r"https?:", target) or not target or target.endswith(".pvsm"):
            return match[0]
        aim = (ROOT / page).parent.joinpath(target).resolve()
        if attribute == "src":
            if not (out / "pictures" / aim.name).exists():  # one that was just made is newer than the tree's
                shutil.copy(aim, out / "pictures" / aim.name)
            return f'src="pictures/{aim.name}"'
        name = str(aim.relative_to(ROOT))
        return f'href="{html_name(name)}{anchor}"' if name in PAGES else f'title="{escape(name)}"'

    return re.sub(r'(href|src)="([^"#]*)(#[^"]*)?"', replaced, text)


def write_page(page, out):
    source = (ROOT / page).read_text(encoding="utf-8")
    title = re.search(r"^# (.*)$", source, re.MULTILINE)[1].replace("`", "")
    body = markdown.markdown(source, extensions=["tables", "fenced_code", "toc"])
    body = re.sub(r"<p><strong>([^<]*)\.</strong>", lambda lead: f'<p id="{slugify(lead[1], "-")}"><strong>{lead[1]}.</strong>', body)
    if page == "docs/guide/api.md":
        body += api()
    state = f"pictures/{Path(page).stem}.pvsm"
    if page.startswith("docs/guide/") and (out / state).exists():
        body += f'<p><a href="{state}">The state file</a>, for ParaView\'s <em>File &gt; Load State</em></p>'
    navigation = '<p><a href="index.html">Palpate: the user guide</a></p>' if page != PAGES[0] else ""
    (out / html_name(page)).write_text(
        f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title><style>{STYLE}</style></head>'
        f"<body>{navigation}{with_links(page, body, out)}</body></html>\n", encoding="utf-8")


def write_panel(out):
    for name, target in PANEL.items():
        (out / f"panel-{name}.html").write_text(
            f'<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Palpate: the page {name.capitalize()} of the panel</title>'
            f'<meta http-equiv="refresh" content="0; url={target}"></head><body><a href="{target}">The guide</a></body></html>\n',
            encoding="utf-8")


def copy_made(tutorials, pictures):
    """Pictures as they are; state files name their data as the scripts do, so that they open in any copy of the tree."""
    for picture in tutorials.glob("*.png"):
        shutil.copy(picture, pictures)
    data = Path(os.environ.get("PALPATE_DATA", ROOT / DATA))
    for state in tutorials.glob("*.pvsm"):
        text = state.read_text(encoding="utf-8").replace(f'"{data}/', f'"{DATA}/')
        (pictures / state.name).write_text(text, encoding="utf-8")


def main(folder, tutorials=None):
    out = Path(folder)
    (out / "pictures").mkdir(parents=True, exist_ok=True)
    if tutorials:
        copy_made(Path(tutorials), out / "pictures")
    for page in PAGES:
        write_page(page, out)
    write_panel(out)


if __name__ == "__main__":
    main(*sys.argv[1:])
