"""The catalog: categories by name, artgen's own and other packages'."""

import subprocess
import sys
from pathlib import Path

import pytest

import artgen
from artgen import catalog
from artgen.errors import BuildError, ParameterError


def test_names_are_sorted_and_found() -> None:
    names = catalog.categories()
    assert {"door", "handle"} <= set(names)
    assert list(names) == sorted(names)
    assert [catalog.find(name).name for name in names] == list(names)


def test_an_unknown_name_shows_the_nearest() -> None:
    with pytest.raises(ParameterError, match=r"there is no category 'dor'\. Did you mean 'door'\?"):
        catalog.find("dor")


def test_generate_takes_a_name_or_a_generator() -> None:
    @artgen.generator
    def cube(*, size: artgen.Float = artgen.uniform(0.1, 0.2)) -> artgen.Body:
        return artgen.part(artgen.box(size, size, size), "cube", artgen.material("oak"))

    asset = artgen.generate(cube, seed=3, size=0.15, name="die", base="free")
    assert (asset.name, asset.category, asset.seed, asset.base) == ("die", "cube", 3, "free")
    assert asset.parameters == {"size": 0.15}


def test_generate_refuses_what_is_no_category() -> None:
    with pytest.raises(ParameterError, match="the name of a category or a generator, got 5"):
        artgen.generate(5)  # type: ignore[arg-type]


PLUGIN = """
import artgen

@artgen.category(labels=("stool",))
def stool(*, height: artgen.Float = artgen.uniform(0.4, 0.5)) -> artgen.Body:
    '''A stool.'''
    return artgen.part(artgen.cylinder(0.15, height), "stool", artgen.material("oak"))
"""


def install_plugin(folder: Path, module: str, name: str = "stools") -> None:
    (folder / "shop_stools.py").write_text(PLUGIN)
    info = folder / "shop_stools-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: shop-stools\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(f"[artgen.categories]\n{name} = {module}\n")


def run_with_plugin(folder: Path, statement: str) -> subprocess.CompletedProcess[str]:
    script = f"import sys; sys.path.insert(0, {str(folder)!r}); import artgen; {statement}"
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", script], capture_output=True, text=True, check=False, timeout=60
    )


def test_another_package_brings_a_category(tmp_path: Path) -> None:
    install_plugin(tmp_path, "shop_stools")
    done = run_with_plugin(tmp_path, "sys.stdout.write(artgen.generate('stool', 2).name)")
    assert done.stdout == "stool_2", done.stderr


def test_a_broken_package_is_named_and_the_others_go_on(tmp_path: Path) -> None:
    install_plugin(tmp_path, "shop_tables")
    told = (
        "the categories in 'shop_tables' of the package shop-stools cannot be imported: ModuleNotFoundError"
    )
    done = run_with_plugin(tmp_path, "from artgen.cli import main; main(['list'])")
    assert done.returncode == 0
    assert done.stderr.startswith(f"warning: {told}")
    assert "\ndoor " in done.stdout
    done = run_with_plugin(tmp_path, "from artgen.cli import main; main(['info', 'stool'])")
    assert done.returncode == 2
    assert done.stderr.startswith("error: there is no category 'stool'")
    assert told in done.stderr


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("x = 1\nstool = y\n", "NameError: name 'y' is not defined at {file}:2"),
        ("x = 1\ndef stool(:\n", "SyntaxError: invalid syntax at {file}:2"),
        ("import artgen\nartgen.uniform(3, 1)\n", "low exceeds high; swap them at {file}:2"),
        ("raise SystemExit\n", "SystemExit: at {file}:1"),
    ],
)
def test_a_broken_package_shows_its_line(tmp_path: Path, text: str, told: str) -> None:
    install_plugin(tmp_path, "shop_stools", "stool")
    (tmp_path / "shop_stools.py").write_text(text)
    done = run_with_plugin(tmp_path, "from artgen.cli import main; main(['generate', 'stool'])")
    assert done.returncode == 2
    assert done.stderr.startswith(
        "error: the categories in 'shop_stools' of the package shop-stools cannot be"
    )
    assert done.stderr.endswith(told.format(file=tmp_path / "shop_stools.py") + "\n")


@pytest.mark.long
def test_a_package_cannot_take_the_name_of_a_category_of_artgen(tmp_path: Path) -> None:
    install_plugin(tmp_path, "shop_stools")
    (tmp_path / "shop_stools.py").write_text(PLUGIN.replace("def stool", "def door"))
    done = run_with_plugin(tmp_path, "from artgen.cli import main; main(['info', 'door'])")
    assert "opener" in done.stdout, done.stderr  # artgen's own
    done = run_with_plugin(tmp_path, "from artgen.cli import main; main(['list'])")
    assert "'door' is a category of artgen; rename the category at" in done.stderr
    assert f"{tmp_path / 'shop_stools.py'}:4" in done.stderr
    assert "A stool." not in done.stdout


@pytest.fixture
def category_file(tmp_path: Path) -> Path:
    file = tmp_path / "stools.py"
    file.write_text(PLUGIN)
    return file


