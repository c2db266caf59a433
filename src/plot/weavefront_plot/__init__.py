"""Pictures of a Weavefront run."""
