"""Metric goals become verified, timed plans."""
