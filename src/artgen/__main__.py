"""`python -m artgen`: the command line."""

from artgen.cli import main

main()
