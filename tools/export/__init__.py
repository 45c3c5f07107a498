"""A run in the formats of other programs: `tools/surefoot export RUN --to mcap|rerun|csv|parquet`."""