def modules_of_files() -> set[str]:
    return {name for name in sys.modules if name.startswith("category_file_")}


def test_a_file_gives_its_category_and_enters_nothing_in_the_catalog(category_file: Path) -> None:
    found = catalog.load_file(category_file)
    assert (found.name, found.labels) == ("stool", ("stool",))
    assert found.generate(1).links[0].name == "stool"
    assert artgen.generate(str(category_file), 1).name == "stool_1"
    assert "stool" not in catalog.categories()


def test_an_edited_file_is_run_anew(category_file: Path) -> None:
    before = catalog.load_file(category_file).generate(1, certify=False)
    category_file.write_text(PLUGIN.replace("0.15", "0.16"))  # as long, within the same second
    assert catalog.load_file(category_file).generate(1, certify=False).mass > before.mass


def test_a_file_may_be_a_copy_of_an_installed_category() -> None:
    own = catalog.find("plier")
    copy = catalog.load_file(own.function.__code__.co_filename)
    assert (copy.name, copy is own, catalog.find("plier") is own) == ("plier", False, True)


def test_a_file_finds_the_modules_beside_it(category_file: Path) -> None:
    (category_file.parent / "stool_sizes.py").write_text("RADIUS = 0.12\n")
    category_file.write_text("from stool_sizes import RADIUS\n" + PLUGIN.replace("0.15", "RADIUS"))
    path = list(sys.path)
    try:
        bounds = catalog.load_file(category_file).generate(0).bounds()
    finally:
        sys.modules.pop("stool_sizes", None)
    assert bounds[1][0] == pytest.approx(0.12, rel=0.01)
    assert sys.path == path


def test_of_several_categories_one_is_picked(category_file: Path) -> None:
    category_file.write_text(PLUGIN + PLUGIN.replace("stool", "bench"))
    with pytest.raises(ParameterError, match=r"2 categories; pick one: stools\.py:stool or stools\.py:bench"):
        catalog.load_file(category_file)
    assert catalog.find(f"{category_file}:bench").name == "bench"
    with pytest.raises(ParameterError, match=r"defines no category 'bensh'\. Did you mean 'bench'\?"):
        catalog.load_file(f"{category_file}:bensh")
    named = category_file.rename(category_file.with_name("bench.py"))
    assert catalog.load_file(named).name == "bench"  # that of the file's name


@pytest.mark.parametrize(
    ("text", "error", "message"),
    [
        ("x = 1\n", BuildError, r"stools\.py defines no category; put @artgen\.category"),
        ("x = 1\ndef f(:\n", BuildError, r"^SyntaxError: invalid syntax\n  at .*stools\.py:2$"),
        ("def f():\n    return y\n\nf()\n", BuildError, r"^NameError: .*'y'.*\n  at .*stools\.py:2$"),
        ("import no_such\n", BuildError, r"^ModuleNotFoundError: .*'no_such'\n  at .*stools\.py:1$"),
        ("raise SystemExit(3)\n", BuildError, r"^SystemExit: 3\n  at .*stools\.py:1$"),
        ("import artgen\nartgen.uniform(2, 1)\n", BuildError, r"low exceeds high; .*\n  at .*stools\.py:2$"),
        (PLUGIN + PLUGIN, BuildError, r"the category 'stool' is defined twice, at .*stools\.py:\d+ and"),
        ("x = '\xff'\n", BuildError, r"stools\.py"),
    ],
)
def test_a_faulty_file_is_one_error_with_its_line(category_file: Path, text, error, message) -> None:
    category_file.write_text(text, encoding="latin-1")
    before = modules_of_files()
    with pytest.raises(error, match=message):
        catalog.load_file(category_file)
    assert len(modules_of_files() - before) == ("no category" in message)


def test_a_file_that_is_not_there() -> None:
    for path in ("nowhere.py", "README.md", "."):
        with pytest.raises(ParameterError, match=r"there is no Python file .*such as stapler\.py"):
            catalog.load_file(path)


def test_a_fault_in_a_categorys_body_has_its_line(category_file: Path, artgen_command) -> None:
    category_file.write_text(PLUGIN.replace("height)", "heihgt)"))
    result = artgen_command("generate", "stools.py")
    assert result.code == 2
    assert result.err.startswith("error: stool cannot be built: NameError: name 'heihgt' is not defined at ")
    assert result.err.endswith("stools.py:7\n")
    assert not Path("stool_0").exists()


@pytest.mark.long
def test_commands_take_files(category_file: Path, artgen_command) -> None:
    assert "height" in artgen_command("info", "stools.py").out
    assert artgen_command("generate", "stools.py", "--format", "urdf").out == "stool_0/stool_0.urdf\n"
    certified = artgen_command("certify", "stools.py", "--samples", "2", "--no-corners")
    assert (certified.code, certified.out[:6]) == (0, "stool:")
    many = artgen_command("generate", "stools.py", "-n", "2", "--out", "many")
    assert many.out.startswith("made 2 assets in ")
    assert {path.name for path in Path("many/stool").iterdir()} == {"stool_0", "stool_1"}
