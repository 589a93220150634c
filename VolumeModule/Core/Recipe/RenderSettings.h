#ifndef Varimarch_Core_Recipe_RenderSettings_h
#define Varimarch_Core_Recipe_RenderSettings_h

#include <algorithm>
#include <vector>

namespace varimarch
{

/// The rule by which rays skip samples.
enum class Acceleration
{
  Off,            ///< all steps have the sample distance
  CellField,      ///< skips blocks in which the scalar varies by at most a tolerance
  VariationField, ///< steps by the published field of voxels, for comparison
  OpticalField,   ///< skips bricks by the colours and opacities of their values
};

/// True if a field is made of the values alone, without the transfer function.
inline bool IsOfValues(Acceleration acceleration)
{
  return acceleration == Acceleration::CellField || acceleration == Acceleration::VariationField;
}

/// The rule that integrates a composite along a segment of the ray. The number of samples per
/// segment follows from the sample distance, so that the rules compare at equal cost in texture
/// fetches. Materials that depend on more than one value have two rules: Midpoint, and
/// PreIntegrated for all others.
enum class Integration
{
  Midpoint,      ///< constant, with the value in the middle; order 2
  PreIntegrated, ///< values are linear between samples; materials take four parts; order 2
  Simpson,       ///< a parabola of extinction through three samples; order 4 for smooth data
  PublishedSum,  ///< the first sample, repeated, for comparison; order 1
  FirstHit,      ///< a number of samples behind the first opaque one, for comparison
};

/// The blend mode: the way in which samples along a ray become a pixel.
enum class Blend
{
  Composite,        ///< emission and absorption, front to back
  MaximumIntensity, ///< the largest value on the ray, through the transfer function
  MinimumIntensity, ///< the smallest value on the ray, through the transfer function
  AverageIntensity, ///< the mean of opacity times value
  Additive,         ///< the integral of opacity times value
  Isosurface,       ///< surfaces of equal value
  Slice,            ///< a surface through the volume
};

/// True if one value on a ray determines its pixel.
inline bool IsExtreme(Blend blend)
{
  return blend == Blend::MaximumIntensity || blend == Blend::MinimumIntensity;
}

/// Meaning of a volume's components.
enum class Components
{
  One,
  Independent,      ///< two to four materials of a mixture
  LuminanceOpacity, ///< colour and opacity of one material
  Rgba,             ///< red, green, blue and opacity of one material
};

/// True if a ray meets only surfaces, whose positions are computed exactly.
inline bool IsOfSurfaces(Blend blend)
{
  return blend == Blend::Isosurface || blend == Blend::Slice;
}

/// True if a pixel is computed from values along its ray, not from colours.
inline bool IsProjection(Blend blend)
{
  return blend != Blend::Composite && !IsOfSurfaces(blend);
}

/// Arguments of a transfer function.
enum class FunctionOf
{
  Value,
  ValueAndGradient,
  TwoValues,
};

/// Meaning of a mask volume.
enum class Mask
{
  None,
  Binary, ///< limits what is drawn
  Labels, ///< selects a voxel's transfer functions; composites of one component only
};

/// The way to a value between texels of a volume.
enum class Filter
{
  OfDevice, ///< the filter of the graphics device, which may round its weights
  OfTexels, ///< eight texels, with weights as exact as floats
};

/// The processor that marches the rays of an image.
enum class Marcher
{
  Device,    ///< the graphics device, in a shader
  Processor, ///< the CPU, in packets of rays: Core/Packets
};

/// The part of a shader in the march of an image.
enum class ShaderRole
{
  MarchRays,        ///< The shader marches the rays itself.
  WriteLayerDepths, ///< The shader writes where rays enter and leave layers, for the CPU's march.
  ShowMarchedImage, ///< The shader draws the image that the CPU has marched.
  LightPlaces,      ///< The shader traces the lights from places that the CPU has found.
  DimGeometry,      ///< The shader multiplies the framebuffer by factors that the CPU has computed.
};

/// The work of one drawing on the rays of an image.
enum class RayPass
{
  Whole,    ///< marches rays through the whole volume
  Block,    ///< continues rays through one of several blocks, where the blocks in front ended them
  Picture,  ///< computes pixels from rays that have passed all blocks
  Upscaled, ///< computes pixels from fewer rays than pixels
  Averaged, ///< computes pixels from more rays than pixels
  Accumulated,     ///< computes pixels from several images that have been added up
  PeelOutside,     ///< marches rays in front of all translucent geometry and behind it
  PeelBetween,     ///< marches rays between two pairs of layers of translucent geometry
  PeelLast,        ///< marches rays between the innermost layers of translucent geometry
  PickProp,        ///< writes the selector's ID of the volume
  PickVoxel,       ///< writes the ID of the point or cell at which a ray becomes visible
  PictureAndDepth, ///< marches rays and also writes a depth
};

/// True if translucent geometry divides the rays.
inline bool Peels(RayPass pass)
{
  return pass == RayPass::PeelOutside || pass == RayPass::PeelBetween || pass == RayPass::PeelLast;
}

/// True if no drawing of the same image precedes.
inline bool BeginsPicture(RayPass pass)
{
  return pass != RayPass::PeelBetween && pass != RayPass::PeelLast;
}

/// True if the drawing writes an ID for a selector.
inline bool Picks(RayPass pass)
{
  return pass == RayPass::PickProp || pass == RayPass::PickVoxel;
}

/// True if the drawing needs a position on the ray.
inline bool Locates(RayPass pass)
{
  return pass == RayPass::PickVoxel || pass == RayPass::PictureAndDepth;
}

/// All choices that change the shader. Numbers, such as a tolerance or a step length, are uniforms
/// instead, and changing them rebuilds nothing.
struct RenderSettings
{
  Blend blend = Blend::Composite;
  Acceleration acceleration = Acceleration::OpticalField;
  bool shading = false;       ///< Blinn-Phong; composite and surfaces only
  bool sceneGeometry = false; ///< rays end at opaque geometry that is already drawn
  Integration integration = Integration::Midpoint; ///< for composites
  bool nearest = false;                            ///< voxels are boxes of constant value
  bool cubic = false; ///< values are those of a spline through the voxels; requires !nearest
  Filter filter = Filter::OfDevice; ///< the way to values between texels; OfDevice if nearest
  bool uneven = false;              ///< voxels are unevenly spaced
  bool clipping = false;            ///< rays end at clipping planes
  bool cropping = false;            ///< regions of the volume are left out
  bool clippedGradients = false;    ///< gradients treat cuts as surfaces; one component only
  bool gaps = false;                ///< cells that touch a non-finite voxel are left out
  bool fillGaps = false;     ///< with gaps: these cells have a colour instead; composite only
  bool countFetches = false; ///< draw the number of fetches of each ray instead of its colour
  bool skipsBricks = true;   ///< composites with an optical field: enough bricks can be skipped
  RayPass pass = RayPass::Whole;
  ShaderRole role = ShaderRole::MarchRays;
  bool damping = false;    ///< shading fades where the gradient is small; one component only
  bool lights = false;     ///< all lights of the scene, not only a head light
  bool shadows = false;    ///< these lights cast shadows; requires lights; composites only
  bool softLights = false; ///< some of these lights are as wide as cones; with shadows only
  bool casters = false;    ///< opaque geometry casts shadows too; with shadows only
  bool scattering = false; ///< matter scatters light; requires lights; composites only
  bool occlusion = false;  ///< ambient occlusion; composites only
  Mask mask = Mask::None;
  bool labelSurfaces =
    false; ///< labels are surfaces of their own; labels with shading or occlusion
  FunctionOf functionOf = FunctionOf::Value; ///< other than Value: composites of one component only
  Components components = Components::One;
  int componentCount = 1;       ///< number of the volume's components
  bool gradientOpacity = false; ///< opacity depends on the gradient; composite only
  bool storedGradients = false; ///< gradients are in a texture; one component only
  bool triesRays = false;       ///< trial images of some of the rays find the steps
  bool jitter = false;          ///< rays begin with a fraction of a step
  bool windowLevel = false;     ///< colours of the image are scaled
  bool limitsSpan =
    false; ///< rays begin at a distance from the eye, or end after a number of steps
  /// Averages of one component with linear interpolation, evenly spaced: only values in a range
  /// count.
  bool limitsMean = false;
  bool fromBehind = false;    ///< composited from the back; with Acceleration::Off
  bool overlaps = false;      ///< drawn together with other volumes; composite only
  bool shadowsOthers = false; ///< with overlaps: light of any of the volumes comes through this one
  bool occludesOthers = false; ///< with overlaps: any of the volumes has ambient occlusion
  std::vector<RenderSettings> others = {}; ///< settings of the other volumes, if this is the first
};

/// True if the shader samples the volume.
inline bool Marches(const RenderSettings& settings)
{
  const RayPass pass = settings.pass;
  return settings.role == ShaderRole::MarchRays && pass != RayPass::Picture &&
    pass != RayPass::Upscaled && pass != RayPass::Averaged && pass != RayPass::Accumulated;
}

/// True if rays to lights go through the volume.
inline bool IsInWayOfLights(const RenderSettings& settings)
{
  return settings.shadows || settings.shadowsOthers;
}

/// True if rays to all sides go through the volume.
inline bool IsInWayOfSky(const RenderSettings& settings)
{
  return settings.occlusion || settings.occludesOthers;
}

/// True if the image depends on the sample distance. Voxels as boxes, extremes of linear
/// interpolation, and surfaces are exact instead. Projections of several components, uneven spacing
/// and extremes of a spline are sampled. For overlapping volumes, true if any of them is sampled.
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
