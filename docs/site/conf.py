# SPDX-License-Identifier: Apache-2.0
"""Sphinx configuration of the documentation site: `make docs`, result in build/docs."""
project = "Hawser"
author = "The Hawser authors"
copyright = "The Hawser authors"  # noqa: A001
release = "0.1"
extensions = ["myst_parser"]
root_doc = "docs/index"
include_patterns = ["docs/**", "README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
exclude_patterns = ["docs/site"]
# Links go to headings by their names, as on the pages of the repository.
myst_heading_anchors = 4
html_theme = "furo"
html_title = "Hawser"
