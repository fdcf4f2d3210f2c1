"""Settings of Sphinx for bin/developer/buildSite."""

project = "deformableParticles"
html_title = project
extensions = ["myst_parser"]
myst_heading_anchors = 6
# A page is plain Markdown: a line that begins with % is text
myst_disable_syntax = ["myst_line_comment", "myst_block_break", "myst_role", "myst_target"]
smartquotes = False
highlight_language = "none"
pygments_style = "default"
pygments_dark_style = "monokai"

html_theme = "furo"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_show_sourcelink = False
html_copy_source = False
html_show_copyright = False
