"""The parts of the page that rbcIbReport writes."""
