# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages in Markdown: what they link to is there, and so are the headers that they name. README.md has at most 100 lines."""
import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MADE = {"build", "node_modules", "results"}  # folders that others fill


def anchors(text):
    """Of the headings, as GitHub makes them."""
    heads = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}


class Pages(unittest.TestCase):
    def setUp(self):
        pages = [path for path in ROOT.rglob("*.md") if not MADE & {*path.relative_to(ROOT).parts}]
        self.pages = {path: path.read_text(encoding="utf-8") for path in [*pages, ROOT / "results/README.md"]}
        self.gone = []

    def test_links_lead_somewhere(self):
        for page, text in self.pages.items():
            for link in re.findall(r"\]\(([^()\s]+)\)", text):
                file, _, anchor = link.partition("#")
                to = (page.parent / file).resolve() if file else page
                if "://" not in link and (not to.exists() or (anchor and anchor not in anchors(self.pages[to]))):
                    self.gone.append(f"{page.relative_to(ROOT)}: {link}")
        self.assertEqual(self.gone, [])

    def test_headers_that_are_named_are_there(self):
        folders = [ROOT, ROOT / "libcore", ROOT / "experiments"]
        for page, text in self.pages.items():
            for name in re.findall(r"`([a-z_/]+/[a-z_]+\.hpp)`", text):
                if page.name != "CHANGELOG.md" and not any((folder / name).exists() for folder in folders):
                    self.gone.append(f"{page.relative_to(ROOT)}: {name}")
        self.assertEqual(self.gone, [])

    def test_the_first_page_is_short(self):
        self.assertLessEqual(self.pages[ROOT / "README.md"].count("\n"), 100)


if __name__ == "__main__":
    unittest.main()
