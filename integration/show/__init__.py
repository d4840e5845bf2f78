"""Text, pictures, videos and a window that show people what happened."""
