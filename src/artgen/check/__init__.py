"""Checks of assets: the certificate of their joint ranges, and everything that files can get wrong."""
