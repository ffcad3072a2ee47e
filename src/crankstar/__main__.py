"""`python -m crankstar` is the command line, and so is `crankstar`."""


def main() -> None:
    """Run the command line; an interrupt while it is still being loaded ends it without a word."""
    try:
        from crankstar.cli import main as run
    except KeyboardInterrupt:
        raise SystemExit(130) from None
    run()


if __name__ == "__main__":
    main()
