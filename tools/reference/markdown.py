"""The little Markdown that the pages are made of."""

from collections.abc import Iterable


def cell(text: object) -> str:
    """Text in a table: what Markdown would read as its own is escaped."""
    escaped = str(text).replace("\\", "\\\\").replace("|", "\\|").replace("*", "\\*").replace("<", "\\<")
    return " ".join(escaped.split())


def code(text: object) -> str:
    return f"`{text}`".replace("|", "\\|")


def table(header: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A table; the cells are Markdown already."""
    header = list(header)
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def page(title: str, source: str, *parts: str) -> str:
    """A page that says where it is from and how to make it anew."""
    origin = f"Generated from {source} by `python -m tools.reference`: change the source, not this page."
    return "\n".join([f"# {title}\n", origin + "\n", *parts]).rstrip() + "\n"
