"""`artgen generate -n`: output and errors."""

import pytest


def test_a_dataset_from_the_command_line(artgen_command) -> None:  # type: ignore[no-untyped-def]
    options = ("drawer", "-n", "2", "--format", "mjcf", "--textures", "none", "--no-certify", "--out", "set")
    first = artgen_command("generate", *options, "--jobs", "1")
    assert first.code == 0
    assert first.out.startswith("made 2 assets in ")
    assert first.out.endswith(" s each: set\n")
    assert first.err == ""
    again = artgen_command("generate", *options)
    assert again.out == "made 0 assets in 0 s, 2 were there: set\n"


def test_exit_code_reports_failed_assets(artgen_command) -> None:  # type: ignore[no-untyped-def]
    options = ("--format", "mjcf", "--textures", "none", "--tolerance", "0.01", "--on-collision", "fail")
    done = artgen_command("generate", "cabinet", "-n", "1", *options, "--out", "set")
    assert done.code == 1
    assert done.err.startswith("cabinet_0: cabinet_0: not proven with 10.000 mm to spare")
    assert done.err.count("\n") == 1
    assert done.out.endswith(", 1 cannot be made: set\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("door", "lamp"), "one asset is of one category, not door, lamp; give a number of assets with -n"),
        (("door", "-n", "2"), "-n makes a dataset: give its folder with --out DIRECTORY"),
        (("door", "-n", "2", "--out", "x", "--name", "x"), "--name is for one asset; those of a dataset are"),
        (("door", "-n", "0", "--out", "x"), "Input should be greater than or equal to 1"),
        (("dor", "-n", "2", "--out", "x"), "there is no category 'dor'. Did you mean 'door'?"),
    ],
)
def test_what_is_refused(artgen_command, arguments: tuple[str, ...], message: str) -> None:  # type: ignore[no-untyped-def]
    done = artgen_command("generate", *arguments)
    assert done.code == 2
    assert message in done.err
    assert done.err.count("\n") == 1
