"""Tables of the parameters that were drawn, one for each category."""

from collections.abc import Iterable, Mapping
from importlib.util import find_spec
from io import BytesIO
from typing import Any

from artgen.dataset.target import Target

TABLE_DIRECTORY = "parameters"

_COMMON = ("name", "seed", "path", "attempt", "proven", "mass", "links")


def rows(records: Iterable[Mapping[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """Return a row for each asset that is done, by category: what all have, then its parameters."""
    found: dict[str, list[dict[str, Any]]] = {}
    for record in records:
        if record["state"] == "done":
            row = {name: record[name] for name in _COMMON}
            row |= {f"parameter.{name}": value for name, value in record["parameters"].items()}
            found.setdefault(record["category"], []).append(row)
    return {category: sorted(each, key=lambda row: row["seed"]) for category, each in found.items()}


def write_tables(target: Target, records: Iterable[Mapping[str, Any]]) -> None:
    """Write a Parquet table for each category, if pyarrow is there: `pip install artgen[data]`."""
    if find_spec("pyarrow") is None:
        return
    import pyarrow as pa
    from pyarrow import parquet

    for category, table in rows(records).items():
        names = dict.fromkeys(name for row in table for name in row)
        columns = {name: [row.get(name) for row in table] for name in names}
        content = BytesIO()
        parquet.write_table(pa.table(columns), content)
        target.write(f"{TABLE_DIRECTORY}/{category}.parquet", content.getvalue())
