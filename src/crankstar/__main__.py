"""`python -m crankstar` is the command line."""

from crankstar.cli import main

main()
