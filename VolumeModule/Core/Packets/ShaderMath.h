#ifndef Varimarch_Core_Packets_ShaderMath_h
#define Varimarch_Core_Packets_ShaderMath_h

// The formulas of Shaders/Math, compiled for lanes: each type and function of GLSL becomes that of
// lanes. Only formulas whose loops end for each ray by itself are written once more, in lanes.

#include "Core/Packets/LaneVectors.h"

namespace varimarch
{

namespace
{

// Each unit that includes this uses some of the formulas.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

/// The part of light absorbed over an optical depth: 1 - exp(-depth), without cancellation. GLSL
/// has no 2^f - 1, so Shaders/Math/Absorption.glsl takes a series; for lanes this costs less, and
/// each sample needs it. Beyond a depth of 100 a float has no transmittance left.
inline Lanes Absorption(Lanes depth)
{
  const PowerOfTwo power(-1.442695041f * Min(depth, 100.0f)); // 1 - 2^i - 2^i (2^f - 1)
  return (1.0f - power.whole) - power.whole * power.partLessOne;
}

#define float Lanes
#define vec2 Lanes2
#define vec3 Lanes3
#define vec4 Lanes4
#define abs Abs
#define clamp Clamp
#define cross Cross
#define dot Dot
#define exp Exp
#define floor Floor
#define inversesqrt InverseSqrt
#define length Length
#define lessThanEqual LessThanEqual
#define log Log
#define max Max
#define min Min
#define mix Mix
#define pow Power
#define sqrt Sqrt
#define step Step
// clang-format off
#include "Shaders/Math/IntersectBox.glsl"
#include "Shaders/Math/LatticeWalk.glsl"
#include "Shaders/Math/BlinnPhong.glsl"
#include "Shaders/Math/CellCubic.glsl"
#include "Shaders/Math/CubicSpline.glsl"
#include "Shaders/Math/Gradients.glsl"
#include "Shaders/Math/HenyeyGreenstein.glsl"
#include "Shaders/Math/LightCone.glsl"
#include "Shaders/Math/OpenSky.glsl"
#include "Shaders/Math/Planes.glsl"
#include "Shaders/Math/PreIntegration.glsl"
#include "Shaders/Math/RayTriangle.glsl"
#include "Shaders/Math/ShadowSteps.glsl"
#include "Shaders/Math/Span.glsl"
#include "Shaders/Math/Tables.glsl"
#include "Shaders/Math/UnevenPlace.glsl"
#include "Shaders/Math/Extinction.glsl"
#include "Shaders/Math/LabelMixture.glsl"
// clang-format on
#undef float
#undef vec2
#undef vec3
#undef vec4
#undef abs
#undef clamp
#undef cross
#undef dot
#undef exp
#undef floor
#undef inversesqrt
#undef length
#undef lessThanEqual
#undef log
#undef max
#undef min
#undef mix
#undef pow
#undef sqrt
#undef step

#pragma GCC diagnostic pop

}

}

#endif
