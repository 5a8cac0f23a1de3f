"""Generators: assets, infeasible draws, the lines that errors name, calls between generators."""

import functools
import os
import pickle
import subprocess
import sys
from pathlib import Path

import pytest

from artgen.errors import ArtgenError, AssetError, BuildError, EvaluationError, InfeasibleError
from artgen.generator import Generator, generator, one_of
from artgen.graph import Cache
from artgen.nodes.body import detail, part
from artgen.nodes.handles import Body, Float, Solid
from artgen.nodes.joint import Revolute
from artgen.nodes.primitive import box, sphere
from artgen.nodes.scalar import require
from artgen.nodes.vector import X
from artgen.sampling import count, uniform
from support.generators import OAK, block, door, knob, lever, round_grip
from support.lines import place_of


def test_an_asset_knows_what_it_was_made_of():
    asset = door.generate(4, handle="lever", wood="pine", base="free", name="mine")
    assert (asset.name, asset.category, asset.seed, asset.attempt, asset.base) == (
        "mine",
        "door",
        4,
        0,
        "free",
    )
    assert asset.parameters["wood"] == "pine"
    assert asset.parameters["handle"] == "lever"
    assert asset.parameters["offset"] == [0.0, 0.0, 0.5]
    assert asset.joint("turn").limits == (0.0, asset.parameters["swing"])
    assert door.generate(4).name == "door_4"


def test_the_same_seed_gives_the_same_asset_with_any_cache():
    shared, fresh, small = door.generate(5), door.generate(5, cache=Cache()), door.generate(5, cache=Cache(3))
    assert shared.to_json() == fresh.to_json() == small.to_json()


def test_a_generator_is_pickled_by_its_name():
    assert pickle.loads(pickle.dumps(door)) is door  # noqa: S301 - its own bytes

    @generator
    def local() -> Body:
        return block()

    with pytest.raises((pickle.PicklingError, AttributeError)):
        pickle.dumps(local)


def test_a_second_asset_computes_only_what_changed():
    cache = Cache()
    door.evaluate(0, cache=cache, overrides={"handle": "lever"})
    _, again = door.evaluate(0, cache=cache, overrides={"handle": "lever"})
    assert not again.runs
    _, changed = door.evaluate(0, cache=cache, overrides={"handle": "lever", "swing": 0.25})
    assert set(changed.runs) == {"joint", "attach"}


