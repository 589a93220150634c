"""The kinds of scenes, and the objects and setters that each is for."""

from scenes import (
    Kind,
    accumulated,
    blended,
    by_shaders,
    in_blocks,
    in_shadows,
    in_two_renderers,
    labelled,
    occluded,
    of_components,
    of_two_values,
    overlapping,
    uneven,
)

KINDS = {
    "labelled": Kind(labelled, {"mask", "label opacity", "gradient"}),
    "shadows": Kind(
        in_shadows,
        {
            "mask",
            "mapper.SetMaskInput",
            "mapper.SetMaskType",
            "mapper.SetMaskBlendFactor",
            "mapper.SetShadowStrength",
            "mapper.SetErrorTolerance",
            "mapper.AddClippingPlane",
        },
        searches=True,
    ),
    "occluded": Kind(
        occluded,
        {"plane", "mapper.SetAmbientOcclusion", "mapper.SetAmbientOcclusionReach"},
        searches=True,
    ),
    "shaders": Kind(by_shaders, {"property"}),
    "accumulated": Kind(accumulated, {"sun"}, drawings=3),
    "blocks": Kind(in_blocks, {"image"}),
    "two values": Kind(of_two_values, {"two values"}),
    "components": Kind(of_components, {"color"}),
    "uneven": Kind(uneven, {"image"}),
    "overlapping": Kind(overlapping, {"other property", "other opacity"}),
    "two renderers": Kind(in_two_renderers, {"other camera"}),
    "maximum": Kind(blended(1)),
    "average": Kind(blended(3)),
    "isosurfaces": Kind(blended(5)),
    "slice": Kind(blended(6), {"slice"}),
}
