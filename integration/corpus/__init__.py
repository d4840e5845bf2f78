"""Generated corpora: worlds settled by physics, annotated instructions, images and videos."""
