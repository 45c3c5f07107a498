"""A run as a folder of CSV or Parquet files, one a table."""

from pathlib import Path

import pyarrow
import pyarrow.csv
import pyarrow.parquet

from tools.export.run_files import RunFiles
from tools.export.tables import Columns, tables


def _write(path: Path, columns: Columns, texts: dict[str, str]) -> None:
    table = pyarrow.table({name: pyarrow.array(values) for name, values in columns.items()})
    if path.suffix == ".csv":
        pyarrow.csv.write_csv(table, path)
    else:
        pyarrow.parquet.write_table(table.replace_schema_metadata(texts), path, compression="zstd")


def write_tables(run: RunFiles, folder: Path, kind: str) -> None:
    """Writes NAME.csv or NAME.parquet; a Parquet file carries scenario.toml and verdict.json as its metadata."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, columns in tables(run):
        _write(folder / f"{name}.{kind}", columns, run.texts)
