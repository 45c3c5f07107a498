"""Pictures of a run folder: `tools/surefoot plot RUN...`."""
