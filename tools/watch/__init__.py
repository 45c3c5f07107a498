"""`surefoot watch`: the run that is going on, in the browser."""
