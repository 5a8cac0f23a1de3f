"""Study what is drawn: lever length against the distance from handle to hinge, by default and widened."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from artgen import catalog, uniform

door = catalog.find("door")
levers = {"opener": "lever"}
widened = levers | {"width": uniform(0.60, 1.25), "handle.lever_handle.length": uniform(0.08, 0.25)}

figure, axes = plt.subplots()
for label, overrides in (("default", levers), ("widened", widened)):
    # drawing parameters needs no geometry: some hundred draws a second
    draws = [door.sample(seed, overrides=overrides) for seed in range(400)]
    distance = np.array([draw["width"] - draw["backset"] for draw in draws])
    length = np.array([draw["handle.length"] for draw in draws])
    axes.scatter(distance, length, s=8, label=label)
    print(
        f"{label}: distance {distance.min():.3f} to {distance.max():.3f} m, "
        f"length {length.min():.3f} to {length.max():.3f} m, "
        f"correlation {np.corrcoef(distance, length)[0, 1]:+.2f}"
    )
axes.set_xlabel("handle to hinge [m]")
axes.set_ylabel("lever length [m]")
axes.legend()

out = Path("out")
out.mkdir(exist_ok=True)
figure.savefig(out / "lever_length.png", dpi=150)
print(f"plotted in {out / 'lever_length.png'}")
