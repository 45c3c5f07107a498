"""The reference pages of docs/reference/, generated from their sources: `python -m tools.reference`."""
