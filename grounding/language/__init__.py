"""From text to phrase trees: tokens, Penn tags, weighted CKY."""