def test_the_hash_seed_of_python_changes_no_byte(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(
        "import hashlib\nfrom support.generators import door\n"
        "for seed in range(3):\n"
        "    asset = door.generate(seed)\n"
        "    surfaces = [s.mesh for link in asset.links for s in link.surfaces]\n"
        "    arrays = [a for m in surfaces for a in (m.vertices, m.normals, m.uvs, m.triangles)]\n"
        "    data = b''.join(a.tobytes() for a in arrays)\n"
        "    print(hashlib.sha256(asset.to_json().encode() + data).hexdigest())\n"
    )
    paths = [str(Path(__file__).parent), *sys.path]
    outputs = {
        subprocess.run(
            [sys.executable, str(script)],
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join(paths)},
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        for seed in ("0", "4242")
    }
    assert len(outputs) == 1
    assert len(next(iter(outputs)).split()) == 3


@generator
def picky(*, size: Float = uniform(0.0, 1.0), panes: int = count(1, 4), least: Float = 0.5) -> Body:
    require(panes != 2, "two panes look odd")
    return part(box(panes, 1.0, size + 0.1), "block", OAK).require(size > least, "too small")


def test_infeasible_draws_are_drawn_again_and_counted():
    attempts = set()
    for seed in range(20):
        asset = picky.generate(seed)
        assert asset.parameters["size"] > 0.5
        assert asset.parameters["panes"] != 2
        attempts.add(asset.attempt)
        values = picky.sample(seed, attempt=asset.attempt)
        assert values["size"] == asset.parameters["size"]
        for earlier in range(asset.attempt):
            values = picky.sample(seed, attempt=earlier)
            assert values["size"] <= 0.5 or values["panes"] == 2
    assert len(attempts) > 2


def test_a_category_that_is_never_feasible_says_why():
    with pytest.raises(
        InfeasibleError,
        match=r"picky: none of 7 draws for seed 3 is feasible; the last: (too small|two panes)",
    ) as caught:
        picky.generate(3, attempts=7, least=2.0)
    assert f"\n  at {__file__}:" in str(caught.value)


def test_overrides_hold_through_every_attempt():
    assert picky.generate(11, panes=3).parameters["panes"] == 3
    with pytest.raises(InfeasibleError, match="two panes look odd"):
        picky.generate(11, panes=2)


def raises_at(marker, error, message, function, **overrides):
    with pytest.raises(error, match=message) as caught:
        generator(function).generate(0, **overrides)
    assert place_of(__file__, marker) in str(caught.value)
    return caught.value


def test_a_kernel_error_comes_with_the_seed():
    def leaf(*, width: Float = uniform(-2.0, -1.0)) -> Body:
        return part(box(width, 1.0, 1.0), "leaf", OAK)  # marker: kernel

    error = raises_at("marker: kernel", EvaluationError, "box failed", leaf)
    assert error.__notes__ == ["while generating leaf from seed 0, attempt 0"]


def test_an_unknown_leader_names_the_line_of_the_joint():
    def lid(*, ratio: Float = uniform(1.0, 2.0)) -> Body:
        pedal = Revolute("pedal", axis=X)
        turn = Revolute("lid", axis=X, follows=ratio * pedal)  # marker: leader
        return block("base").attach(block("lid"), turn)

    raises_at(
        "marker: leader", AssetError, "joint 'lid' follows 'pedal', which is not a joint of this asset", lid
    )


def test_an_unknown_leader_of_a_copy_names_the_line_of_the_joint():
    def lid() -> Body:
        pedal = Revolute("pedal", axis=X)
        turn = Revolute("lid", axis=X, needs=pedal > 0.5)  # marker: copy
        return block("base").repeat(block("lid"), turn, at=[(0, 0, 0)]).suffixed("_left")

    raises_at("marker: copy", AssetError, "joint 'lid_0_left' needs 'pedal'", lid)


def test_a_circle_of_couplings_names_a_line():
    def lid() -> Body:
        a, b = Revolute("a", axis=X), Revolute("b", axis=X)
        body = block("base").attach(block("x"), Revolute("a", axis=X, follows=b))  # marker: circle
        return body.attach(block("y"), Revolute("b", axis=X, follows=a))

    raises_at("marker: circle", AssetError, "the couplings of joints a, b form a circle", lid)


def test_a_link_without_mass_names_the_line_of_the_detail():
    def toy() -> Body:
        label = detail(box(1.0, 1.0, 1.0), "print", OAK)  # marker: detail
        return block("base").attach(label, Revolute("t", axis=X))

    raises_at("marker: detail", AssetError, "link 'print' consists of details only", toy)


def test_a_label_that_is_not_declared_names_the_line_of_the_part():
    def toy() -> Body:
        return block("dore")  # marker: label

    def block(label):
        return part(box(1.0, 1.0, 1.0), label, OAK)  # marker: made

    with pytest.raises(
        AssetError, match=r"carries the label 'dore', which toy does not declare\. Did you mean 'door'"
    ):
        Generator(toy, labels=("door",)).generate(0)
    with pytest.raises(AssetError) as caught:
        Generator(toy, labels=("door",)).generate(0)
    assert place_of(__file__, "marker: made") in str(caught.value)


def test_a_parameter_node_belongs_to_its_generator():
    (node,) = [node for node in round_grip.graph(0).nodes if node.op == "parameter"]
    assert node.where == round_grip.where


def test_a_result_that_is_no_body_is_refused():
    with pytest.raises(
        BuildError, match=r"round_grip returns a Solid; an asset needs a Body\n  at .*generators"
    ):
        round_grip.generate(0)

    def nothing() -> Body:
        return None

    with pytest.raises(BuildError, match=r"nothing returned None; it must return a handle such as a Body"):
        generator(nothing).generate(0)


def test_a_structural_parameter_is_known_and_a_socket_is_not():
    def toy(*, panes: int = count(2, 2), size: Float = uniform(0.1, 0.2)) -> Body:
        if size > 0.15:  # marker: socket
            return block("a")
        return block("b")

    error = raises_at("marker: socket", BuildError, "a handle used as a condition", toy)
    assert "annotate it int, str, bool or Literal" in str(error)


def test_a_chosen_generator_can_be_asked_for_and_compared():
    seen = []

    @generator
    def toy(*, handle: Generator = one_of(lever, knob)) -> Body:
        seen.append((handle.name, handle == lever, handle == knob, handle != knob, handle in [lever, 1]))
        return handle(thickness=0.1)

    toy.generate(0, handle="knob")
    assert seen == [("knob", False, True, False, False)]


def test_a_direct_call_hides_no_draw():
    with pytest.raises(BuildError) as caught:
        knob(thickness=0.1)
    assert "knob(...) needs a value for 'radius', which it would draw" in str(caught.value)
    assert "make the generator a parameter: knob: Generator = one_of(knob)" in str(caught.value)
    assert isinstance(knob(thickness=0.1, radius=0.02), Body)


def test_inputs_are_checked():
    with pytest.raises(BuildError, match=r"knob has no input 'thicknes'\. Did you mean 'thickness'\?"):
        knob(thicknes=0.1, radius=0.02)
    with pytest.raises(BuildError, match=r"knob needs the input 'thickness'\n  defined at .*generators.py:"):
        knob(radius=0.02)
    with pytest.raises(BuildError, match=r"lever needs the input 'thickness'"):
        lever.generate(0)


def test_defaults_that_are_handles_or_none_are_inputs():
    assert "axis" not in lever.parameters()
    assert "grip" not in knob.parameters()
    direct = knob(thickness=0.1, radius=0.02, grip=sphere(0.5))
    assert any(node.op == "sphere" and node.inputs["radius"] == 0.5 for node in [*direct.node.children])


def test_a_caller_may_give_what_would_be_drawn():
    @generator
    def toy(*, handle: Generator = one_of(knob)) -> Body:
        return handle(thickness=0.1, radius=0.25)

    assert toy.graph(0).parameters == ()


def test_input_names_may_be_any():
    @generator
    def toy(*, values: Float, prefix: Float, self: Float, seed: Float) -> Solid:
        return box(values, prefix, self + seed)

    @generator
    def whole(*, made: Generator = one_of(toy)) -> Body:
        return part(made(values=0.1, prefix=0.2, self=0.1, seed=0.2), "block", OAK)

    assert whole.generate(0).mass == pytest.approx(0.1 * 0.2 * 0.3 * OAK.density)


def test_every_error_is_an_artgen_error():
    for make in (
        functools.partial(door.sample, -1),
        functools.partial(door.sample, 0, overrides={"x": 1}),
        functools.partial(knob, radius=1.0),
        functools.partial(picky.generate, 0, least=5.0),
    ):
        with pytest.raises(ArtgenError):
            make()
