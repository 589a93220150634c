#ifndef Varimarch_Registration_RigidRegistration_h
#define Varimarch_Registration_RigidRegistration_h

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/VolumeLoading.h"

class vtkImageData;

namespace varimarch
{

/// Finds the placement of a volume where it shares most information with another: Mattes' mutual
/// information, which needs no common units, maximized by gradient descent from coarse to fine, by
/// ITK. It finds the nearest good place, so the start should be right within about 3 cm and 20
/// degrees. The samples that it compares are the same on every run.
/// @param fixed, moving  volumes of one component or more, of which the first counts
/// @param start          where the search begins
/// @param observer       receives the fraction of the work done; returns false to cancel
/// @throws std::runtime_error with one sentence if the volumes do not overlap, or the observer
///         cancelled
Placement RegisteredPlacement(vtkImageData* fixed, vtkImageData* moving, const Placement& start,
  const LoadObserver& observer = {});

}

#endif
