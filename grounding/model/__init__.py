"""The model: how likely each object or set is what a referent means, by learned weights of what its conditions say."""
