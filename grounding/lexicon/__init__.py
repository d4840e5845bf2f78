"""Every concept once: the words that say it, its parameters, and how well it holds of objects or of any places."""
