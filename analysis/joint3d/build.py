# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds Joint3D as one file: page, style, script and the library in WebAssembly. It loads nothing else, and a policy in its head
forbids it to.

Scripts are bundled by esbuild; three.js comes from analysis/node_modules.
"""

import argparse
import base64
import hashlib
import os
import re
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent


def bundle(first: str) -> str:
    """Bundles the page's own modules, from this one on, and what they use of three.js, as one script."""
    form = ["--bundle", "--minify", "--format=iife", "--target=es2020", "--charset=utf8", "--legal-comments=inline"]
    command = ["esbuild", first, *form, "--log-level=warning"]
    done = subprocess.run(command, cwd=HERE, check=True, stdout=subprocess.PIPE)
    return done.stdout.decode()


def embedded(script: str) -> str:
    """Returns a script that may stand between the tags of an HTML file."""
    return script.replace("</script", "<\\/script").replace("<!--", "<\\!--").strip()


def policy(script: str) -> str:
    """The policy: the page may run this very script, its own workers and WebAssembly, and show what it contains."""
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    rules = [
        "default-src 'none'",
        f"script-src 'sha256-{digest}' 'wasm-unsafe-eval'",
        "worker-src blob:",
        "style-src 'unsafe-inline'",
        "img-src data: blob:",
        "connect-src 'none'",
        "base-uri 'none'",
        "form-action 'none'",
    ]
    return "; ".join(rules)


def version() -> str:
    """The version of impinge, from CMake."""
    said = (HERE.parent.parent / "CMakeLists.txt").read_text()
    return re.search(r"^project\(\s*impinge\s+VERSION (\S+)", said, re.MULTILINE)[1]


def commit() -> str:
    """The commit of the sources, from the environment or git."""
    said = os.environ.get("IMPINGE_COMMIT")
    if said:
        return said
    done = subprocess.run(["git", "-C", str(HERE), "rev-parse", "HEAD"], capture_output=True, check=False, text=True)
    return done.stdout.strip() or "unknown"


def main() -> None:
    """Writes the page."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", type=Path, required=True, help="the library, compiled by emscripten into one script")
    parser.add_argument("--out", type=Path, required=True, help="the page")
    options = parser.parse_args()
    script = embedded(bundle("src/main.js"))
    engine = embedded(options.engine.read_text() + "\n" + (HERE / "src" / "worker.js").read_text())
    page = (HERE / "index.html").read_text()
    parts = {"@CSP@": policy(script), "@STYLE@": (HERE / "style.css").read_text(), "@ENGINE@": engine, "@VIEWER@": embedded(bundle("report/viewer.js")), "@SCRIPT@": script}
    page = page.replace("@VERSION@", version()).replace("@COMMIT@", commit())
    for mark, text in parts.items():
        page = page.replace(mark, text, 1)
    options.out.write_text(page)


main()
