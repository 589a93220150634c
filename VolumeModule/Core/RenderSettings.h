#ifndef Varimarch_Core_RenderSettings_h
#define Varimarch_Core_RenderSettings_h

namespace varimarch
{

/// What lets a ray skip samples.
enum class Acceleration
{
  Off,          ///< every step has the sample distance
  ScalarField,  ///< jumps across blocks where the scalar stays within a tolerance
  OpticalField, ///< jumps across bricks by what the transfer function makes of them
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
};

/// Every choice that changes the shader. Values (a tolerance, a step length) are not here: they
/// are uniforms, and changing them rebuilds nothing.
struct RenderSettings
{
  Blend blend = Blend::Composite;
  Acceleration acceleration = Acceleration::OpticalField;
  bool shading = false;       ///< Blinn-Phong with a head light; composite only
  bool sceneGeometry = false; ///< stop rays at opaque geometry already drawn
};

}

#endif
