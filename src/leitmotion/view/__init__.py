"""What does a person see: takes the nouns, returns text or figures, writes nothing."""

from leitmotion.view.calibration import plot_calibration
from leitmotion.view.curves import plot_dynamics
from leitmotion.view.graph import plot_graph
from leitmotion.view.graph_text import graph_document, graphml
from leitmotion.view.lanes import plot_shared_patterns
from leitmotion.view.motif_lanes import plot_motifs
from leitmotion.view.payload import page_payload
from leitmotion.view.plots import plot_figures, plot_matrix, plot_patterns
from leitmotion.view.report import report_page
from leitmotion.view.shared import shared_page, shared_payload
from leitmotion.view.symmetry import plot_symmetry, symmetry_image
from leitmotion.view.symmetry_payload import Mirroring

__all__ = [
    "Mirroring",
    "graph_document",
    "graphml",
    "page_payload",
    "plot_calibration",
    "plot_dynamics",
    "plot_figures",
    "plot_graph",
    "plot_matrix",
    "plot_motifs",
    "plot_patterns",
    "plot_shared_patterns",
    "plot_symmetry",
    "report_page",
    "shared_page",
    "shared_payload",
    "symmetry_image",
]
