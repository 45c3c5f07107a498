"""One file a picture; each has `figure(run, window)`, and rows that the overview draws as well."""
