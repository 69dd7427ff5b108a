#!/usr/bin/env python3
"""The course as two books: pages and solutions.

    pdf.py FOLDER    writes course.pdf and solutions.pdf into a folder

A book is one page of HTML in the order of the course's table, which Chromium prints. Animated pictures show their first frame.
It needs Debian's python3-markdown and chromium.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import markdown

PAGES = pathlib.Path(__file__).resolve().parent

STYLE = """
@page { size: A4; margin: 20mm 18mm; }
body { font: 10.5pt/1.45 serif; }
h1 { break-before: page; font-size: 18pt; }
h1:first-child { break-before: auto; }
pre, code { font-size: 8.5pt; white-space: pre-wrap; }
pre { background: #f3f3f3; padding: 6pt; break-inside: avoid; }
table { border-collapse: collapse; break-inside: avoid; }
td, th { border: 0.5pt solid #999; padding: 2pt 5pt; text-align: left; vertical-align: top; }
img { max-width: 100%; max-height: 95mm; }
"""


def labs():
    """The labs in the order of the table in README.md."""
    readme = (PAGES / "README.md").read_text(encoding="utf-8")
    return re.findall(r"^\| *\d+ *\| *\[[^\]]*\]\((\w+)\.md\)", readme, flags=re.M)


def html_of(page):
    """A page as HTML. Links to other pages lead nowhere on paper: their words stay. Pictures have full addresses."""
    text = page.read_text(encoding="utf-8")
    text = re.sub(r"(?<!!)\[([^\]]+)\]\((?!http)[^)]+\)", r"\1", text)
    text = re.sub(r"\]\((images/[^)]+)\)", lambda found: f"]({(page.parent / found[1]).as_uri()})", text)
    return markdown.markdown(text, extensions=["tables", "fenced_code", "sane_lists"])


def write(book, title, pages):
    body = "\n".join(html_of(page) for page in pages)
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "book.html"
        source.write_text(f"<!doctype html><html lang='en'><head><meta charset='utf-8'><title>{title}</title>"
                          f"<style>{STYLE}</style></head><body>{body}</body></html>", encoding="utf-8")
        subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer",
                        f"--user-data-dir={folder}/profile", f"--print-to-pdf={book}", source.as_uri()],
                       check=True, stderr=subprocess.DEVNULL, timeout=300)
    if not book.exists() or not book.read_bytes().startswith(b"%PDF"):
        sys.exit(f"error: chromium wrote no {book}")
    print(book)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    write(folder / "course.pdf", "A course on contact mechanics",
          [PAGES / "README.md"] + [PAGES / f"{lab}.md" for lab in labs()] + [PAGES / "books.md"])
    write(folder / "solutions.pdf", "A course on contact mechanics: solutions",
          [PAGES / "solutions" / f"{lab}.md" for lab in labs()])


if __name__ == "__main__":
    main()
