"""The categories: each module defines the one of its name, and importing it enters that in the catalog."""
