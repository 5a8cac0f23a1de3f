"""Commands of the command line, one module each; `artgen.cli` registers them."""
