"""Parts of household appliances: finishes, racks, cords."""
