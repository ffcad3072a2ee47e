"""`python -m crankstar` is the command line, and so is `crankstar`."""

import _thread
import gc
import os
import sys
import time

DRAWN = ("plot", "report")
"""Verbs for which vl-convert draws."""
OBJECTS = 500_000
"""New objects before garbage is looked for: loading makes many that stay."""


def main() -> None:
    """Run the command line; an interrupt while it is being loaded, or ends, ends it silently."""
    try:
        try:
            gc.set_threshold(OBJECTS)
            sys.unraisablehook = _again
            # it would read what is known of every installed package, for plug-ins that none needs
            os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")
            # matrices are small here: a second thread of numpy's waits for the first, at full speed
            os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
            _run()
        finally:
            _deaf()
    except KeyboardInterrupt:  # before it was deaf
        _deaf()
        raise SystemExit(130) from None
    finally:
        if "crankstar.charts.converter" in sys.modules:
            sys.modules["crankstar.charts.converter"].end()
        gc.freeze()  # what is left goes with the process, without being looked through


def _again(lost: "sys.UnraisableHookArgs") -> None:
    """Interrupt again where an interrupt came in a callback through which no exception passes.

    Python's import has one for each module: Ctrl-C would be lost while many are loaded.
    """
    if issubclass(lost.exc_type, KeyboardInterrupt):
        _thread.start_new_thread(_interrupt_soon, ())
    else:
        sys.__unraisablehook__(lost)


def _interrupt_soon() -> None:
    """Interrupt when the callback has ended."""
    time.sleep(0.01)
    _thread.interrupt_main()


def _run() -> None:
    if sys.argv[1:] and sys.argv[1] in DRAWN:
        from crankstar.charts.converter import begin

        begin()
    from crankstar.cli import main as run

    run()


def _deaf() -> None:
    """Ignore Ctrl-C from here on: all is done, and Python's own ending would print a traceback."""
    import signal

    signal.signal(signal.SIGINT, signal.SIG_IGN)


if __name__ == "__main__":
    main()
