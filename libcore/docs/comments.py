# SPDX-License-Identifier: GPL-3.0-or-later
"""A header of libcore as Doxygen is to read it: its plain comments as documentation, line for line.

* The comment at the head of a file documents the file, and its first paragraph the class that is named like the file
  and has no comment.
* A comment right above a declaration documents it, and one behind it, too. Overloads right below each other share it.
* A table of terms, `//   name(x), other()   what they are`, in a comment of the header, or of one that it names,
  documents the declarations of these names that have no comment: so the concept SamplingScheme is explained once.
* What is defaulted or deleted, and equality, says all there is to say, and is left out.
"""
import re

from scopes import TEMPLATE, code_of, declarations
from terms import all_terms

LEFT_OUT = re.compile(r"= (?:default|delete);$|operator==")
CALLED = re.compile(r"(operator\s*\S+?|[\w:~]+)\s*\(")
VALUE = re.compile(r"(\w+)\s*(?:\[\w*\]\s*)*(?:[={;,]|$)")
SEVERAL = re.compile(r"\s*[\w:]+ \w+(?:, \w+)+;\s*$")
SILENT = re.compile(r"\s*(?:namespace|static_assert|friend (?:class|struct))\b")
TYPE = re.compile(r"\s*(?:class|struct|using|enum class|enum|concept)\s+([\w:]+)")


def escaped(text):
    """Text that Doxygen shows as it stands: no commands, no end of the brief after Eq., no links of first words."""
    text = re.sub(r'([\\@<>#&%*$"~])', r"\\\1", text)
    text = re.sub(r"\b(Eq|al)\. ", r"\1.\\ ", text)
    return re.sub(r"((?:^|[.:?] )\W*)([A-Z][a-z]+\b)", r"\1%\2", text)


def declared_name(code):
    """The name that a declaration gives."""
    code = TEMPLATE.sub("", code)
    if kind := TYPE.match(code):
        return kind[1]
    while (plain := re.sub(r"<[^<>]*>", "", code)) != code:
        code = plain
    found = CALLED.search(code) or VALUE.search(code)
    return found[1] if found else ""


def head_of(lines):
    """Places of the comment at the head of a file, after its licence."""
    end = 1
    while end < len(lines) and lines[end].startswith("//"):
        end += 1
    return range(1, end)


def comments_above(lines, first):
    """Places of the comment lines right above a line."""
    begin = first
    while begin > 0 and re.match(r"\s*//", lines[begin - 1]):
        begin -= 1
    return range(begin, first)


def comments_behind(lines, last):
    """Places of the comment behind a line: its own, and the lines below that go on with it."""
    code, mark, _ = lines[last].partition("  // ")
    if not mark or code.strip().startswith("}"):
        return range(0)
    end = last + 1
    while end < len(lines) and re.match(rf" {{{len(code) + 2}}}// ", lines[end]):
        end += 1
    return range(last, end)


def text_of(lines, places):
    """The words of the first paragraph of comments, without its tables and formulas."""
    words = []
    for k in places:
        comment = lines[k][lines[k].find("//") + 2 :]
        if words and (not comment.strip() or comment.startswith("   ")):
            break
        words.append(comment.strip())
    return " ".join(words)


def document_above(lines, places):
    """Makes whole lines of comments documentation; tables and formulas keep their layout."""
    text = [re.sub(r"^\s*// ?", "", lines[k]) for k in places]
    raw = [False] + [words.startswith("  ") for words in text] + [False]
    for n, k in enumerate(places):
        begin = " \\verbatim" if raw[n + 2] and not raw[n + 1] else ""
        end = " \\endverbatim" if raw[n + 1] and not raw[n + 2] else ""
        lines[k] = (text[n] if raw[n + 1] else escaped(text[n])).replace("*/", "* /") + begin + end
    lines[places[0]] = ("/** \\verbatim " if raw[1] else "/** ") + lines[places[0]]
    lines[places[-1]] += " */"


def document_behind(lines, places):
    """Makes a comment behind a declaration documentation of it, and of each where it declares several names."""
    for k in places:
        code, _, text = lines[k].partition("// ")
        if SEVERAL.match(code):
            code = code.replace(", ", f", /**< {escaped(text)} */ ")
        lines[k] = f"{code}///< {escaped(text)}"


class Documenter:
    """What is known of a header while its declarations are documented."""

    def __init__(self, path, root):
        self.plain = path.read_text(encoding="utf-8").splitlines()
        self.lines = list(self.plain)
        self.head = head_of(self.plain)
        self.terms = all_terms(path, root)
        self.stem = path.stem.replace("_", "")
        self.above = ("", "", -2)  # name, comment and last line of the declaration before

    def borrowed(self, name, code, first):
        """The comment of something else that stands for this declaration, too."""
        if (name, first - 1) == (self.above[0], self.above[2]):
            return self.above[1]
        if TYPE.match(TEMPLATE.sub("", code)) and name.lower() == self.stem and self.head:
            return text_of(self.plain, self.head)
        return self.terms.get(name, "")

    def document(self, first, last):
        """Documents the declaration on these lines."""
        code = " ".join(code_of(line) for line in self.plain[first : last + 1])
        above = [k for k in comments_above(self.plain, first) if k not in self.head and k > self.above[2]]
        behind = comments_behind(self.plain, last)
        name = declared_name(code)
        if LEFT_OUT.search(code.strip()):
            for k in [*above, *range(first, last + 1)]:
                self.lines[k] = ""
            return
        if above:
            document_above(self.lines, above)
        if behind:
            document_behind(self.lines, behind)
        text = text_of(self.plain, above or behind)
        if not text and (text := self.borrowed(name, code, first)):
            self.lines[first] = f"/** {escaped(text)} */ {self.lines[first]}"
        self.above = ("" if TYPE.match(TEMPLATE.sub("", code)) else name, text, max(last, *behind, last))


def documented(path, root):
    """Lines of a header below a root as Doxygen reads them."""
    header = Documenter(path, root)
    for first, last in declarations(header.plain):
        if not SILENT.match(code_of(header.plain[first])):
            header.document(first, last)
    if header.head:
        document_above(header.lines, header.head)
        header.lines[0], header.lines[1] = "/** \\file", header.lines[1][4:]
    return header.lines
