# What Sphinx is told of the documentation. docs/make/pages.py puts this beside the pages.

import re

project = "libsf"
author = copyright = "the libsf authors"  # noqa: A001
with open("version.txt", encoding="utf-8") as file:
    release = version = re.sub(r"\s", "", file.read())
extensions = ["myst_parser"]
source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
exclude_patterns = ["_build"]
# Headings are links, three levels deep, and "..." stays three dots.
myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence"]
smartquotes = False
html_theme = "furo"
html_title = f"libsf {release}"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_copy_source = html_show_sourcelink = html_show_sphinx = False
highlight_language = "none"
c_id_attributes = []
toc_object_entries_show_parents = "hide"


def setup(app):
    """Formats that nobody colours are text."""
    from pygments.lexers.special import TextLexer
    for name in ("vtk", "session", "sh-session"):
        app.add_lexer(name, TextLexer)
