"""What does a person see: takes the nouns, returns text or figures, writes nothing."""

from leitmotion.view.payload import page_payload
from leitmotion.view.report import report_page

__all__ = ["page_payload", "report_page"]
