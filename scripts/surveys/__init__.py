"""What many samples of a category are like: what they draw, what fails, how long they take, how they look."""
