"""`python -m crankstar` is the command line, and so is `crankstar`."""

import gc
import os

OBJECTS = 500_000
"""New objects before garbage is looked for: loading makes many that stay."""


def main() -> None:
    """Run the command line; an interrupt while it is still being loaded ends it without a word."""
    gc.set_threshold(OBJECTS)
    # it would read what is known of every installed package, to find plug-ins that none here needs
    os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
    try:
        from crankstar.cli import main as run

        run()
    except KeyboardInterrupt:
        raise SystemExit(130) from None
    finally:
        gc.freeze()  # what is left goes with the process, without being looked through


if __name__ == "__main__":
    main()
