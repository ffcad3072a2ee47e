"""The verb sound: a WAV file, and what is refused."""

from __future__ import annotations

import wave
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.commands import Run


def test_a_sound_is_a_wav_file_of_the_length_asked_for(run: Run, tmp_path: Path) -> None:
    words = ("--rpm", "800..6000", "--seconds", "0.5", "--pipe", "1=0.6 m", "--pipe", "80 cm")
    assert "Wrote v8.wav" in run("sound", "v8-cross-plane", "-o", "v8.wav", *words).err
    with wave.open(str(tmp_path / "v8.wav")) as file:
        assert (file.getnchannels(), file.getframerate(), file.getnframes()) == (2, 44100, 22050)


def test_without_a_name_the_file_has_that_of_the_engine(run: Run, tmp_path: Path) -> None:
    run("sound", "i4", "--seconds", "0.2")
    assert (tmp_path / "i4.wav").read_bytes()[:4] == b"RIFF"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--rpm", "0"), "--rpm 0: give speeds from 20 to 20,000 rpm"),
        (("--rpm", "1e9"), "too large for an engine"),
        (("--rpm", "30000"), "give speeds from 20 to 20,000 rpm"),
        (("--rpm", "9000..x"), "--rpm 9000..x: give a speed, or two with two full stops"),
        (("--rpm", "1..2..3"), "give a speed, or two with two full stops"),
        (("--rpm", ""), "give a speed, or two with two full stops"),
        (("--rpm", "-800..6000"), "give speeds from 20 to 20,000 rpm"),
        (("--rpm", "800 m"), "a rotational speed is needed"),
        (("--seconds", "61"), "--seconds 61: give a number from 0.2 to 60"),
        (("--seconds", "nan"), "--seconds nan: give a number from 0.2 to 60"),
        (("--pipe", "0.6"), '--pipe 0.6: write it with a unit, as in "0.8 m"'),
        (("--pipe", "0 m"), "--pipe 0 m: give a length from 0.05 to 20 m"),
        (("--pipe", "1=1 m", "--pipe", "1=2 m"), "is given twice"),
        (("--pipe", "1 m", "--pipe", "2 m"), "is given twice"),
        (("--pipe", "9=1 m"), "there is no exhaust of a cylinder 9"),
        (("-o", "v8.mp3"), "the name must end in .wav"),
        (("-o", "none/v8.wav"), "there is no such directory"),
    ],
)
def test_a_sound_that_cannot_be_is_refused_in_a_sentence(
    refused: Callable[..., str], words: tuple[str, ...], said: str
) -> None:
    told = refused("sound", "v8-cross-plane", *words)
    assert said in told
    assert len(told.splitlines()) == 1


def test_a_file_that_cannot_be_written_is_left_as_it_is(
    refused: Callable[..., str], tmp_path: Path
) -> None:
    (tmp_path / "kept.wav").mkdir()
    assert "it is a directory" in refused("sound", "i4", "-o", "kept.wav")


def test_speeds_may_have_a_unit_and_fall(run: Run, tmp_path: Path) -> None:
    for rpm in ("100..50 Hz", "3000…1000", "628 rad/s"):
        run("sound", "i4", "-o", "x.wav", "--seconds", "0.2", "--rpm", rpm)
        assert (tmp_path / "x.wav").stat().st_size > 44
