"""Pictures of what commands print as JSON; one file a picture, each with `figure(result)`."""
