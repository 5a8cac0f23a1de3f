"""Take the graph of a door to JSON and back, evaluate it there, and draw it."""

from pathlib import Path

from artgen import Graph, catalog
from artgen.graph import Cache

door = catalog.find("door")
values = door.sample(seed=7)
graph = Graph(door.build(values))

text = graph.to_json()  # data only: reading it runs no code
again = Graph.from_json(text)
print(f"{len(graph.nodes)} nodes, {len(text) / 1e3:.0f} kB of JSON, same content: {again.key == graph.key}")

cache = Cache()
numbers = {name: values[name] for name in again.parameters}
first = again.evaluate(numbers, cache)
numbers["handle_height"] += 0.05  # only what depends on it is computed again
second = again.evaluate(numbers, cache)
print(f"{first.runs.total()} kernels ran at first, {second.runs.total()} after the handle went up")

out = Path("out")
out.mkdir(exist_ok=True)
(out / "door.mmd").write_text(graph.to_mermaid(), encoding="utf-8")  # paste into any Mermaid viewer
(out / "door_graph.py").write_text(graph.to_python("door"), encoding="utf-8")
print(f"drawn in {out / 'door.mmd'}, as Python in {out / 'door_graph.py'}")
