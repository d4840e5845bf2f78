"""What happened, for people: text, pictures, videos and a window."""
