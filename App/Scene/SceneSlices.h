#ifndef Varimarch_Scene_SceneSlices_h
#define Varimarch_Scene_SceneSlices_h

#include "Scene/SliceAxes.h"

#include <array>
#include <optional>

namespace varimarch
{

/// How the slices of a slab combine into one image.
enum class SlabBlend
{
  Maximum,
  Minimum,
  Mean,
};

/// How slices show the volumes over the first one.
enum class SliceFusion
{
  Blend,        ///< mixed with the first volume
  Checkerboard, ///< in every other square
};

/// The viewer's slices through the volume, along the patient's axes or turned about the crosshair.
struct SliceSettings
{
  std::optional<std::array<double, 3>>
    crosshairMm; ///< world space, LPS; empty: the middle of the volume
  std::optional<std::array<double, 2>>
    windowLevel;       ///< units of the data; empty: of the file, otherwise of the histogram
  double slabMm = 0.0; ///< >= 0; 0: a single slice
  SlabBlend slabBlend = SlabBlend::Maximum;
  SliceFusion fusion = SliceFusion::Blend;
  double fusionOpacity = 0.5; ///< part of the volumes over the first one in a blend, [0, 1]
  SliceTurn turn = {};
  /// Turns the lines across a curve about it, in the view that straightens the volume along it.
  double curveTurnDegrees = 0.0;
};

}

#endif
