"""`surefoot report`: a recorded run, or two, as one HTML file that opens offline."""
