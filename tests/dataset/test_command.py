"""`artgen generate -n`: output and errors."""


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
