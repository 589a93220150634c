#ifndef Varimarch_Core_Recipe_RenderSettings_h
#define Varimarch_Core_Recipe_RenderSettings_h

#include <algorithm>
#include <vector>

namespace varimarch
{

/// What lets a ray skip samples.
enum class Acceleration
{
  Off,          ///< every step has the sample distance
  ScalarField,  ///< jumps across blocks where the scalar stays within a tolerance
  OpticalField, ///< jumps across bricks by what the transfer function makes of them
};

/// How a composite is integrated along a segment of the ray. Samples per segment are what the
/// sample distance makes them, so that the rules compare at equal cost in texture fetches. Of
/// materials that depend on more than one value there are midpoints and what is linear between two
/// samples, which all other rules then are.
enum class Integration
{
  Midpoint,      ///< homogeneous, as in the middle; order 2
  PreIntegrated, ///< linear between samples: the transfer function exact, or a material in four
                 ///< parts; order 2
  Simpson,       ///< parabolas of extinction through three samples; order 4 where all is smooth
  PublishedSum,  ///< the sample at the beginning, repeated; order 1: for comparison
};

/// How the samples along a ray become a pixel.
enum class Blend
{
  Composite,        ///< emission and absorption, front to back
  MaximumIntensity, ///< the largest value along the ray, through the transfer function
  MinimumIntensity, ///< the smallest
  AverageIntensity, ///< the mean of opacity times value
  Additive,         ///< the integral of opacity times value
  Isosurface,       ///< surfaces of equal value
  Slice,            ///< what lies on one surface
};

/// Whether one value of a ray decides on its pixel.
inline bool IsExtreme(Blend blend)
{
  return blend == Blend::MaximumIntensity || blend == Blend::MinimumIntensity;
}

/// What the components of a volume are.
enum class Components
{
  One,
  Independent,      ///< two to four materials, mixed
  LuminanceOpacity, ///< two: colour and opacity of one material
  Rgba,             ///< four: a colour, and opacity
};

/// Whether what is drawn of a ray lies on surfaces, which are found exactly.
inline bool IsOfSurfaces(Blend blend)
{
  return blend == Blend::Isosurface || blend == Blend::Slice;
}

/// Whether a pixel is made of values along its ray, not of colours.
inline bool IsProjection(Blend blend)
{
  return blend != Blend::Composite && !IsOfSurfaces(blend);
}

/// What a transfer function is a function of.
enum class FunctionOf
{
  Value,
  ValueAndGradient,
  TwoValues,
};

/// What a second volume says of each voxel.
enum class Mask
{
  None,
  Binary, ///< whether it is drawn
  Labels, ///< which transfer functions show it; composite of one component only
};

/// Who marches the rays of a picture.
enum class Marcher
{
  Device,    ///< the graphics device, by a shader
  Processor, ///< packets of rays: Core/Packets
};

/// When rays are marched, beside a drawing:
enum class Marching
{
  Within, ///< it, by its shader
  After,  ///< by the processor, which it tells where they begin and end,
  Before  ///< or whose colours it shows
};

/// What one drawing does for the rays of a picture.
enum class RayPass
{
  Whole,       ///< all: the volume is one block
  Block,       ///< marches them through one of several blocks, from where those in front have ended
  Picture,     ///< makes pixels of what they have gathered in all blocks
  Upscaled,    ///< makes pixels of a picture drawn with fewer rays,
  Averaged,    ///< or with more,
  Accumulated, ///< or of several that have been added up
  PeelOutside, ///< as Whole, but in front of all translucent geometry and behind it,
  PeelBetween, ///< between two pairs of its layers,
  PeelLast,    ///< or between its innermost layers
  PickProp,    ///< as Whole, but the number of the volume,
  PickVoxel,   ///< or of the point or cell that a ray meets
  PictureAndDepth, ///< as Whole, and how deep that is
};

/// Whether translucent geometry divides the rays in it.
inline bool Peels(RayPass pass)
{
  return pass == RayPass::PeelOutside || pass == RayPass::PeelBetween || pass == RayPass::PeelLast;
}

/// Whether no other has drawn a part of the same picture before it.
inline bool BeginsPicture(RayPass pass)
{
  return pass != RayPass::PeelBetween && pass != RayPass::PeelLast;
}

/// Whether what is drawn is the number of something.
inline bool Picks(RayPass pass)
{
  return pass == RayPass::PickProp || pass == RayPass::PickVoxel;
}

/// Whether what is drawn tells a place along the ray.
inline bool Locates(RayPass pass)
{
  return pass == RayPass::PickVoxel || pass == RayPass::PictureAndDepth;
}

/// Every choice that changes the shader. Values (a tolerance, a step length) are not here: they
/// are uniforms, and changing them rebuilds nothing.
struct RenderSettings
{
  Blend blend = Blend::Composite;
  Acceleration acceleration = Acceleration::OpticalField;
  bool shading = false;                            ///< Blinn-Phong; composite and surfaces only
  bool sceneGeometry = false;                      ///< stop rays at opaque geometry already drawn
  Integration integration = Integration::Midpoint; ///< of a composite
  bool nearest = false;                            ///< voxels are boxes of one value
  bool cubic = false;                              ///< a spline through the voxels, not nearest
  bool uneven = false;                             ///< voxels are at uneven places
  bool clipping = false;                           ///< end rays at clipping planes
  bool cropping = false;                           ///< leave out regions of the volume
  bool clippedGradients = false; ///< gradients see a cut as a surface; one component only
  bool gaps = false;             ///< leave out cells that touch a voxel that is not finite,
  bool fillGaps = false;         ///< or draw them in a colour of their own; composite only
  bool countFetches = false;     ///< draw how often each ray has read the volume, not the picture
  bool skipsBricks = true;       ///< composites with the optical field: there is enough to skip
  RayPass pass = RayPass::Whole;
  Marching marching = Marching::Within;
  bool damping = false; ///< shading without light where there hardly is a gradient; one component
  bool lights = false;  ///< shading by all lights of the scene, not by a head light alone
  Mask mask = Mask::None;
  FunctionOf functionOf = FunctionOf::Value; ///< else of one component, and composite
  Components components = Components::One;
  int componentCount = 1;       ///< of the volume
  bool gradientOpacity = false; ///< opacity depends on the gradient; composite only
  bool jitter = false;          ///< begin rays with a part of a step
  bool windowLevel = false;     ///< scale the picture's colours
  bool overlaps = false;        ///< is marched together with other volumes; composite only,
  std::vector<RenderSettings> others = {}; ///< which are these, where it is the first of them
};

/// Whether the volume is read in a drawing.
inline bool Marches(const RenderSettings& settings)
{
  const RayPass pass = settings.pass;
  return settings.marching == Marching::Within && pass != RayPass::Picture &&
    pass != RayPass::Upscaled && pass != RayPass::Averaged && pass != RayPass::Accumulated;
}

/// Whether rays are sampled: steps then decide on a picture. Voxels as boxes, and extremes between
/// them, are exact but for projections of several components and at uneven places, and so are
/// surfaces. Along a spline an extreme is not. Of volumes that overlap any may be.
inline bool IsSampled(const RenderSettings& settings)
{
  if (std::any_of(settings.others.begin(), settings.others.end(), IsSampled))
  {
    return true;
  }
  const bool severalProjected =
    settings.components != Components::One && IsProjection(settings.blend);
  const bool exact = settings.nearest || (IsExtreme(settings.blend) && !settings.cubic);
  return (!exact || severalProjected || settings.uneven) && !IsOfSurfaces(settings.blend);
}

}

#endif
