#ifndef Varimarch_Scene_ProceduralVolume_h
#define Varimarch_Scene_ProceduralVolume_h

#include "Scene/Model/Scene.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace varimarch
{

/// Computes a volume. The same source gives the same voxels with any number of threads. World space
/// is LPS with its origin in the middle of the volume. The extent in mm is fixed: more voxels mean
/// a finer grid, and unequal dimensions mean anisotropic voxels.
///
/// - Shells: uint8, 100 mm cube. Five nested shells of 5 mm with values 240, 190, ... 40
///   from the inside out, and 0 between and around them.
/// - Marschner-Lobb: float in [0, 1], 100 mm cube: S. Marschner and R. Lobb, "An Evaluation of
///   Reconstruction Filters for Volume Rendering", Proc. IEEE Visualization 1994, p. 102, with
///   f_M = 6 and alpha = 0.25. The paper's 41^3 voxels sample it just finely enough.
/// - Torso: int16 in Hounsfield units, see TorsoPhantom in ProceduralVolume.cxx.
/// - Checkerboard: uint8, 100 mm cube. Voxels are 0 and 255 in turn along each axis, so that the
///   field has kinks at all faces of cells. This and the next are after K. Kim, C. Wittenbrink, A.
///   Pang, "Extended specifications and test data sets for data level comparisons of direct volume
///   rendering algorithms", TVCG 7(4), 2001.
/// - Ramp: float, 100 mm cube. Values rise linearly along x from 0 to 255, and interpolation
///   reproduces them.
///
/// @throws std::invalid_argument if a dimension is outside [2, LargestProceduralSide]
vtkSmartPointer<vtkImageData> ProceduralVolume(const ProceduralSource& source);

}

#endif
