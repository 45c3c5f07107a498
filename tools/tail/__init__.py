"""`surefoot tail`: the events of a run in the terminal, as they come or as they were recorded."""
