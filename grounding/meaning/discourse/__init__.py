"""A text clause by clause: what is handled, what was only spoken of, what "it" is."""
