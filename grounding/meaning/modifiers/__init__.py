"""What modifiers say: by their form, by their own words, and by what they relate to."""
