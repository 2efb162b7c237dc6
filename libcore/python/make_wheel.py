#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""/usr/bin/python3 libcore/python/make_wheel.py FOLDER: makes a wheel of the module. It carries the libraries that the module needs,
each under a new name, and their licenses. The build needs no network, only the packages of `pip install` (libcore/README.md) and
patchelf. The wheel works with the same Python where glibc and libstdc++, which it does not carry, are no older than here."""
import hashlib
import re
import shutil
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

STAY = ("ld-linux", "libc.", "libm.", "libstdc++.", "libgcc_s.", "libpthread.", "libdl.", "librt.")


def run(*words):
    done = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{Path(sys.argv[0]).name}: {' '.join(map(str, words))}: failed, as the lines above say")
    return done.stdout


def libraries(module):
    """Where the libraries lie that a module or library needs, by name."""
    found = dict(re.findall(r"^\s*(\S+) => (\S+)", run("ldd", module), re.MULTILINE))
    return {name: Path(path).resolve() for name, path in found.items() if not name.startswith(STAY)}


def carry(module, licenses):
    """Puts the libraries beside the module, which then looks for them only there."""
    needed = libraries(module)
    own = {name: re.sub(r"\.so", f"-{hashlib.sha256(file.read_bytes()).hexdigest()[:8]}.so", name, count=1) for name, file in needed.items()}
    for name, file in needed.items():
        run("patchelf", "--set-soname", own[name], shutil.copyfile(file, module.parent / own[name]))
        package = run("dpkg", "-S", f"*/{file.name}").split(":")[0]
        shutil.copyfile(f"/usr/share/doc/{package}/copyright", licenses / package)
    for file in (module, *(module.parent / name for name in own.values())):  # patchelf mixes up two requests in one call
        run("patchelf", *(word for names in own.items() for word in ("--replace-needed", *names)), file)
        run("patchelf", "--set-rpath", "$ORIGIN", file)
    strange = [name for name, file in libraries(module).items() if file.parent != module.parent]
    if strange:
        sys.exit(f"make_wheel.py: {', '.join(strange)} would still be looked for in the system")


def main(folder):
    if not shutil.which("patchelf"):
        sys.exit("make_wheel.py: patchelf is missing: sudo apt-get install patchelf")
    here, out = Path(__file__).resolve().parent, Path(folder).resolve()
    out.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory() as work:
        run(sys.executable, "-m", "pip", "wheel", "--no-index", "--no-deps", "--no-build-isolation", "--wheel-dir", work, here)
        (wheel,) = Path(work).glob("*.whl")
        run(sys.executable, "-m", "wheel", "unpack", "--dest", work, wheel)
        (module,) = Path(work).glob("*/impinge/_impinge*.so")
        (info,) = module.parents[1].glob("*.dist-info")
        (info / "licenses").mkdir()
        carry(module, info / "licenses")
        run(sys.executable, "-m", "wheel", "pack", "--dest-dir", out, module.parents[1])
        print(out / wheel.name)


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    main(sys.argv[1])
