"""Volumes over the first one, in the format of Documentation/SceneFormat.md."""

from .arguments import number, three_numbers
from .images import image_of
from .looks import channels_of, color_nodes, look_of, take_opacities

MOST_OVERLAYS = 3
KEYS = (
    "volume",
    "spacing",
    "preset",
    "color",
    "opacity",
    "opacity_unit_distance",
    "strength",
    "turn",
    "move",
)


def overlay_of(given):
    """Returns an overlay of a scene, and its image."""
    overlay = given if isinstance(given, dict) else {"volume": given}
    for key in overlay:
        if key not in KEYS:
            raise ValueError(f"overlays: expected keys of {', '.join(KEYS)}, found {key!r}")
    if "volume" not in overlay:
        raise ValueError('overlays: expected the key "volume"')
    image = image_of(overlay["volume"], overlay.get("spacing"))
    look = look_of(overlay.get("preset", "pet-hot"), image)
    if "color" in overlay:
        look["colors"] = color_nodes(overlay["color"])
    take_opacities(look, overlay.get("opacity"), overlay.get("opacity_unit_distance"))
    if "channels" in look:
        look["channels"] = channels_of(
            None, look["channels"], overlay.get("color"), overlay.get("opacity")
        )
    return {
        # The image replaces this file.
        "volume": {"file": "array"},
        "look": look,
        "opacity": number("strength", overlay.get("strength", 1.0), 0, 1),
        "placement": {
            key: list(three_numbers(key, overlay.get(key, (0.0, 0.0, 0.0)))) for key in ("turn", "move")
        },
    }, image


def overlays_of(overlays):
    """Returns the overlays of a scene, and their images."""
    pairs = [overlay_of(given) for given in overlays]
    if len(pairs) > MOST_OVERLAYS:
        raise ValueError(f"overlays: expected at most {MOST_OVERLAYS}, found {len(pairs)}")
    return [overlay for overlay, _ in pairs], [image for _, image in pairs]
