"""Commands of the command line; `artgen.cli` registers them."""
