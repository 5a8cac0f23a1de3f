"""Parts that several categories use, by family."""
