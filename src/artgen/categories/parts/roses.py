"""Roses and plates: the fixed covers of the hole that a spindle passes."""
