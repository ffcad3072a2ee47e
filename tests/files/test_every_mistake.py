"""One refusal tells every mistake of a command line: each option, or its value, that is wrong."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path

import pytest

pytestmark = pytest.mark.quick

CASES = Path(__file__).parents[1] / "cases"
ENGINES = {
    "E": CASES / "match-engine.toml",
    "G": CASES / "genset-four.toml",
    "W": CASES / "single-on-wheels.toml",
}


@pytest.mark.parametrize(
    ("line", "told"),
    [
        (
            "balance i4 --factor x --radius y --speed z --shafts w",
            ("--factor x", '--radius is "y"', '--speed is "z"', "--shafts w"),
        ),
        (
            "balance i4 --weights x --shaft-planes y --limit z --minimise q",
            ("--weights x", "--shaft-planes", "--limit z", "--minimise q"),
        ),
        ("balance nosuch --factor x --speed z", ("nosuch", "--factor x", '--speed is "z"')),
        (
            "analyze i4 --speed x --orders 0 --reference q --theta z --by foo --speeds k --set bad",
            (
                "--speed, --theta, --by have no effect with --speeds",
                "--orders 0",
                '--reference is "q"',
                "--speeds k",
                "--set bad",
            ),
        ),
        (
            "analyze i4 --speed x --orders 0 --reference q --set bad",
            ('--speed is "x"', "--orders 0", '--reference is "q"', "--set bad"),
        ),
        ("analyze nosuch --set bad --theta z --by foo", ("nosuch", "--set bad", '"z"', "--by foo")),
        ("compare i4 i6 --speed x --orders 0", ('--speed is "x"', "--orders 0")),
        (
            "compare i4 nosuch --speed x --orders 0 --set bad",
            ('--speed is "x"', "--orders 0", "nosuch", "--set bad"),
        ),
        (
            "estimate nosuch --type x --displacement y",
            ("nosuch", "--type x", '--displacement is "y"'),
        ),
        ("estimate i4 --type x --displacement y", ("--type x", '--displacement is "y"')),
        (
            "derive i4 --orders 0 --quantity x --power -1",
            ("--orders 0", "--quantity x", "--power -1"),
        ),
        (
            "derive i4 --orders 0 --quantity x --power -1 --format y",
            ("--orders 0", "--quantity x", "--power -1", "--format y"),
        ),
        ("errata --source x -o y.bad", ("--source x", "-o y.bad")),
        ("sound i4 --rpm x --seconds 0 --pipe y", ("--rpm x", "--seconds 0", '--pipe is "y"')),
        ("animate i4 --size x --seconds -1", ("--size x", "--seconds -1")),
        ("animate i4 --size x --seconds -1 --view y", ("--size x", "--seconds -1", "--view y")),
        ("draw i4 --theta x --view y --size 0x0", ('--theta is "x"', "--view y", "--size 0x0")),
        ("export i4 --to x --theta y -o z.py", ("--to x", '--theta is "y"')),
        ("export nosuch --to ross --speed x -o z.py", ("nosuch", '--speed is "x"', "--to ross")),
        ("plot i4 nochart --speed x", ("chart nochart", '--speed is "x"')),
        (
            "plot nosuch over-turn --orders 0 --reference q --theme t -o a.bad",
            ("nosuch", "--orders 0", '--reference is "q"', "--theme t", "-o a.bad"),
        ),
        ("new foo -o x.bad", ("layout foo", "-o x.bad")),
        ("list --cylinders -1 --layout x", ("--cylinders -1", "--layout x")),
        (
            "sweep i4 --over a=1 --orders 0 --speed x --reference y",
            ("--over a=1", "--orders 0", '--speed is "x"', '--reference is "y"'),
        ),
        ("sweep nosuch --over a=1 --quantity q", ("nosuch", "--over a=1", "q cannot be computed")),
        ("verdict nosuch --speed x --set bad -o y.bad", ("nosuch", '"x"', "--set bad", "-o y.bad")),
        ("show nosuch --set bad -o y.bad", ("nosuch", "--set bad", "-o y.bad")),
        ("page nosuch --beside a --beside b -o x.bad", ("nosuch", "--beside a, b", "-o x.bad")),
        (
            "report nosuch --speed x --orders 0 -o x.bad",
            ("nosuch", '--speed is "x"', "--orders 0", "-o x.bad"),
        ),
        ("serve nosuch --port -1 --set bad", ("nosuch", "--port -1", "--set bad")),
        ("site nosuch -o -", ("nosuch", "-o -")),
        (
            "fault E --cut 9 --weaker 3=200% --heavier foo.1=2g --lost-weight 77",
            ("no cylinder 9", "--weaker 3=200%", "--heavier foo.1=2g", "no weight 77"),
        ),
        (
            "genset G --off 9 --weaker x=1 --pole-pairs 0",
            ("the number 9", "--weaker x=1", "--pole-pairs 0"),
        ),
        (
            "torque W --point x --imep '2 mm' --off x --flywheel '3 g'",
            ("operating point x", '--imep is "2 mm"', "--off x", '--flywheel is "3 g"'),
        ),
        (
            "search 99 --judge k --workers 0 --row 0 --bank 90 --speed x -o /nowhere/x.csv",
            ("not 99", "--judge k", "--workers 0", "--row 0", '--speed is "x"', "/nowhere/x.csv"),
        ),
        (
            "search i6 --minimise twist --orders 0 --why 1-2 --theme x --mode-shape 9 --fix 1=0",
            ("--theme", "--orders: 0", "--why: 1-2", "--mode-shape", "--fix"),
        ),
        ("analyze i4 --speed x -o /nowhere/x.csv", ('--speed is "x"', "/nowhere/x.csv: cannot")),
        ("derive i4 --orders 0 -o /nowhere/x.md", ("--orders 0", "/nowhere/x.md: cannot")),
        ("export nosuch -o/nowhere/x.py", ("nosuch: 1 mistake", "/nowhere/x.py: cannot")),
        ("sweep i4 --over x -o /nowhere/x.csv", ("--over x", "/nowhere/x.csv: cannot")),
        ("search nosuch --minimise Q --set bad", ("nosuch", "--minimise", "--set bad")),
        ("search 4 --best 0 --workers 0 --uneven 1", ("--best: 0", "--workers 0", "--uneven")),
        ("search i4 --speed x --row 0 --workers 0", ('--speed is "x"', "--row 0", "--workers 0")),
    ],
)
def test_one_refusal_tells_every_mistake(
    refused: Callable[..., str], line: str, told: tuple[str, ...]
) -> None:
    words = [str(ENGINES.get(word, word)) for word in shlex.split(line)]
    said = refused(*words)
    assert [each for each in told if each not in said] == []
    assert len(set(said.splitlines())) == len(said.splitlines())


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("sweep i4 --over balance_factor", "crankstar: --over balance_factor: give a field"),
        ("sweep i4 --over nokey=0..1", "crankstar: --over: i4: nokey is not a field"),
        ("sweep i4 --over 'speed=0..6000 rpm/3'", "crankstar: --over: the speed is 0 rpm"),
        ("orders i4 --tolerance '-1 deg'", "crankstar: --tolerance: the tolerance is -1 deg"),
        ("orders i4 --intervals 0", "crankstar: --intervals: the intervals 0, 0, 0, 0 deg"),
    ],
)
def test_a_refusal_names_its_option(refused: Callable[..., str], line: str, told: str) -> None:
    assert refused(*shlex.split(line)).startswith(told)
