"""The table of concepts, and the page that documents it."""
