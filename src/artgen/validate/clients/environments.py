"""The environments that clients run in: some of their packages exclude each other, or artgen's own."""

from collections.abc import Mapping

REQUIREMENTS: Mapping[str, tuple[str, ...]] = {
    "bullet": ("pybullet>=3.2.7", "numpy"),
    "drake": ("drake>=1.51",),
    "genesis": ("genesis-world>=1.4.5", "torch"),
    "light": (
        "mujoco>=4.0",
        "omniverse-asset-validator>=1.18; python_version < '3.13'",
        "pin>=4.1",
        "simready-foundation-tier-core>=2026.8; python_version < '3.13'",
        "simready-validate>=2026.8; python_version < '3.13'",
        "usd-core>=26.11",
        "yourdfpy>=0.0.60",
    ),
    "mani_skill": ("mani_skill>=3.0.1",),
    "mjx": ("jax[cpu]", "mujoco-mjx[warp]>=3.17", "mujoco>=4.0"),
    "newton": ("newton[importers,sim]>=1.8", "trimesh"),
    "ovphysx": ("newton-usd-schemas", "ovphysx>=0.7", "physx-usd-schemas"),
    "robosuite": ("robosuite>=1.5",),
    "sapien": ("pillow", "sapien>=3.0.3"),
    "urchin": ("urchin>=0.0.30",),
    "usd_converters": ("mujoco-usd-converter>=0.8", "urdf-usd-converter>=0.3.4"),
}
"""What is installed in each environment. `light` is what `artgen[test]` brings into artgen's own."""
