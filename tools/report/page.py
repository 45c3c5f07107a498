"""One HTML file of an index, its blocks, and the page's program."""

import html
import json

from tools.report.blocks import Blocks
from tools.viewer_bundle import bundle


def _json_in_html(index: dict) -> str:
    """JSON that no `</script>` in a name or text can end."""
    return json.dumps(index, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def page(title: str, index: dict, blocks: Blocks) -> str:
    """The whole file. It asks nothing of any network."""
    program, style = bundle()
    program = program.replace("</script", "<\\/script")
    data = "\n".join(
        f'<script type="application/octet-stream" id="surefoot-block-{name}">{text}</script>'
        for name, text in blocks.texts.items()
    )
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<link rel="icon" href="data:,">\n'
        f"<title>{html.escape(title)}</title>\n<style>{style}</style>\n</head>\n<body>\n"
        f'<div id="surefoot-app"></div>\n<script type="application/json" id="surefoot-index">{_json_in_html(index)}'
        f"</script>\n{data}\n<script>{program}</script>\n</body>\n</html>\n"
    )
