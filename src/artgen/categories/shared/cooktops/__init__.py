"""Parts of cooktops, built in or on an oven: burners, grates, plans."""
