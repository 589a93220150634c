#ifndef Varimarch_Scene_ProceduralVolume_h
#define Varimarch_Scene_ProceduralVolume_h

#include "Scene/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// Computes a volume; the same source gives the same voxels with any number of threads. World
/// space is LPS with its origin in the middle of the volume. The extent in mm is fixed, so that
/// more voxels mean a finer grid, and unequal dimensions an anisotropic one.
///
/// - Shells: uint8, 100 mm cube. Five nested shells of 5 mm with values 240, 190, ... 40
///   from the inside out, and 0 between and around them.
/// - Marschner-Lobb: float in [0, 1], 100 mm cube: S. Marschner and R. Lobb, "An Evaluation of
///   Reconstruction Filters for Volume Rendering", Proc. IEEE Visualization 1994, p. 102, with
///   f_M = 6 and alpha = 0.25. At the paper's 41^3 it is just sampled finely enough.
/// - Torso: int16 in Hounsfield units, see TorsoPhantom.h.
///
/// @throws std::invalid_argument when a dimension is not from 2 to LargestProceduralSide
vtkSmartPointer<vtkImageData> ProceduralVolume(const ProceduralSource& source);

}

#endif
