#!/usr/bin/env python3
"""The pages as a web site: gathers them for mkdocs, and checks what it made of them.

    site.py SOURCE     copies README.md, docs, scenarios and the notebooks of the course into a folder
    site.py --check SITE   every link and picture of the site leads somewhere in it, and nothing is fetched from elsewhere
"""

import html.parser
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parent.parent


def for_mkdocs(page):
    """GitHub begins a table at any line, Python's Markdown after an empty one."""
    lines, inside = [], False
    for line in page.split("\n"):
        inside ^= line.startswith("```")
        table = line.startswith("|") and not inside
        if table and lines and lines[-1].strip() and not lines[-1].startswith("|"):
            lines.append("")
        lines.append(line)
    return "\n".join(lines)


def index_of(folder, title):
    """A page for a folder that others link to: its pages by their titles."""
    rows = [f"- [{page.read_text(encoding='utf-8').split(chr(10), 1)[0].lstrip('# ')}]({page.name})"
            for page in sorted(folder.glob("*.md"))]
    (folder / "index.md").write_text(f"# {title}\n\n" + "\n".join(rows) + "\n", encoding="utf-8")


def gather(source):
    shutil.rmtree(source, ignore_errors=True)
    source.mkdir(parents=True)
    for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "CITATION.cff"):
        shutil.copy(ROOT / name, source)
    for name in ("docs", "scenarios"):
        shutil.copytree(ROOT / name, source / name, ignore=shutil.ignore_patterns("*.py", "drawings", "__pycache__"))
    course = source / "docs/course"
    subprocess.run([sys.executable, ROOT / "docs/course/notebooks.py", "-o", course], check=True,
                   stdout=subprocess.DEVNULL)
    for notebook in course.glob("*.ipynb"):
        page = notebook.with_suffix(".md")
        page.write_text(page.read_text(encoding="utf-8") + f"\n[This lab as a notebook]({notebook.name})\n",
                        encoding="utf-8")
    index_of(source / "docs/reference", "Reference")
    index_of(course / "solutions", "Solutions")
    for page in source.rglob("*.md"):
        page.write_text(for_mkdocs(page.read_text(encoding="utf-8")), encoding="utf-8")


class Page(html.parser.HTMLParser):
    """The anchors of a page, what it links to, and what a browser loads with it."""

    def __init__(self, file):
        super().__init__()
        self.anchors, self.links, self.loaded = set(), [], []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors.update(values[key] for key in ("id", "name") if values.get(key))
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        if tag in ("img", "script", "iframe", "source") and values.get("src"):
            self.loaded.append(values["src"])
        if tag == "link" and values.get("href") and values.get("rel") != "canonical":
            self.loaded.append(values["href"])


def check(site):
    pages = {file.resolve(): Page(file) for file in site.rglob("*.html")}
    wrong, seen = [], 0
    for file, page in pages.items():
        if file.name == "404.html":  # its links begin at the root of the server
            continue
        for link in page.links + page.loaded:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                if link in page.loaded and parts.scheme != "data":
                    wrong.append(f"{file}: loads {link}")
                continue
            seen += 1
            target = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if target.is_dir():
                target = target / "index.html"
            anchor = urllib.parse.unquote(parts.fragment)
            if not target.exists():
                wrong.append(f"{file}: {link} leads nowhere")
            elif anchor and anchor != "__top" and target in pages and anchor not in pages[target].anchors:
                wrong.append(f"{file}: {link}: the page has no such place")
    for style in site.rglob("*.css"):
        wrong += [f"{style}: loads {url}" for url in re.findall(r"url\(['\"]?(https?:[^)'\"]+)", style.read_text(encoding="utf-8"))]
    print("\n".join(wrong + [f"{len(pages)} pages, {seen} links and pictures, {len(wrong)} wrong"]))
    return 1 if wrong or not seen else 0


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--check":
        sys.exit(check(pathlib.Path(sys.argv[2])))
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    gather(pathlib.Path(sys.argv[1]))
